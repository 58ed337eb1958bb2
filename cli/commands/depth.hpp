// SPDX-License-Identifier: GPL-3.0-or-later
// The options and the replies of `depth` and of `width`.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/commands/replies.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/patch.hpp"
#include "reference/text/json.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {

/// The options of depth, and of width without --delta.
struct DepthRequest : BodiesRequest {
  DepthRequest() = default;
  explicit DepthRequest(const Given& given);

  AnswerForm form;
  Method method = Method::automatic;
  bool shallow = false;  ///< use shallow_depth instead of a Method
  std::optional<ClosestLines> closest_lines;
  std::uint64_t seed = 1;
  std::optional<unsigned> bits;  ///< the precision of the bounds of curved bodies
  std::string certificate, svg;  ///< a file, or for a stream a folder; empty: none
};

/// Returns how depths are to be found, by the options of the request.
Question question_of(const DepthRequest& request, Monitor& monitor, Workspace& workspace);

/// Returns the answer to a case, without its certificate. Throws InputError if bodies of these
/// kinds do not have what the request asks for, or if a piece has no interior. A search that is
/// interrupted returns bounds of the depth.
AnsweredCase answered_by(const AskedCase& asked, const DepthRequest& request, const Question& question);

/// Returns replies by the method of the request, with certificates if it asks for them. `request`
/// must outlive the replies. Throws InputError if the certificates cannot be written to the path
/// given.
Replies exact_replies(const DepthRequest& request);

// Input   two convex bodies, and a motion of A.
// Output  their signed depth at equal steps of the motion: exact, or enclosed. As JSON
//         (along.schema.json) and as a chart; `depth --along` prints it, pages show it.

/// The motion of the bodies for s from 0 to 1: a point p of a body is at R p + s v, where R is the
/// rotation of the quaternion (1, s w / 2). So the bodies stay rigid, their positions are rational
/// for rational s, and their velocities at s = 0 are those of the twists.
struct Path {
  std::string id;
  Motion motion;
  std::uint32_t steps;
  unsigned dimension = 3;  ///< 2 of bodies of the plane
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
