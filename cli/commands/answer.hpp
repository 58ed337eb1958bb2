// SPDX-License-Identifier: GPL-3.0-or-later
// The answer to one case, before it is printed as text or as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/args/request.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/progress.hpp"
#include "fathom/depth.hpp"

namespace fathom::cli {

/// What an approximate answer adds: `bound` <= the true value <= the depth that is printed.
struct Approximation {
  mpq_class delta;
  std::uint64_t rays = 0;
  mpq_class bound_squared;
};

struct Answer {
  std::string id;
  Depth depth;                   ///< for `width`: of the body against itself
  std::string certificate = {};  ///< as text, if one was asked for
  std::optional<Approximation> approximation = std::nullopt;
};

/// Answers with the method of the request, and with a certificate if it asks for one. The answering throws Interrupted if the user asks to
/// stop. `request` must outlive it.
Answering answer_by(const Request& request, Solve solve);

}  // namespace fathom::cli
