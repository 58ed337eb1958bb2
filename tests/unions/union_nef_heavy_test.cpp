// SPDX-License-Identifier: GPL-3.0-or-later
// An oracle that shares nothing with the search: W, the translations for which interiors meet, as a
// Nef polyhedron of CGAL, the union of the interiors of B_j (+) -A_i. The depth is the distance
// from O to its complement, which is closed, so that seams in which W has holes of no volume count:
// an exact fit is one. An optimum has clearance if it is a limit of points outside the closure of
// W.
#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "tests/unions/naive_union.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/families/families.hpp"

namespace fathom::unions {
namespace {

using Kernel = CGAL::Cartesian<CGAL::Gmpq>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Place = std::tuple<mpq_class, mpq_class, mpq_class>;

CGAL::Gmpq number(const mpq_class& q) { return CGAL::Gmpq(q.get_mpq_t()); }
mpq_class number(const CGAL::Gmpq& q) { return mpq_class(q.mpq()); }

Nef interior_of_difference(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Kernel::Point_3> points;
  for (const Point& p : a)
    for (const Point& q : b) points.emplace_back(number(q.x - p.x), number(q.y - p.y), number(q.z - p.z));
  Polyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return Nef(hull).interior();
}

struct NefAnswer {
  mpq_class squared = 0;
  std::set<Place> optima, with_clearance;
};

bool holds(const Nef& set, const Kernel::Point_3& p) {
  const CGAL::Object_handle place = set.locate(p);
  Nef::Vertex_const_handle vertex;
  Nef::Halfedge_const_handle edge;
  Nef::Halffacet_const_handle facet;
  Nef::Volume_const_handle volume;
  if (CGAL::assign(vertex, place)) return vertex->mark();
  if (CGAL::assign(edge, place)) return edge->mark();
  if (CGAL::assign(facet, place)) return facet->mark();
  return CGAL::assign(volume, place) && volume->mark();
}

/// Of the boundary of W every vertex, and the foot of O on the line of every edge and on the plane
/// of every facet.
std::vector<Kernel::Point_3> candidates(const Nef& w) {
  std::vector<Kernel::Point_3> result;
  const Kernel::Point_3 o(0, 0, 0);
  for (auto v = w.vertices_begin(); v != w.vertices_end(); ++v) result.push_back(v->point());
  for (auto e = w.halfedges_begin(); e != w.halfedges_end(); ++e)
    if (e->is_twin())
      result.push_back(Kernel::Line_3(e->source()->point(), e->twin()->source()->point()).projection(o));
  for (auto f = w.halffacets_begin(); f != w.halffacets_end(); ++f)
    if (f->is_twin()) result.push_back(f->plane().projection(o));
  return result;
}

NefAnswer nef_answer(const Pieces& a, const Pieces& b) {
  Nef w(Nef::EMPTY);
  for (const std::vector<Point>& p : a)
    for (const std::vector<Point>& q : b) w += interior_of_difference(p, q);
  const Kernel::Point_3 o(0, 0, 0);
  NefAnswer answer;
  if (!holds(w, o)) return answer;
  const Nef room = w.closure().complement().closure();
  std::optional<CGAL::Gmpq> best;
  for (const Kernel::Point_3& p : candidates(w)) {
    const CGAL::Gmpq squared = CGAL::squared_distance(o, p);
    if ((best && *best < squared) || holds(w, p)) continue;
    if (!best || squared < *best) answer.optima.clear(), answer.with_clearance.clear();
    best = squared;
    const Place place{number(p.x()), number(p.y()), number(p.z())};
    answer.optima.insert(place);
    if (holds(room, p)) answer.with_clearance.insert(place);
  }
  answer.squared = number(best.value());
  return answer;
}

struct Seen {
  std::size_t penetrating = 0, fits = 0, between = 0;
};

void expect_nef(const Pieces& a, const Pieces& b, Seen& seen) {
  const UnionDepth depth = union_depth(a, b);
  const NefAnswer nef = nef_answer(a, b);
  EXPECT_EQ(depth.squared(), nef.squared);
  if (depth.status != Status::penetrating) return;
  EXPECT_EQ(places(depth), nef.optima);
  std::set<Place> with_clearance;
  for (const UnionOptimum& optimum : depth.optima)
    if (optimum.clearance) with_clearance.emplace(optimum.translation.x, optimum.translation.y, optimum.translation.z);
  EXPECT_EQ(with_clearance, nef.with_clearance);
  ++seen.penetrating;
  seen.fits += with_clearance.size() < depth.optima.size();
  seen.between += depth.bounds->deepest_pair < depth.squared() && depth.squared() < depth.bounds->hulls;
}

TEST(UnionNef, TheCatalogue) {
  Seen seen;
  for (const families::UnionCatalogueEntry& entry : families::union_catalogue()) {
    const Pieces &a = *entry.pair.a.pieces, &b = *entry.pair.b.pieces;
    if (a.size() * b.size() > 30) continue;
    SCOPED_TRACE(entry.pair.id);
    expect_nef(a, b, seen);
  }
  EXPECT_GE(seen.fits, 4U);
}

TEST(UnionNef, RandomBoxesAndHulls) {
  Seen seen;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool boxes = seed % 2 == 0;
    const Pieces a = boxes ? random_boxes(random, 1 + seed % 3, 5) : random_pieces(random, 1 + seed % 3, 4, 5, 2);
    const Pieces b = boxes ? random_boxes(random, 1 + seed % 4, 5) : random_pieces(random, 1 + seed % 2, 5, 5, 2);
    expect_nef(a, b, seen);
  }
  EXPECT_GT(seen.penetrating, 25U);
  EXPECT_GT(seen.between, 5U);
}

TEST(UnionNef, TheFamilies) {
  Seen seen;
  for (const families::Family& family : families::families(families::Kind::unions)) {
    if (family.name == "clusters") continue;  // hulls of 20 points each take CGAL long
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const Case pair = family.make(seed, 2);
      if (pair.a.pieces->size() * pair.b.pieces->size() > 30) continue;
      SCOPED_TRACE(pair.id);
      expect_nef(*pair.a.pieces, *pair.b.pieces, seen);
    }
  }
  EXPECT_GT(seen.penetrating, 10U);
  EXPECT_GT(seen.fits, 1U);
}

}  // namespace
}  // namespace fathom::unions
