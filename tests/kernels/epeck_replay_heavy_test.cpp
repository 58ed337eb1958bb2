// SPDX-License-Identifier: GPL-3.0-or-later
// Every predicate that whole runs ask, over all families and the catalogue, asked again of CGAL's
// kernel of exact predicates and exact constructions: through the functor, and through CGAL's own
// function where there is one. The signs must be the same.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <map>

#include "kernels/filters/plane.hpp"
#include "kernels/predicates/kernels_cgal.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/vertex_facet/vertex_facet.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"

namespace fathom::kernels {
namespace {

struct Question {
  Predicate id;
  bool perturbed;
  Sign answer;
  std::vector<Direction> operands;
};

// While a run is recorded.
std::vector<Question>* recording = nullptr;

template <class... Directions>
Sign recorded(Predicate id, bool perturbed, Sign answer, const Directions&... operands) {
  if (recording != nullptr) recording->push_back({id, perturbed, answer, {operands...}});
  return answer;
}

}  // namespace

// The linker takes these instead of the library's, which do the same except for the recording.
Sign UnperturbedKernel::side_of_equator(const Direction& n, const Direction& z) const {
  return recorded(Predicate::side_of_equator, false, decide<SideOfEquator>(n, z), n, z);
}
Sign PerturbedKernel::side_of_equator(const Direction& n, const Direction& z) const {
  return recorded(Predicate::side_of_equator, true, decide<SideOfEquator>(n, z), n, z);
}
Sign UnperturbedKernel::x_order(const Direction& n1, const Direction& n2, const Direction& v) const {
  return recorded(Predicate::x_order, false, decide<XOrder>(n1, n2, v), n1, n2, v);
}
Sign PerturbedKernel::x_order(const Direction& n1, const Direction& n2, const Direction& v) const {
  return recorded(Predicate::x_order, true, decide<XOrder>(n1, n2, v), n1, n2, v);
}
Sign UnperturbedKernel::side_of_arc(const Direction& n, const Direction& d) const {
  return recorded(Predicate::side_of_arc, false, decide<SideOfArc>(n, d), n, d);
}
Sign PerturbedKernel::side_of_arc(const Direction& n, const Direction& d) const {
  return recorded(Predicate::side_of_arc, true, decide<SideOfArc>(n, d), n, d);
}
Sign UnperturbedKernel::order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n,
                                          const Direction& v) const {
  return recorded(Predicate::order_on_vertical, false, decide<OrderOnVertical>(d1, d2, n, v), d1, d2, n, v);
}
Sign PerturbedKernel::order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n,
                                        const Direction& v) const {
  return recorded(Predicate::order_on_vertical, true, decide<OrderOnVertical>(d1, d2, n, v), d1, d2, n, v);
}
Sign UnperturbedKernel::order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) const {
  return recorded(Predicate::order_at_infinity, false, decide<OrderAtInfinity>(d1, d2, z), d1, d2, z);
}
Sign PerturbedKernel::order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) const {
  return recorded(Predicate::order_at_infinity, true, decide<OrderAtInfinity>(d1, d2, z), d1, d2, z);
}

namespace {

using testing::prepare;
using testing::Prepared;
using K = CGAL::Exact_predicates_exact_constructions_kernel;

K::FT number(const mpz_class& c) {
  if (mpz_sizeinbase(c.get_mpz_t(), 2) <= 53) return c.get_d();
  const mpz_class low = c % (mpz_class(1) << 52), high = (c - low) >> 52;
  return number(high) * 0x1p52 + low.get_d();
}

K::Vector_3 vector(const Vector& v) { return {number(v.x), number(v.y), number(v.z)}; }
K::Point_3 point(const Vector& v) { return {number(v.x), number(v.y), number(v.z)}; }

// The same question to the kernel's functor, and to a function of CGAL.
struct Answers {
  CGAL::Sign functor, cgal;
};

CGAL::Sign sign_of_product(const K::Vector_3& v, const K::Vector_3& w) {
  return CGAL::enum_cast<CGAL::Sign>(CGAL::angle(v, w));
}

Answers ask(Predicate id, const std::vector<K::Vector_3>& w) {
  switch (id) {
    case Predicate::side_of_equator: return {SideOfEquator<K>{}(w[0], w[1]), sign_of_product(w[0], w[1])};
    case Predicate::x_order: return {XOrder<K>{}(w[0], w[1], w[2]), CGAL::orientation(w[0], w[1], w[2])};
    case Predicate::side_of_arc: return {SideOfArc<K>{}(w[0], w[1]), sign_of_product(w[0], w[1])};
    case Predicate::order_on_vertical:
      return {OrderOnVertical<K>{}(w[0], w[1], w[2], w[3]),
              CGAL::orientation(w[0], w[1], CGAL::cross_product(w[3], w[2]))};
    default: return {OrderAtInfinity<K>{}(w[0], w[1], w[2]), CGAL::orientation(w[0], w[1], w[2])};
  }
}

// How many questions were compared, by name of the predicate.
using Counts = std::map<std::string_view, std::size_t>;
constexpr std::array<std::string_view, 8> all_names{"side_of_equator",   "x_order",           "side_of_arc",
                                                    "order_on_vertical", "order_at_infinity", "height_order",
                                                    "projected_turn",    "compare_distance"};

Sign unperturbed(const Question& q) {
  PredicateCounts uncounted;
  const UnperturbedKernel kernel(uncounted);
  const std::vector<Direction>& w = q.operands;
  switch (q.id) {
    case Predicate::side_of_equator: return kernel.side_of_equator(w[0], w[1]);
    case Predicate::x_order: return kernel.x_order(w[0], w[1], w[2]);
    case Predicate::side_of_arc: return kernel.side_of_arc(w[0], w[1]);
    case Predicate::order_on_vertical: return kernel.order_on_vertical(w[0], w[1], w[2], w[3]);
    default: return kernel.order_at_infinity(w[0], w[1], w[2]);
  }
}

void compare(const Question& q, Counts& counts) {
  std::vector<K::Vector_3> operands;
  for (const Direction& d : q.operands) operands.push_back(vector(d.exact()));
  const Answers right = ask(q.id, operands);
  const auto name = predicate_names[static_cast<std::size_t>(q.id)];
  ASSERT_EQ(right.functor, right.cgal) << name;
  ASSERT_EQ(to_int(unperturbed(q)), right.cgal) << name;
  if (!q.perturbed || right.cgal != CGAL::ZERO) {
    ASSERT_EQ(to_int(q.answer), right.cgal) << name;
  }
  if (q.perturbed) {
    ASSERT_NE(q.answer, Sign::zero) << name;
  }
  ++counts[name];
}

// Charts, canonical subsets, closest lines, and the twin that asks for the crossings on the sphere.
// Runs seldom ask for the order on a wall: here it is asked on some walls for some arcs.
void run(Prepared& p) {
  const lines::EdgeLinesOfA a(p.a, p.exponent);
  const lines::EdgeLinesOfB b(p.b, p.exponent);
  NearestPlanes nearest;
  for (const chart::Charts& charts : p.charts) {
    const canonical::CanonicalSubsets subsets = canonical::canonical_subsets(p.context, charts);
    ASSERT_TRUE(canonical::validate(subsets, charts).ok());
    lines::closest_lines(p.context, subsets, lines::LineScene(charts, a, b), nearest);
    for (std::size_t i = 0; i < charts.of.a.arcs.size() * charts.of.b.arcs.size() * charts.walls.size(); i += 101) {
      const auto pick = [i](std::size_t skip, const auto& from) -> const auto& {
        return from.begin()[i / skip % from.size()];
      };
      const std::size_t as = charts.of.a.arcs.size(), bs = charts.of.b.arcs.size();
      std::ignore =
          chart::above_on_wall(testing::kernel_of(charts), charts, gaussian::Colour::a, pick(1, charts.of.a.arcs),
                               gaussian::Colour::b, pick(as, charts.of.b.arcs), pick(as * bs, charts.walls));
    }
  }
  const UnperturbedKernel kernel(p.context.counters.predicates);
  for (const gaussian::Arc& e : p.minus_a.arcs) {
    for (const gaussian::Arc& f : p.of_b.arcs)
      std::ignore = gaussian::strict_crossings(kernel, p.minus_a, e, p.of_b, f);
  }
}

// The hull's questions: every point against the plane of every facet, and seen along each axis.
void compare_sides(const polytope::Polytope& hull, Counts& counts) {
  const BoxedPoints boxed(hull.vertices);
  std::vector<K::Point_3> points;
  for (const Vector& v : hull.vertices) points.push_back(point(v));
  for (const polytope::Facet& facet : hull.facets) {
    const auto corner = [&](std::uint32_t i) { return hull.corners[facet.begin + i].value; };
    const std::uint32_t p = corner(0), q = corner(1), r = corner(2);
    const Plane plane(boxed, p, q, r);
    const K::Vector_3 normal = CGAL::cross_product(points[q] - points[p], points[r] - points[p]);
    for (std::uint32_t s = 0; s < points.size(); ++s) {
      const CGAL::Sign side = CGAL::orientation(points[p], points[q], points[r], points[s]);
      ASSERT_EQ(HeightOrder<K>{}(normal, points[p] - CGAL::ORIGIN, points[s] - CGAL::ORIGIN), side);
      ASSERT_EQ(to_int(plane.side(s)), side);
      ++counts["height_order"];
      for (const int axis : {0, 1, 2}) {
        const auto seen = [&](std::uint32_t i) {
          return K::Point_2(points[i][(axis + 1) % 3], points[i][(axis + 2) % 3]);
        };
        const CGAL::Sign left = CGAL::orientation(seen(p), seen(q), seen(s));
        ASSERT_EQ(
            (ProjectedTurn<K>{axis}(points[p] - CGAL::ORIGIN, points[q] - CGAL::ORIGIN, points[s] - CGAL::ORIGIN)),
            left);
        ASSERT_EQ(to_int(turn(boxed, axis, p, q, s)), left);
        ++counts["projected_turn"];
      }
    }
  }
}

struct OfferedPlane {
  Vector normal;
  mpz_class height;
};

// The order of two planes' distances, as NearestPlanes finds it.
Sign order_of(const OfferedPlane& plane, const OfferedPlane& than) {
  NearestPlanes nearest;
  nearest.offer(than.normal, than.height);
  const bool nearer = nearest.nearer_than(plane.normal, plane.height);
  const mpz_class num = nearest.numerator(), den = nearest.denominator();
  if (!nearest.offer(plane.normal, plane.height)) {
    EXPECT_TRUE(nearer);
    return Sign::positive;
  }
  EXPECT_FALSE(nearer);
  return nearest.numerator() == num && nearest.denominator() == den ? Sign::zero : Sign::negative;
}

// The planes of all vertex-facet pairs, each against some that follow.
void compare_distances(const Prepared& p, Counts& counts) {
  std::vector<OfferedPlane> planes;
  for (const chart::Charts& charts : p.charts) {
    for (const vertex_facet::VertexFacetPair& pair : vertex_facet::vertex_facet_pairs(charts)) {
      const bool of_a = pair.facet_of == gaussian::Colour::a;
      const polytope::Polytope& body = of_a ? p.a : p.b;
      const polytope::VertexId corner = body.corners[body.facets[pair.facet].begin];
      const Vector& n = charts.of[pair.facet_of].node(gaussian::node_of(pair.facet)).exact();
      const mpz_class height =
          dot(n, p.b.vertices[of_a ? pair.vertex : corner] - p.a.vertices[of_a ? corner : pair.vertex]);
      if (height > 0) planes.push_back({n, height});
    }
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i; j < std::min(planes.size(), i + 8); ++j) {
      const auto [n, h] = planes[i];
      const auto [m, g] = planes[j];
      const auto squared = [](const Vector& normal, const mpz_class& height) {
        const K::Vector_3 w = vector(normal);
        return CGAL::squared_distance(K::Plane_3(w.x(), w.y(), w.z(), -number(height)), K::Point_3(CGAL::ORIGIN));
      };
      const CGAL::Sign order = CGAL::compare(squared(n, h), squared(m, g));
      ASSERT_EQ(CompareDistance<K>{}(vector(n), number(h), number(g) * number(g), vector(m).squared_length()), order);
      ASSERT_EQ(to_int(order_of(planes[i], planes[j])), order);
      ++counts["compare_distance"];
    }
  }
}

// What one case asks, compared.
void replay(const Case& input, Counts& counts) {
  std::vector<Question> questions;
  recording = &questions;
  const auto p = prepare(input);
  run(*p);
  recording = nullptr;
  for (const Question& q : questions) {
    ASSERT_NO_FATAL_FAILURE(compare(q, counts)) << input.id;
  }
  for (const polytope::Polytope* hull : {&p->a, &p->b}) {
    if (hull->rank == 3) {
      ASSERT_NO_FATAL_FAILURE(compare_sides(*hull, counts)) << input.id;
    }
  }
  ASSERT_NO_FATAL_FAILURE(compare_distances(*p, counts)) << input.id;
  counts["solid_pairs"] += p->a.rank == 3 && p->b.rank == 3;
}

TEST(EpeckReplay, AllFamilies) {
  Counts all;
  for (const families::Family& family : families::families()) {
    Counts counts;
    for (const unsigned size : {8U, 14U}) {
      for (std::uint64_t seed = 1; seed <= 2; ++seed) replay(family.make(seed, size), counts);
    }
    if (!counts["solid_pairs"]) continue;
    for (const std::string_view name : all_names) EXPECT_GT(counts[name], 0U) << family.name << ": " << name;
    for (const auto& [name, count] : counts) all[name] += count;
  }
  for (const auto& [name, count] : all) std::printf("%s: %zu compared\n", std::string(name).c_str(), count);
}

TEST(EpeckReplay, TheCatalogue) {
  Counts counts;
  for (const families::CatalogueEntry& entry : families::catalogue()) replay(entry.pair, counts);
  for (const std::string_view name : all_names) EXPECT_GT(counts[name], 1000U) << name;
}

}  // namespace
}  // namespace fathom::kernels
