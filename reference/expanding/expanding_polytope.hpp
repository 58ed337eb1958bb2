// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two point clouds.
// Output  the facets of P nearest to O, found and proved by a polytope Q that grows inside P
//         towards them; no hull, no decomposition. In engines this search is known as EPA, the
//         expanding polytope algorithm (van den Bergen 2001); here binary64 guesses which point
//         comes next and integers decide.                                     [proofs/expanding.md]
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/messages.hpp"
#include "kernels/nearest.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::expanding {

/// A budget without a limit on the points that are added to Q.
inline constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

enum class ExpansionEnd {
  proved,      ///< Q holds the requested ball
  not_inside,  ///< O is not in the interior of P
  spent        ///< the budget is used up
};

struct Expansion {
  ExpansionEnd end = ExpansionEnd::spent;
  /// proved: the directions of all facets of P nearest to O, with their squared distance. Exact.
  kernels::NearestPlanes nearest;
  /// proved: Q, with one facet in the plane of each nearest facet of P, and all others strictly
  /// farther from O.
  InnerPolytope inner;
  /// not_inside: whether O is known to be outside P.
  bool outside = false;
  std::size_t points = 0;  ///< added to Q beyond the first four
  /// How often it was asked on which side of a triangle a point lies, and how often binary64 could
  /// not tell.
  std::uint64_t sides = 0, sides_exact = 0;
  /// In lazy integers: how many had to be computed.
  std::uint64_t computed = 0;
};

/// The clouds must be non-empty and have the same exponent, on all axes. Always ends: gives up if Q
/// would need more than `budget` points. `workspace` may be null; with one, nothing is allocated on
/// a narrow lattice but the result, once it has grown. Throws Interrupted.
Expansion nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                               std::size_t budget = unlimited, Workspace* workspace = nullptr);
/// The same on a narrow lattice, in each of its integers.
template <class Integer>
Expansion nearest_by_expansion(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair,
                               std::size_t budget = unlimited, Workspace* workspace = nullptr);
/// The same in these integers: those of a fixed size, if they hold all; lazy ones, the way for
/// other lattices; or mpz_class, the naive twin.
template <class Integer>
Expansion nearest_by_expansion_in(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                                  std::size_t budget = unlimited, Workspace* workspace = nullptr);

/// What a search finds that hands out no polytope.
struct WarmExpansion {
  ExpansionEnd end = ExpansionEnd::spent;
  /// proved: the primitive normals of all facets of P nearest to O.
  std::set<Vector, LexicographicOrder> normals;
  bool outside = false;  ///< as of Expansion
};

/// The same facets, by a Q that begins as the hull of the differences in `start`, which are not
/// counted; these become Q's vertices, at most `most_vertices` of them. Indices must be those of
/// points.                                              [proofs/prepared.md]
template <class Integer>
WarmExpansion nearest_from(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair, std::size_t budget,
                           Workspace& workspace, std::vector<polytope::Difference>& start, std::size_t most_vertices);

/// Where O lies, as far as a growing Q shows it.
struct OriginExpansion {
  ExpansionEnd end = ExpansionEnd::spent;  ///< proved: in the interior of P; not_inside: on its boundary, or outside
  /// not_inside: the sign of h(normal). O is outside if it is below 0; 0 leaves that open, as in a
  /// flat P.
  int side = 0;
  Vector normal;     ///< if O is outside and this has been asked for
  mpz_class height;  ///< h(normal) then, in units of the lattice
};

/// Grows Q until O is in its interior or a facet of P shows that it is not in that of P.
template <class Integer>
OriginExpansion locate_origin(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair,
                              Workspace* workspace, bool with_normal);

/// Checks the laws of a proved expansion: Q is convex and closed, its vertices are differences, it
/// is no nearer than the nearest planes, touches them in one facet each, and these support P.
/// Quadratic in the size of Q.
[[nodiscard]] kernels::Report validate(const Expansion& expansion, const kernels::PointCloud& a,
                                       const kernels::PointCloud& b);

/// Checks by definition, and exactly, that `inner` is a closed convex surface with O below each
/// facet, whose vertices are differences of points of a and b: of lattice points or of rational
/// ones. Calls each(n, height) for the plane <n,x> = height of each facet. Quadratic in its size.
template <class Points, class Each>
void check_inner_polytope(kernels::Report& report, const InnerPolytope& inner, const Points& a, const Points& b,
                          Each each) {
  using Place = std::remove_cvref_t<decltype(a[0])>;
  std::vector<Place> vertices;
  for (const auto& [i, j] : inner.vertices) {
    if (!report.expect(i < a.size() && j < b.size(), "a vertex of Q has an index out of range")) return;
    vertices.push_back(b[j] - a[i]);
  }
  for (const std::vector<std::uint32_t>& facet : inner.facets) {
    const bool in_range = std::ranges::all_of(facet, [&](std::uint32_t v) { return v < vertices.size(); });
    if (!report.expect(facet.size() >= 3 && in_range, "a facet of Q is no cycle of its vertices")) return;
  }
  report.expect(inner.facets.size() >= 4, "Q has fewer than four facets");
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::vector<std::uint32_t>& facet : inner.facets) {
    const auto corner = [&](std::size_t k) -> const Place& { return vertices[facet[k % facet.size()]]; };
    const Place n = cross(Place(corner(1) - corner(0)), Place(corner(2) - corner(0)));
    const auto height = dot(n, corner(0));
    report.expect(height > 0, "O is not below a facet of Q");
    std::size_t on_plane = 0;
    for (const Place& v : vertices) {
      const int side = cmp(dot(n, v), height);
      report.expect(side <= 0, "a vertex of Q lies above a facet");
      on_plane += side == 0 ? 1U : 0U;
    }
    report.expect(on_plane == facet.size(), "the corners of a facet of Q are not the vertices on its plane");
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const Place along = corner(k + 1) - corner(k), onward = corner(k + 2) - corner(k + 1);
      report.expect(dot(n, cross(along, onward)) > 0, "the corners of a facet of Q do not turn left");
      report.expect(edges.insert({facet[k], facet[(k + 1) % facet.size()]}).second,
                    "two facets of Q run along an edge in one sense");
    }
    each(n, height);
  }
  for (const auto& [u, v] : edges) report.expect(edges.contains({v, u}), "an edge of Q has a facet on one side only");
}

/// A proof of low <= depth^2 <= high, all in the clouds' unit.
struct BallExpansion {
  ExpansionEnd end = ExpansionEnd::spent;
  bool low_holds = false, high_holds = false;  ///< proved: whether the two bounds are true
  Vector direction;                            ///< if `high` is true: n with h(n)^2 <= high <n,n>
  InnerPolytope inner;                         ///< if `low` is true: holds the ball of squared radius `low`
};

/// Grows Q until it holds the ball of squared radius `low`, and then until a direction shows
/// `high`; `hint`, if given, is tried first.
BallExpansion expand_to_ball(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                             const mpq_class& low, const mpq_class& high,
                             const std::optional<Vector>& hint = std::nullopt, std::size_t budget = unlimited);

/// Requires O in the interior of P, `nearest` = depth^2, and `bound`, a larger squared distance of
/// a facet plane of P. Returns the squared distance of a facet plane, larger than `nearest` and at
/// most `bound`, such that no facet at a distance strictly between holds the foot
/// point of O in its interior. All in the clouds' unit. Throws std::invalid_argument if O is not in
/// the interior of P.  [proofs/gap.md, lemma 2]
std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context, const polytope::PlacedPair& pair,
                                                   const mpq_class& nearest, const mpq_class& bound,
                                                   Workspace& workspace);
/// The same on a narrow lattice, in the workspace that the pair may be a part of. Returns nullopt
/// if `bound` has too many bits for it.
std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context,
                                                   const polytope::PlacedPairIn<polytope::NarrowInteger>& pair,
                                                   const mpq_class& nearest, const mpq_class& bound,
                                                   Workspace& workspace);

}  // namespace fathom::expanding
