// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/hull_note.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <vector>

#include "cli/io/output.hpp"
#include "kernels/filters/all_extreme.hpp"
#include "kernels/parallel.hpp"
#include "reference/polytope/hull_hash.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t worth_a_thread = 2048;  // points

/// What there is to say of the points of a body; empty if all are extreme.
std::string note_on(char body, const std::vector<Point>& points) {
  if (kernels::all_seen_extreme(points)) return "";
  const std::optional<polytope::PlacedPair> placed = polytope::place_if_slim(points, std::span(points).first(1));
  if (!placed) return fmt::format("{}: it was not tried whether all points are extreme, as their denominators share little", body);
  const std::vector<Vector>& integers = placed->a.points();
  const polytope::Polytope hull = polytope::convex_hull(integers);
  polytope::DistinctPoints extreme = polytope::no_points_yet(integers, hull.input_ids.size());
  extreme.insert(hull.input_ids.begin(), hull.input_ids.end());
  std::size_t inner = 0;
  for (std::uint32_t i = 0; i < integers.size(); ++i) inner += !extreme.contains(i);
  return inner > 0 ? fmt::format("{}: {} of {} points are not extreme", body, inner, points.size()) : "";
}

}  // namespace

bool may_have_inner_points(const Case& input, bool one_body) {
  return !kernels::all_seen_extreme(input.a.points) || (!one_body && !kernels::all_seen_extreme(input.b.points));
}

std::optional<std::string> hull_note(const Case& input, bool one_body) {
  const std::vector<Point>&a = input.a.points, &b = input.b.points;
  std::vector<std::string> notes(2);
  kernels::Context context;
  kernels::run_both(
      !one_body && a.size() + b.size() >= worth_a_thread, context, [&](kernels::Context&) { notes[0] = note_on('A', a); },
      [&](kernels::Context&) { notes[1] = one_body ? "" : note_on('B', b); });
  std::erase(notes, "");
  if (notes.empty()) return std::nullopt;
  return fmt::format("{}; the convex hull is taken", fmt::join(notes, "; "));
}

void tell_of_hulls(const Case& input, bool one_body, Progress& progress) {
  progress.report("looking for dents", -1);
  const std::optional<std::string> note = hull_note(input, one_body);
  progress.clear();
  if (note) talk(*note);
}

}  // namespace fathom::cli
