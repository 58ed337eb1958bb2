// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two convex bodies, and a motion of A.
// Output  their signed depth where A stands at equal steps of it: exact, or enclosed. As JSON
//         (along.schema.json) and as a chart; `depth --along` prints it, pages show it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/commands/depth.hpp"
#include "fathom/patch.hpp"
#include "reference/text/json.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {

/// How the bodies move, for s from 0 to 1: a point p of one is at R p + s v, where R is the
/// rotation of the quaternion (1, s w / 2). They stay as they are, their places are rational, and
/// their first velocities are those of the twists.
struct Path {
  std::string id;
  Motion motion;
  std::uint32_t steps;
};

/// What is known when the bodies stand at one place of the path.
struct AlongStep {
  std::uint32_t number;
  mpq_class share;                      ///< s: of the motion that was made
  std::optional<Status> status;         ///< nullopt if bounds leave it open
  std::variant<Surd, Bounds> value;     ///< the signed depth, exact or enclosed
  double low, high;                     ///< rounded outward
  Vector direction;                     ///< in which the least h(u)/|u| is reached, or at most the upper bound
  std::optional<Contact> contact = {};  ///< as `depth` has it
};

/// Returns what is known at each place of the path, and calls `known` with each as soon as it is.
/// Throws InputError as require_depth does, Interrupted if the monitor stops it.
std::vector<AlongStep> walked(const Case& pair, const Path& path, const DepthRequest& request, Monitor& monitor,
                              const std::function<void(const AlongStep&)>& known = {});

/// One object.
Json along_object(const Path& path, const std::vector<AlongStep>& steps);

/// The chart of the steps; with a slope, the tangent at s = 0 too. `prefix` begins its ids, and
/// `motion` says how A moves.
plot::Figure along_figure(const std::vector<AlongStep>& steps, const std::string& prefix, const std::string& title,
                          const std::string& motion, std::optional<double> slope = std::nullopt);

}  // namespace fathom::cli
