// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two convex bodies, and a motion of A.
// Output  their signed depth at equal steps of the motion: exact, or enclosed. As JSON
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

/// The motion of the bodies for s from 0 to 1: a point p of a body is at R p + s v, where R is the
/// rotation of the quaternion (1, s w / 2). So the bodies stay rigid, their positions are rational
/// for rational s, and their velocities at s = 0 are those of the twists.
struct Path {
  std::string id;
  Motion motion;
  std::uint32_t steps;
};

/// The answer at one step of the path.
struct AlongStep {
  std::uint32_t number;
  mpq_class share;                      ///< s: the part of the motion that was made
  std::optional<Status> status;         ///< nullopt if the bounds allow more than one
  std::variant<Surd, Bounds> value;     ///< the signed depth, exact or enclosed
  double low, high;                     ///< bounds of the value, rounded outward
  Vector direction;                     ///< where h(u)/|u| is least, or at most the upper bound
  std::optional<Contact> contact = {};  ///< as `depth` reports it
};

/// Returns the answers at all steps of the path, and calls `known` with each as soon as it is
/// computed. Throws InputError as require_depth does, Interrupted if the monitor stops it.
std::vector<AlongStep> walked(const Case& pair, const Path& path, const DepthRequest& request, Monitor& monitor,
                              const std::function<void(const AlongStep&)>& known = {});

/// Returns the path and its steps as one object.
Json along_object(const Path& path, const std::vector<AlongStep>& steps);

/// Returns the chart of the steps; with a slope, also the tangent at s = 0. `prefix` begins its
/// ids, and `motion` describes the motion of A.
plot::Figure along_figure(const std::vector<AlongStep>& steps, const std::string& prefix, const std::string& title,
                          const std::string& motion, std::optional<double> slope = std::nullopt);

}  // namespace fathom::cli
