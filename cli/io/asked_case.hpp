// SPDX-License-Identifier: GPL-3.0-or-later
// A case that is to be answered, and what is known of its bodies before.
#pragma once

#include "cli/output/about_bodies.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

struct AskedCase {
  const Case& input;
  AboutBodies bodies;

  AskedCase(const Case& asked, bool one_body) : input(asked), bodies(about_bodies(asked, one_body)) {}
  operator const Case&() const { return input; }  // NOLINT(google-explicit-constructor): most commands need no more
};

}  // namespace fathom::cli
