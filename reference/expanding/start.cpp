// SPDX-License-Identifier: GPL-3.0-or-later
// Each point is searched in a direction u from the hull of the points before it to O, then in -u. If neither leads out of that hull, P lies
// in a plane orthogonal to u.
#include "reference/expanding/start.hpp"

#include <vector>

namespace fathom::expanding {
namespace {

const Vector axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// The first extreme difference, over `directions`, that lies farther in its direction than `from`.
std::optional<polytope::Difference> first_beyond(polytope::Differences& differences, const Vector& from,
                                                 const std::vector<Vector>& directions) {
  for (const Vector& u : directions) {
    if (is_zero(u)) continue;
    const polytope::Difference d = differences.extreme(u);
    if (dot(u, differences[d]) > dot(u, from)) return d;
  }
  return std::nullopt;
}

Vector some_normal(const Vector& line) {
  for (const Vector& axis : axes) {
    const Vector n = cross(line, axis);
    if (!is_zero(n)) return n;
  }
  return {};
}

}  // namespace

std::optional<std::array<polytope::Difference, 4>> starting_tetrahedron(polytope::Differences& differences) {
  const Vector some = differences[{0, 0}];
  const polytope::Difference first = differences.extreme(is_zero(some) ? axes[0] : -some);
  const Vector p = differences[first];
  const auto second = first_beyond(differences, p, {-p, axes[0], -axes[0]});
  if (!second) return std::nullopt;
  const Vector line = differences[*second] - p;
  Vector out = cross(cross(p, line), line);  // from the line to O
  if (is_zero(out)) out = some_normal(line);
  const auto third = first_beyond(differences, p, {out, -out});
  if (!third) return std::nullopt;
  const Vector normal = cross(line, differences[*third] - p);
  const auto fourth = first_beyond(differences, p, dot(normal, p) > 0 ? std::vector{-normal, normal} : std::vector{normal, -normal});
  if (!fourth) return std::nullopt;
  return std::array{first, *second, *third, *fourth};
}

}  // namespace fathom::expanding
