// SPDX-License-Identifier: GPL-3.0-or-later
// A case that is to be answered, and what is known of its bodies before.
#pragma once

#include "fathom/files.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {

struct AskedCase {
  const Case& input;
  output::AboutBodies bodies;

  AskedCase(const Case& asked, bool one_body) : input(asked), bodies(output::about_bodies(asked, one_body)) {}
  operator const Case&() const { return input; }  // NOLINT(google-explicit-constructor): most commands need no more
};

}  // namespace fathom::cli
