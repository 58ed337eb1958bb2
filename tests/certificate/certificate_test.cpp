// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of all answers, against the naive check and the independent checker.
#include "reference/certificate/certificate.hpp"

#include <gtest/gtest.h>

#include "kernels/number/rational.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"

namespace fathom::certificate {
namespace {

std::vector<Case> all_cases() {
  std::vector<Case> cases = testing::cases_of_all_families(3, 12);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  return cases;
}

Certificate certificate_of(const Case& input) {
  return make_certificate(input.a.points, input.b.points, testing::exact_depth(input.a.points, input.b.points));
}

std::string accepted_line(const Depth& depth) {
  if (depth.distance())
    return "s VERIFIED disjoint signed_depth=-sqrt(" + depth.distance()->squared.get_str() + ")+0 name";
  std::string line = "s VERIFIED " + std::string(name(depth.status())) + " depth_squared=" + depth.squared().get_str();
  if (depth.status() == Status::penetrating) line += " optima=" + std::to_string(depth.optima().size());
  return line + " name";
}

std::string verdict(const Certificate& certificate) {
  return fathom_check::verdict_line(fathom_check::verify(certificate_text(certificate)), "name");
}

Body cube_between(long low, long high) {
  Body body;
  for (int i = 0; i < 8; ++i) body.points.push_back({i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low});
  return body;
}

const Case cubes{"two cubes", cube_between(0, 2), cube_between(1, 3)};

TEST(Certificate, EveryAnswerOfThePipelineGetsOneThatHolds) {
  for (const Case& input : all_cases()) {
    const Depth depth = testing::exact_depth(input.a.points, input.b.points);
    const Certificate certificate = make_certificate(input.a.points, input.b.points, depth);
    const kernels::Report report = validate(certificate);
    EXPECT_TRUE(report.ok()) << input.id << "\n" << testing::text(report);
    EXPECT_EQ(verdict(certificate), accepted_line(depth)) << input.id;
  }
}

TEST(Certificate, OfAWidthRepeatsTheBody) {
  for (const Case& input : testing::cases_of_all_families(1, 10)) {
    const Depth depth = testing::exact_depth(input.a.points, input.a.points);
    const Certificate certificate = make_certificate(input.a.points, input.a.points, depth);
    EXPECT_TRUE(validate(certificate).ok()) << input.id;
    EXPECT_EQ(verdict(certificate), accepted_line(depth)) << input.id;
  }
}

TEST(Certificate, AsText) {
  Certificate certificate =
      certificate_of({"", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}, {{{mpq_class(1, 2), 1, 1}}}});
  certificate.id = "100% odd\n";
  EXPECT_EQ(certificate_text(certificate),
            "fathom-certificate 1\n"
            "id 100%25%20odd%0A\n"
            "a 4\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n"
            "b 1\n1/2 1 1\n"
            "claim depth 1/4\n"
            "directions 1 all\n1 0 0\n"
            "vertices 4\n0 2\n0 1\n0 3\n0 0\n"
            "facets 4\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n"
            "end 4 1 1 4 4\n");
}

TEST(Certificate, OfTouchingAndDisjointBodiesAsText) {
  EXPECT_EQ(
      certificate_text(certificate_of({"", {{{0, 0, 0}, {2, 2, 2}}}, {{{1, 1, 1}, {5, 0, 0}, {9, 9, 0}}}})),
      "fathom-certificate 1\na 2\n0 0 0\n2 2 2\nb 3\n1 1 1\n5 0 0\n9 9 0\nclaim touching\ndirections 1 some\n-1 -1 2\n"
      "weights_a 2\n0 1/2\n1 1/2\nweights_b 1\n0 1\nend 2 3 1 2 1\n");
  EXPECT_EQ(certificate_text(certificate_of({"", {{{0, 0, 0}}}, {{{3, 0, 0}}}})),
            "fathom-certificate 2\na 1\n0 0 0\nb 1\n3 0 0\nclaim apart 9\ndirections 1 some\n-1 0 0\n"
            "weights_a 1\n0 1\nweights_b 1\n0 1\nend 1 1 1 1 1\n");
}

TEST(Certificate, FlatFacesBecomePolygons) {
  const Certificate certificate = certificate_of(cubes);
  EXPECT_EQ(certificate.directions.size(), 3U);
  std::size_t quadrangles = 0;
  for (const std::vector<std::uint32_t>& facet : certificate.inner.facets) quadrangles += facet.size() >= 4 ? 1U : 0U;
  EXPECT_GE(quadrangles, 3U);
}

/// Its facets touch the unit sphere about O, one at each of `count` points.
Body around_the_sphere(int count) {
  std::vector<Point> touching;
  for (int i = 0; i < count; ++i) {
    const mpq_class s((i * 37) % 101 - 50, 23), t((i * 61) % 103 - 51, 19), square = s * s + t * t;
    touching.push_back({2 * s / (1 + square), 2 * t / (1 + square), (1 - square) / (1 + square)});
  }
  for (Point& p : touching) p.x.canonicalize(), p.y.canonicalize(), p.z.canonicalize();
  const polytope::PlacedPair placed = polytope::place(touching, touching);
  const polytope::Polytope dual = polytope::convex_hull(placed.a.points());
  Body body;
  for (const polytope::Facet& facet : dual.facets) {  // of the dual: a corner of the body
    const mpz_class height = dot(facet.normal, dual.vertices[dual.corners[facet.begin]]);
    mpq_class distance = kernels::ratio(height, placed.denominator);
    const Point& o = placed.origin;
    distance += facet.normal.x * o.x + facet.normal.y * o.y + facet.normal.z * o.z;
    body.points.push_back({facet.normal.x / distance, facet.normal.y / distance, facet.normal.z / distance});
  }
  return body;
}

TEST(Certificate, OfManyOptima) {
  const Case input{"many ties", {{{0, 0, 0}}}, around_the_sphere(150)};
  const Depth depth = testing::exact_depth(input.a.points, input.b.points);
  EXPECT_EQ(depth.squared(), 1);
  EXPECT_EQ(depth.optima().size(), 150U);
  const Certificate certificate = make_certificate(input.a.points, input.b.points, depth);
  EXPECT_GE(certificate.inner.facets.size(), 150U);
  EXPECT_EQ(verdict(certificate), accepted_line(depth));
  const Depth certified = penetration_depth(input.a.points, input.b.points, {.method = Method::certificate});
  EXPECT_EQ(certified.optima(), depth.optima());
}

TEST(Certificate, ContradictsAWrongAnswer) {
  const Body &a = cubes.a, &b = cubes.b;
  const Depth right = testing::exact_depth(a.points, b.points);
  const auto refused = [&](const Depth& answer, const Body& of_b) {
    EXPECT_THROW(static_cast<void>(make_certificate(a.points, of_b.points, answer)), std::logic_error);
  };
  const auto refused_with = [&](auto change) {
    Depth wrong = right;
    change(std::get<Penetration>(wrong.outcome));
    refused(wrong, b);
  };
  refused_with([](Penetration& p) { p.optima.front().support += mpq_class(1, 1000000); });
  refused_with([](Penetration& p) { p.optima.pop_back(); });
  refused_with([](Penetration& p) { std::swap(p.optima[0], p.optima[1]); });
  refused(right, cube_between(2, 3));
  refused(right, cube_between(4, 5));
  Depth wrong = right;
  wrong.outcome = Touch{right.direction(), right.witness()->a};
  refused(wrong, b);
  for (const Vector& direction : {right.direction(), Vector{0, 0, 0}}) {
    wrong.outcome = Distance{.squared = 1, .direction = direction, .translation = {}, .witness = {}};
    refused(wrong, b);
  }
  const Body far = cube_between(5, 6);
  wrong = testing::exact_depth(a.points, far.points);
  ASSERT_EQ(wrong.status(), Status::disjoint);
  std::get<Distance>(wrong.outcome).squared += 1;
  refused(wrong, far);
  std::get<Distance>(wrong.outcome).squared -= 1;
  std::get<Distance>(wrong.outcome).direction.x *= 2;
  refused(wrong, far);
  wrong = testing::exact_depth(a.points, cube_between(2, 3).points);
  ASSERT_EQ(wrong.status(), Status::touching);
  std::get<Touch>(wrong.outcome).direction = {0, 0, 1};
  refused(wrong, cube_between(2, 3));
}

TEST(Certificate, NaiveCheckSeesEachKindOfFault) {
  const Certificate right = certificate_of(cubes);
  ASSERT_TRUE(validate(right).ok());
  using Change = void (*)(Certificate&);
  const Change changes[] = {
      [](Certificate& c) { c.low = c.high = c.low * mpq_class(1001, 1000); },
      [](Certificate& c) { c.low = c.high = c.low * mpq_class(999, 1000); },
      [](Certificate& c) { c.high += 1; },
      [](Certificate& c) { c.directions.pop_back(); },
      [](Certificate& c) {
        c.directions.front() = {0, 0, 0};
      },
      [](Certificate& c) { c.directions.front() = c.directions.front() + c.directions.front(); },
      [](Certificate& c) { std::swap(c.directions.front(), c.directions.back()); },
      [](Certificate& c) { c.directions.push_back(c.directions.front()); },
      [](Certificate& c) { c.inner.facets.pop_back(); },
      [](Certificate& c) { c.inner.facets.push_back(c.inner.facets.front()); },
      [](Certificate& c) { std::reverse(c.inner.facets.front().begin(), c.inner.facets.front().end()); },
      [](Certificate& c) { c.inner.facets.front().pop_back(); },
      [](Certificate& c) { c.inner.facets.front().front() = 1000; },
      [](Certificate& c) { c.inner.vertices.front().first = 1000; },
      [](Certificate& c) { std::swap(c.inner.vertices[0], c.inner.vertices[1]); },
      [](Certificate& c) { c.b.front().x -= mpq_class(1, 1000); },
      [](Certificate& c) { c.b.clear(); },
      [](Certificate& c) { c.claim = ClaimKind::touching; },
      [](Certificate& c) { c.claim = ClaimKind::apart; },
      [](Certificate& c) { c.claim = ClaimKind::bounds; },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Certificate wrong = right;
    changes[i](wrong);
    EXPECT_FALSE(validate(wrong).ok()) << "change " << i;
  }
}

TEST(Certificate, NaiveCheckSeesEachKindOfFaultInADistance) {
  const Certificate right = certificate_of({"apart", cube_between(0, 2), cube_between(3, 4)});
  ASSERT_TRUE(validate(right).ok());
  ASSERT_EQ(right.low, 3);
  using Change = void (*)(Certificate&);
  const Change changes[] = {
      [](Certificate& c) { c.low = c.high = 4; },
      [](Certificate& c) { c.high = 4; },
      [](Certificate& c) { c.directions.front() = -c.directions.front(); },
      [](Certificate& c) {
        c.directions.front() = {-1, -1, 0};
      },
      [](Certificate& c) { c.weights_a.front().index = 0; },
      [](Certificate& c) { c.weights_b.clear(); },
      [](Certificate& c) { c.claim = ClaimKind::touching; },
      [](Certificate& c) { c.claim = ClaimKind::depth; },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Certificate wrong = right;
    changes[i](wrong);
    EXPECT_FALSE(validate(wrong).ok()) << "change " << i;
  }
}

TEST(BoundsCertificate, HoldsWhateverTheBoundsAre) {
  std::size_t made = 0;
  for (const Case& input : testing::cases_of_all_families(1, 14)) {
    const Depth depth = testing::exact_depth(input.a.points, input.b.points);
    const auto bounds = [&](const mpq_class& low, const mpq_class& high) {
      return make_bounds_certificate(input.a.points, input.b.points, low, high);
    };
    if (depth.status() != Status::penetrating) {
      EXPECT_THROW(bounds(0, 1), std::invalid_argument) << input.id;
      continue;
    }
    ++made;
    const mpq_class q = depth.squared();
    for (const auto& [low, high] :
         {std::pair<mpq_class, mpq_class>{0, q}, {q, q}, {q * mpq_class(9, 10), q * mpq_class(11, 10)}, {0, q * 100}}) {
      const Certificate certificate = bounds(low, high);
      EXPECT_TRUE(validate(certificate).ok()) << input.id << testing::text(validate(certificate));
      EXPECT_EQ(verdict(certificate),
                "s VERIFIED penetrating depth_squared_in=[" + low.get_str() + "," + high.get_str() + "] name")
          << input.id;
    }
    EXPECT_THROW(bounds(q * mpq_class(1001, 1000), q * 2), std::invalid_argument) << input.id;
    EXPECT_THROW(bounds(0, q * mpq_class(999, 1000)), std::invalid_argument) << input.id;
    EXPECT_THROW(bounds(-1, q), std::invalid_argument) << input.id;
  }
  EXPECT_GT(made, 30U);
}

}  // namespace
}  // namespace fathom::certificate
