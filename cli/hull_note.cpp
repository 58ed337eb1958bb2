// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hull_note.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <vector>

#include "cli/output.hpp"
#include "kernels/all_extreme.hpp"
#include "kernels/parallel.hpp"
#include "reference/polytope/hull_hash.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t worth_a_thread = 2048;  // points

/// How many points are not extreme.
std::size_t inner_points(const std::vector<Point>& points) {
  if (all_seen_extreme(points)) return 0;
  const Lattice lattice = common_lattice(points, std::span(points).first(1));
  const Polytope hull = convex_hull(lattice.a);
  DistinctPoints extreme = no_points_yet(lattice.a, hull.input_ids.size());
  extreme.insert(hull.input_ids.begin(), hull.input_ids.end());
  std::size_t inner = 0;
  for (std::uint32_t i = 0; i < lattice.a.size(); ++i) inner += !extreme.contains(i);
  return inner;
}

}  // namespace

std::optional<std::string> hull_note(const Case& input, bool one_body) {
  const std::vector<Point>&a = input.a.points, &b = input.b.points;
  std::size_t inner_a = 0, inner_b = 0;
  run_both(
      !one_body && a.size() + b.size() >= worth_a_thread, [&] { inner_a = inner_points(a); },
      [&] { inner_b = one_body ? 0 : inner_points(b); });
  std::vector<std::string> notes;
  if (inner_a > 0) notes.push_back(fmt::format("A: {} of {} points are not extreme", inner_a, a.size()));
  if (inner_b > 0) notes.push_back(fmt::format("B: {} of {} points are not extreme", inner_b, b.size()));
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
