// SPDX-License-Identifier: GPL-3.0-or-later
// Where an expanding polytope starts. Each point is searched in a direction u from the hull of the points before it to O, then in -u. If
// neither leads out of that hull, P lies in a plane orthogonal to u.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>

#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::expanding {

/// Finds four differences that do not lie in one plane, in directions that lead towards O.
template <class Differences>
class Start {
 public:
  using Integer = typename Differences::Integer;
  using Direction = Vec3<Integer>;

  explicit Start(Differences& differences) : differences_(differences) {}

  /// Returns nullopt if P is flat. Exact.
  std::optional<std::array<polytope::Difference, 4>> run() {
    const Direction some = differences_[{0, 0}];
    const polytope::Difference first = differences_.extreme(is_zero(some) ? axis(0, 1) : -some);
    const Direction p = differences_[first];
    const auto second = first_beyond(p, {-p, axis(0, 1), axis(0, -1)});
    if (!second) return std::nullopt;
    const Direction line = differences_[*second] - p;
    Direction out = cross(cross(p, line), line);  // from the line to O
    if (is_zero(out)) out = some_normal(line);
    const auto third = first_beyond(p, {out, -out});
    if (!third) return std::nullopt;
    const Direction normal = cross(line, differences_[*third] - p);
    const bool towards = sgn(dot(normal, p)) <= 0;
    const auto fourth = first_beyond(p, {towards ? normal : -normal, towards ? -normal : normal});
    if (!fourth) return std::nullopt;
    return std::array{first, *second, *third, *fourth};
  }

 private:
  static Direction axis(int k, long sign) { return {Integer(k == 0 ? sign : 0), Integer(k == 1 ? sign : 0), Integer(k == 2 ? sign : 0)}; }

  // The first extreme difference, over `directions`, that lies farther in its direction than `from`.
  std::optional<polytope::Difference> first_beyond(const Direction& from, std::initializer_list<Direction> directions) {
    for (const Direction& u : directions) {
      if (is_zero(u)) continue;
      const polytope::Difference d = differences_.extreme(u);
      if (cmp(Integer(dot(u, differences_[d])), Integer(dot(u, from))) > 0) return d;
    }
    return std::nullopt;
  }

  static Direction some_normal(const Direction& line) {
    for (int k = 0; k < 3; ++k) {
      const Direction n = cross(line, axis(k, 1));
      if (!is_zero(n)) return n;
    }
    return {};
  }

  Differences& differences_;
};

/// Returns four differences that do not lie in one plane, found in directions that lead towards O, or nullopt if P is flat. Exact.
template <class Differences>
std::optional<std::array<polytope::Difference, 4>> starting_tetrahedron(Differences& differences) {
  return Start<Differences>(differences).run();
}

}  // namespace fathom::expanding
