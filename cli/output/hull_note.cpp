// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

#include "cli/io/case_stream.hpp"
#include "cli/io/output.hpp"
#include "kernels/filters/all_extreme.hpp"
#include "kernels/parallel.hpp"
#include "reference/polytope/convexity.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t worth_a_thread = 2048;  // points

/// What there is to say of the points of a body; empty if all are extreme.
std::string note_on(char body, const std::vector<Point>& points) {
  const std::optional<std::size_t> inner = polytope::count_inner_points(points);
  if (!inner) return fmt::format("{}: it was not tried whether all points are extreme, as their denominators share little", body);
  return *inner > 0 ? fmt::format("{}: {} of {} points are not extreme", body, *inner, points.size()) : "";
}

}  // namespace

bool may_have_inner_points(const Case& input, bool one_body) {
  const auto all_extreme = [](const GivenPoints& points) {
    return points.in_binary64() ? kernels::all_seen_extreme(points.binary64()) : kernels::all_seen_extreme(points.exact());
  };
  return !all_extreme(input.a.points) || (!one_body && !all_extreme(input.b.points));
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
