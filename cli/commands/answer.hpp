// SPDX-License-Identifier: GPL-3.0-or-later
// One solved case, on its way to a page or to a JSON line.
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

/// What an answer adds that is right up to a factor: `bound` <= the true value <= the depth that is told.
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

/// Answers with the method that was asked for, and with a certificate if one was. The answering throws Interrupted when the user has asked
/// to stop. `request` must outlive it.
Answering answer_by(const Request& request, Solve solve);

}  // namespace fathom::cli
