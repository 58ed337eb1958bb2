// SPDX-License-Identifier: GPL-3.0-or-later
// Known coincidences by hand, and every kind against all pairs, by its definition.
#include "verify/study/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/gaussian/gaussian_diagram.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

namespace fathom::studies {
namespace {

using Kind = Coincidence;

Study study_of(const Body& a, const Body& b, std::size_t listed = 20) {
  return fathom::study(a.points, b.points, {.listed = listed});
}

Body moved(const Body& body, const Point& by) { return families::translated(body, by); }

std::uint64_t count(const Study& study, Kind kind) { return study[kind].count; }

void expect_each_zero_decided(const Study& study, const std::string& name) {
  for (std::size_t i = 0; i < study.predicates.size(); ++i) {
    std::uint64_t decided = 0;
    for (const auto& [monomial, times] : study.predicates[i].decided) decided += times;
    EXPECT_EQ(decided, study.predicates[i].zero) << name << ": " << predicate_names[i];
  }
}

TEST(Study, TwoCubes) {
  const Study s =
      study_of(families::cube(), moved(families::cube(), {mpq_class(3, 2), mpq_class(1, 2), mpq_class(1, 4)}));
  EXPECT_EQ(s.depth.status(), Status::penetrating);
  EXPECT_EQ(count(s, Kind::parallel_edges), 3u * 4 * 4);
  EXPECT_EQ(count(s, Kind::parallel_edges_of_a), 3u * 6);
  EXPECT_EQ(count(s, Kind::parallel_edges_of_b), 3u * 6);
  EXPECT_EQ(count(s, Kind::coincident_normals), 6u);
  EXPECT_EQ(count(s, Kind::equal_normals), 6u);
  EXPECT_EQ(count(s, Kind::coplanar_facets), 0u);
  EXPECT_EQ(count(s, Kind::normals_on_arcs), 0u);  // nodes coincide with nodes
  EXPECT_EQ(count(s, Kind::nodes_on_equator), 2u * 4);
  EXPECT_EQ(count(s, Kind::arcs_on_equator), 2u * 4);
  EXPECT_EQ(count(s, Kind::crossings_on_equator), 0u);
  EXPECT_EQ(count(s, Kind::nodes_on_one_vertical), 2u);  // the pole of each hemisphere, from either body
  EXPECT_EQ(count(s, Kind::arcs_on_verticals), 2u * 8);
  EXPECT_EQ(count(s, Kind::ties), 0u);
  EXPECT_EQ(count(s, Kind::touching_features), 0u);
  EXPECT_GT(s.predicates[static_cast<std::size_t>(Predicate::side_of_equator)].zero, 0u);
  expect_each_zero_decided(s, "cubes");
}

TEST(Study, CoplanarFacets) {
  const Study same = study_of(families::cube(), families::cube());
  EXPECT_EQ(count(same, Kind::coplanar_facets), 6u);
  EXPECT_EQ(count(same, Kind::ties), 6u);
  const Study touching = study_of(families::cube(), moved(families::cube(), {2, 0, 0}));
  EXPECT_EQ(touching.depth.status(), Status::touching);
  EXPECT_EQ(count(touching, Kind::coplanar_facets), 1u + 4);  // the common one, and the four sides
  ASSERT_EQ(touching[Kind::touching_features].listed.size(), 1u);
  const Involved& faces = touching[Kind::touching_features].listed.front();
  ASSERT_EQ(faces.a.size(), 1u);
  ASSERT_EQ(faces.b.size(), 1u);
  EXPECT_EQ(faces.a[0].size(), 4u);
  for (const std::uint32_t i : faces.a[0]) EXPECT_EQ(families::cube().points[i].x, 1);
  for (const std::uint32_t i : faces.b[0]) EXPECT_EQ(families::cube().points[i].x, -1);
}

// The octahedron's nodes are (+-1,+-1,+-1), and its arcs join neighbours: the cube's nodes +-e_i
// lie on none, nor do the octahedron's on the cube's arcs, which join the +-e_i. But those of the
// cube that lie on the equator are crossed at (+-1,+-1,0). A cube turned about z by an eighth of a
// circle has the nodes (+-1,+-1,0), and arcs through (+-1,+-1,+-1).
TEST(Study, NormalsOnArcs) {
  const Study aligned = study_of(families::cube(), families::octahedron());
  EXPECT_EQ(count(aligned, Kind::normals_on_arcs), 0u);
  EXPECT_EQ(count(aligned, Kind::crossings_on_equator), 4u);
  const Body turned{{{2, 0, -1}, {-2, 0, -1}, {0, 2, -1}, {0, -2, -1}, {2, 0, 1}, {-2, 0, 1}, {0, 2, 1}, {0, -2, 1}}};
  const Study s = study_of(turned, families::octahedron());
  EXPECT_EQ(count(s, Kind::normals_on_arcs), 4u + 8);
  std::size_t sides = 0, rims = 0;
  for (const Involved& involved : s[Kind::normals_on_arcs].listed) {
    sides += involved.a.at(0).size() == 4 && involved.b.at(0).size() == 2;
    rims += involved.a.at(0).size() == 2 && involved.b.at(0).size() == 3;
  }
  EXPECT_EQ(sides, 4u);
  EXPECT_EQ(rims, 8u);
  EXPECT_EQ(count(study_of(families::octahedron(), turned), Kind::normals_on_arcs), 4u + 8);
}

TEST(Study, PrismsOnACommonAxis) {
  const unsigned m = 5, n = 7;
  const Study s = study_of(families::prism(m, 1), families::prism(n, 2, 1));
  EXPECT_GE(count(s, Kind::parallel_edges), m * n);
  EXPECT_GE(count(s, Kind::coincident_normals), 2u);  // the ends
  EXPECT_EQ(count(s, Kind::arcs_on_equator), m + n);
  EXPECT_EQ(count(s, Kind::nodes_on_equator), m + n);
  expect_each_zero_decided(s, "prisms");
}

TEST(Study, GeneralPosition) {
  const Case input = families::find_family("random_sphere")->make(1, 30);
  const Study s = fathom::study(input.a.points, input.b.points);
  for (const Coincidences& all : s.coincidences) EXPECT_EQ(all.count, 0u);
  std::uint64_t calls = 0;
  for (const TierCounts& tiers : s.predicates) {
    calls += tiers.calls;
    EXPECT_EQ(tiers.zero, 0u);
    EXPECT_TRUE(tiers.decided.empty());
  }
  EXPECT_GT(calls, 1000u);
}

TEST(Study, MonomialNames) {
  EXPECT_EQ(monomial_name(kernels::Monomial().packed()), "1");
  EXPECT_EQ(monomial_name(kernels::Monomial(1).packed()), "a");
  EXPECT_EQ(monomial_name((kernels::Monomial(4, 2) * kernels::Monomial(3)).packed()), "E11^2 c");
}

// All pairs, by definition.
class Naive {
 public:
  explicit Naive(const testing::Prepared& p) : p_(p) {}

  std::uint64_t parallel(const gaussian::GaussianDiagram& s, const gaussian::GaussianDiagram& t) const {
    std::uint64_t all = 0;
    for (const gaussian::Arc& e : s.arcs) {
      for (const gaussian::Arc& f : t.arcs) all += is_zero(cross(e.circle.exact(), f.circle.exact()));
    }
    return &s == &t ? (all - s.arcs.size()) / 2 : all;
  }
  std::uint64_t normals(bool equal) const {
    std::uint64_t all = 0;
    for (const polytope::Facet& f : p_.a.facets) {
      for (const polytope::Facet& g : p_.b.facets) all += same_direction(f.normal, equal ? g.normal : -g.normal);
    }
    return all;
  }
  std::uint64_t coplanar() const {
    std::uint64_t all = 0;
    for (const polytope::Facet& f : p_.a.facets) {
      for (const polytope::Facet& g : p_.b.facets) all += in_one_plane(f, g);
    }
    return all;
  }
  std::uint64_t on_arcs(const gaussian::GaussianDiagram& nodes, const gaussian::GaussianDiagram& arcs) const {
    std::uint64_t all = 0;
    for (const kernels::Direction& node : nodes.nodes) {
      for (const gaussian::Arc& arc : arcs.arcs)
        all += dot(node.exact(), arc.circle.exact()) == 0 && inside(arcs, arc, node.exact());
    }
    return all;
  }
  std::uint64_t crossings() const {
    std::uint64_t all = 0;
    for (const gaussian::Arc& e : p_.minus_a.arcs) {
      for (const gaussian::Arc& f : p_.of_b.arcs) {
        const Vector w = cross(e.circle.exact(), f.circle.exact());
        if (is_zero(w) || w.z != 0) continue;
        for (const Vector& u : {w, -w}) all += inside(p_.minus_a, e, u) && inside(p_.of_b, f, u);
      }
    }
    return all;
  }
  std::uint64_t on_one_vertical() const {
    std::vector<Vector> nodes;
    for (const gaussian::GaussianDiagram* diagram : {&p_.minus_a, &p_.of_b}) {
      for (const kernels::Direction& node : diagram->nodes) nodes.push_back(node.exact());
    }
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        all += sgn(nodes[i].z) * sgn(nodes[j].z) > 0 && det(nodes[i], nodes[j], {0, 1, 0}) == 0;
    }
    return all;
  }
  std::uint64_t nodes_where(bool (*law)(const Vector&)) const {
    std::uint64_t all = 0;
    for (const gaussian::GaussianDiagram* diagram : {&p_.minus_a, &p_.of_b}) {
      for (const kernels::Direction& node : diagram->nodes) all += law(node.exact());
    }
    return all;
  }
  std::uint64_t arcs_where(bool (*law)(const Vector&)) const {
    std::uint64_t all = 0;
    for (const gaussian::GaussianDiagram* diagram : {&p_.minus_a, &p_.of_b}) {
      for (const gaussian::Arc& arc : diagram->arcs) all += law(arc.circle.exact());
    }
    return all;
  }

 private:
  static bool inside(const gaussian::GaussianDiagram& diagram, const gaussian::Arc& arc, const Vector& u) {
    if (!gaussian::contains(diagram, arc, u)) return false;
    return diagram.rank == 1 ||
           (!same_direction(u, diagram.nodes[arc.from].exact()) && !same_direction(u, diagram.nodes[arc.to].exact()));
  }
  bool in_one_plane(const polytope::Facet& f, const polytope::Facet& g) const {
    const Vector& p = p_.a.vertices[p_.a.corners[f.begin]];
    for (std::uint32_t k = g.begin; k < g.end; ++k) {
      if (dot(f.normal, p_.b.vertices[p_.b.corners[k]] - p) != 0) return false;
    }
    return true;
  }

  const testing::Prepared& p_;
};

TEST(Study, EveryKindAgainstAllPairs) {
  std::vector<std::uint64_t> seen(coincidence_names.size());
  for (const Case& input : testing::cases_of_all_families(2, 7)) {
    SCOPED_TRACE(input.id);
    const Study s = fathom::study(input.a.points, input.b.points, {.listed = SIZE_MAX});
    const auto prepared = testing::prepare(input);
    const Naive naive(*prepared);
    const gaussian::GaussianDiagram &a = prepared->minus_a, &b = prepared->of_b;
    EXPECT_EQ(count(s, Kind::parallel_edges), naive.parallel(a, b));
    EXPECT_EQ(count(s, Kind::parallel_edges_of_a), naive.parallel(a, a));
    EXPECT_EQ(count(s, Kind::parallel_edges_of_b), naive.parallel(b, b));
    EXPECT_EQ(count(s, Kind::coincident_normals), naive.normals(false));
    EXPECT_EQ(count(s, Kind::equal_normals), naive.normals(true));
    EXPECT_EQ(count(s, Kind::coplanar_facets), naive.coplanar());
    EXPECT_EQ(count(s, Kind::normals_on_arcs), naive.on_arcs(a, b) + naive.on_arcs(b, a));
    EXPECT_EQ(count(s, Kind::nodes_on_equator), naive.nodes_where([](const Vector& n) { return n.z == 0; }));
    EXPECT_EQ(count(s, Kind::arcs_on_equator), naive.arcs_where([](const Vector& d) { return d.x == 0 && d.y == 0; }));
    EXPECT_EQ(count(s, Kind::crossings_on_equator), naive.crossings());
    EXPECT_EQ(count(s, Kind::nodes_on_one_vertical), naive.on_one_vertical());
    EXPECT_EQ(count(s, Kind::arcs_on_verticals), naive.arcs_where([](const Vector& d) { return d.y == 0; }));
    EXPECT_EQ(count(s, Kind::ties), s.depth.optima().size() > 1 ? s.depth.optima().size() : 0);
    EXPECT_EQ(count(s, Kind::touching_features), s.depth.status() == Status::touching ? 1u : 0u);
    expect_each_zero_decided(s, input.id);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(s.coincidences[i].listed.size(), s.coincidences[i].count) << coincidence_names[i];
      seen[i] += s.coincidences[i].count;
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_GT(seen[i], 0u) << coincidence_names[i];
}

TEST(Study, ListingsAreLimitedAndCountsAreNot) {
  const Study few = study_of(families::cube(), families::cube(), 3),
              none = study_of(families::cube(), families::cube(), 0);
  const Study all = study_of(families::cube(), families::cube(), 1000);
  for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
    EXPECT_EQ(few.coincidences[i].count, all.coincidences[i].count);
    EXPECT_EQ(all.coincidences[i].listed.size(), all.coincidences[i].count);
    EXPECT_TRUE(none.coincidences[i].listed.empty());
    const std::size_t kept = few.coincidences[i].listed.size();
    EXPECT_EQ(kept, std::min<std::uint64_t>(3, all.coincidences[i].count));
    EXPECT_TRUE(std::equal(few.coincidences[i].listed.begin(), few.coincidences[i].listed.end(),
                           all.coincidences[i].listed.begin()));
  }
}

// Bodies of 10^-300 by 1 by 10^300: no filter in binary64 decides anything about their normals,
// unless each axis has a unit of its own.
TEST(Study, StretchedBodiesAreStudiedLikeOthers) {
  const families::Family& family = *families::find_family("random_sphere");
  Case pair = family.make(1, 60);
  const Study plain = study_of(pair.a, pair.b);
  for (Body* body : {&pair.a, &pair.b}) {
    for (Point& p : body->points.edit()) {
      p.x /= mpz_class(1) << 1000;
      p.z *= mpz_class(1) << 1000;
    }
  }
  kernels::Context context;
  const Study stretched = study(context, pair.a.points, pair.b.points);
  const TierCounts& tiers = context.counters.predicates[static_cast<std::size_t>(Predicate::side_of_arc)];
  EXPECT_GT(tiers.calls, 10000u);
  EXPECT_LT(tiers.exact, tiers.calls / 20);
  for (std::size_t i = 0; i < coincidence_names.size(); ++i)
    EXPECT_EQ(stretched.coincidences[i].count, plain.coincidences[i].count) << coincidence_names[i];
}

TEST(Study, CanBeStopped) {
  struct StopAt final : Monitor {
    explicit StopAt(std::string_view at) : at(at) {}
    void report(std::string_view stage, double) override { there = there || stage == at; }
    bool stopped() override { return there; }
    std::string_view at;
    bool there = false;
  };
  for (const std::string_view at : {"hulls", "diagrams", "normals on arcs"}) {
    StopAt stop(at);
    EXPECT_THROW(fathom::study(families::cube().points, families::cube().points, {.monitor = &stop}), Interrupted)
        << at;
    EXPECT_TRUE(stop.there) << at;
  }
}

}  // namespace
}  // namespace fathom::studies
