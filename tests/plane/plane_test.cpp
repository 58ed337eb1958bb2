// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of the plane: against a naive twin, against thick prisms in space, against closed forms;
// unions; what is refused.
#include "fathom/plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/overlap.hpp"
#include "fathom/union.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/plane/pairs.hpp"

namespace fathom::plane {
namespace {

Case read(const std::string& bodies) {
  const CaseItem item = parse_case("{\"dimension\": 2, " + bodies + "}", "test");
  EXPECT_TRUE(item.ok()) << item.error().what();
  return item.value();
}

Answer answer_to(const std::string& bodies) {
  const Case pair = read(bodies);
  return exact_answer(pair.a, pair.b);
}

std::string fault_of(const std::string& fields) {
  const CaseItem item = parse_case("{" + fields + "}", "x");
  return item.ok() ? "none" : item.error().what();
}

/// Its signed depth is plus + sign(root) sqrt(|root|).
void expect_value(const Answer& answer, const Surd& value, const std::string& id = "") {
  ASSERT_TRUE(answer.exact()) << id;
  EXPECT_EQ(compare(*answer.exact(), value), 0) << id << answer.exact()->rational << " and " << answer.exact()->root;
}

TEST(Plane, EqualsTheNaiveTwin) { expect_right_pairs(150); }

TEST(Plane, IsTheSameOfPointsInBinary64) {
  Random random(2);
  int compared = 0;
  for (const PairKind kind : all_kinds)
    for (int i = 0; i < 25; ++i) {
      const PlanePair pair = plane_pair(kind, random);
      const auto in_binary64 = [](const Points& points) {
        std::vector<std::array<double, 3>> rounded;
        for (const Point& p : points) rounded.push_back({p.x.get_d(), p.y.get_d(), 0});
        return in_plane(Body{GivenPoints(std::move(rounded))});
      };
      const Body a = in_binary64(pair.a), b = in_binary64(pair.b);
      if (a.points != body_of(pair.a).points || b.points != body_of(pair.b).points) continue;
      EXPECT_TRUE(answer::prisms_of(a, b).b.points.in_binary64());
      const Answer exact = exact_answer(body_of(pair.a), body_of(pair.b)), quick = exact_answer(a, b);
      const Depth &one = std::get<Depth>(exact.found), &other = std::get<Depth>(quick.found);
      EXPECT_EQ(signed_square(one), signed_square(other)) << text_of(pair);
      EXPECT_EQ(one.optima(), other.optima()) << text_of(pair);
      ++compared;
    }
  EXPECT_GT(compared, 100);
}

TEST(Plane, EqualsSpaceOnThickPrisms) {
  Random random(3);
  for (const PairKind kind : all_kinds)
    for (int i = 0; i < 25; ++i) {
      const PlanePair pair = plane_pair(kind, random);
      const Points a = prism(pair.a, 3000), b = prism(pair.b, 4999);
      const Depth space = penetration_depth(a, b),
                  plane = std::get<Depth>(exact_answer(body_of(pair.a), body_of(pair.b)).found);
      const std::string id = text_of(pair);
      EXPECT_EQ(plane.status(), space.status()) << id;
      EXPECT_EQ(signed_square(plane), signed_square(space)) << id;
      EXPECT_EQ(ways_of(plane), ways_of(space)) << id;
    }
}

TEST(Plane, IsTheSameIfTheBodiesAreSwappedOrMoved) {
  Random random(5);
  for (const PairKind kind : all_kinds)
    for (int i = 0; i < 20; ++i) {
      const PlanePair pair = plane_pair(kind, random);
      const Body a = body_of(pair.a), b = body_of(pair.b);
      const Depth one = std::get<Depth>(exact_answer(a, b).found), other = std::get<Depth>(exact_answer(b, a).found);
      EXPECT_EQ(signed_square(one), signed_square(other)) << text_of(pair);
      EXPECT_EQ(one.optima_count(), other.optima_count()) << text_of(pair);
      const Point by{mpq_class(1, 3), 77, 0};
      EXPECT_EQ(answer::height_above(a, b), answer::height_above(b, body_of(moved(pair.a, by))));
      const Depth both = std::get<Depth>(exact_answer(body_of(moved(pair.a, by)), body_of(moved(pair.b, by))).found);
      EXPECT_EQ(ways_of(one), ways_of(both)) << text_of(pair);
      EXPECT_EQ(signed_square(one), signed_square(both)) << text_of(pair);
    }
}

// The height is a power of two above the extents, in and beyond binary64.
TEST(Plane, BodiesAreRaisedByAPowerOfTwoAboveTheirExtents) {
  for (const long exponent : {-1074L, -80L, -1L, 0L, 3L, 80L, 1022L, 1023L, 2000L})
    for (const long k : {1, 2, 3, 7}) {
      mpq_class unit = 1;
      if (exponent < 0) mpq_div_2exp(unit.get_mpq_t(), unit.get_mpq_t(), static_cast<unsigned long>(-exponent));
      else mpq_mul_2exp(unit.get_mpq_t(), unit.get_mpq_t(), static_cast<unsigned long>(exponent));
      const mpq_class x = unit * k;
      const Body segment = in_plane(Body{{{0, 0, 0}, {x, unit, 0}}}), point = in_plane(Body{{{5, 5, 0}}});
      const mpq_class h = answer::height_above(segment, point);
      EXPECT_TRUE(h > x && h <= 2 * x) << x;
      EXPECT_TRUE(mpz_popcount(h.get_num_mpz_t()) == 1 && mpz_popcount(h.get_den_mpz_t()) == 1) << h;
      const Body square = in_plane(Body{{{0, 0, 0}, {x, 0, 0}, {x, x, 0}, {0, x, 0}}});
      expect_value(exact_answer(square, square), Surd{0, x * x});
    }
  const Body point = in_plane(Body{{{5, 5, 0}}});
  EXPECT_EQ(answer::height_above(point, point), 1);
}

TEST(Plane, RoundBodiesHaveTheirClosedForms) {
  // Two circles of radii 1 and 1/2, whose centres are (3, 4)/4 apart.
  expect_value(answer_to(R"("a": {"shape": "circle", "radius": 1},
                          "b": {"shape": "circle", "radius": 0.5, "pose": {"translation": [0.75, 1]}})"),
               Surd{mpq_class(3, 2), mpq_class(-25, 16)});
  // Concentric: every direction is as good.
  const Answer same = answer_to(R"("a": {"shape": "circle", "radius": 1}, "b": {"shape": "circle", "radius": 2})");
  const OptimalCone cone = std::get<SignedDepth>(same.found).cone.value();
  EXPECT_EQ(cone.lineality, Lineality::all);
  expect_value(same, Surd{3, 0});
  EXPECT_EQ(*same.direction(), (Vector{-1, 0, 0}));
  // A capsule along y, turned by a right angle: its segment is from (-2, 0) to (2, 0).
  const std::string capsule =
      R"("a": {"shape": "capsule", "radius": "1/3", "half_length": 2, "axis": "y", "pose": {"half_angle": 1}}, )";
  expect_value(answer_to(capsule + R"("b": {"shape": "circle", "radius": 1, "pose": {"translation": [1, 5]}})"),
               Surd{mpq_class(4, 3), -25});
  expect_value(answer_to(capsule + R"("b": {"shape": "circle", "radius": 1, "pose": {"translation": [5, 4]}})"),
               Surd{mpq_class(4, 3), -25});
  // A rounded box of half lengths 1 and 2, the margin 1/4, turned by the angle with the sine 4/5.
  const Answer on_plane =
      answer_to(R"("a": {"shape": "rounded_box", "half": [1, 2], "margin": 0.25, "pose": {"half_angle": "1/2"}},
                                       "b": {"shape": "halfplane", "normal": [0, 2], "offset": -3})");
  EXPECT_EQ(on_plane.exact()->rational, mpq_class(1, 4));
  EXPECT_EQ(on_plane.exact()->root, mpq_class(1, 4));  // the lowest corner is at -2, the plane at -3/2
  EXPECT_EQ(*on_plane.direction(), (Vector{0, 1, 0}));
  EXPECT_FALSE(on_plane.contact());
}

TEST(Plane, RoundedPolygonsHaveTheDepthOfTheirCoresAndRadii) {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const PlanePair pair = plane_pair(i % 2 == 0 ? PairKind::random : PairKind::flat, random);
    const auto rounded = [](const Points& points, const mpq_class& radius) {
      Body body;
      body.shape = Shape{fathom::hull(points).core, radius};
      return in_plane(std::move(body));
    };
    const Answer answer = exact_answer(rounded(pair.a, 2), rounded(pair.b, mpq_class(1, 2)));
    const NaiveAnswer cores = naive_depth(pair.a, pair.b);
    const mpq_class signed_square = cores.status == Status::disjoint ? mpq_class(-cores.squared) : cores.squared;
    expect_value(answer, Surd{mpq_class(5, 2), signed_square}, text_of(pair));
    if (cores.status == Status::touching) {
      for (const Vector& ray : std::get<SignedDepth>(answer.found).cone->rays) EXPECT_EQ(ray.z, 0);
    }
  }
}

TEST(Plane, UnionsOfOnePieceAreThatPiece) {
  Random random(9);
  for (int i = 0; i < 40; ++i) {
    const PlanePair pair = plane_pair(i % 2 == 0 ? PairKind::random : PairKind::parallel, random);
    if (hull(pair.a).size() < 3 || hull(pair.b).size() < 3) continue;
    Body piece;
    piece.pieces = std::make_shared<const Pieces>(Pieces{pair.a});
    const Answer answer = exact_answer(in_plane(piece), body_of(pair.b));
    const NaiveAnswer naive = naive_depth(pair.a, pair.b);
    const UnionDepth& depth = std::get<UnionDepth>(answer.found);
    EXPECT_EQ(depth.status, naive.status);
    EXPECT_EQ(depth.apart ? depth.apart->distance.squared : depth.low, naive.squared);
    EXPECT_EQ(answer.ways_out(), naive.ways.size());
    const Answer swapped = exact_answer(body_of(pair.b), in_plane(piece));
    EXPECT_EQ(swapped.status(), naive.status);
    EXPECT_EQ(compare(swapped.low(), answer.low()), 0);
    for (const UnionOptimum& optimum : depth.optima)
      for (const PieceContact& met : optimum.contacts) {
        const Point u = rational(met.direction);
        EXPECT_EQ(met.contact.a, naive_face(pair.a, {-u.x, -u.y, 0})) << text_of(pair);
        EXPECT_EQ(met.contact.b, naive_face(pair.b, u)) << text_of(pair);
      }
  }
}

// After the way out no two pieces overlap; and thicker prisms in space say the same.
TEST(Plane, UnionsAreThoseOfPrisms) {
  Random random(11);
  for (int i = 0; i < 12; ++i) {
    Pieces a, b, prisms_a, prisms_b;
    for (Pieces* pieces : {&a, &b})
      while (pieces->size() < 2) {
        Points piece = random_points(random, 4, 8);
        if (hull(piece).size() > 2) pieces->push_back(std::move(piece));
      }
    if (i % 3 == 0)  // apart
      for (Points& piece : b) piece = moved(std::move(piece), {30, 1, 0});
    for (const Points& piece : a) prisms_a.push_back(prism(piece, 100));
    for (const Points& piece : b) prisms_b.push_back(prism(piece, 333));
    Body body_a, body_b;
    body_a.pieces = std::make_shared<const Pieces>(a);
    body_b.pieces = std::make_shared<const Pieces>(b);
    const Answer answer = exact_answer(in_plane(body_a), in_plane(body_b));
    const UnionDepth &plane = std::get<UnionDepth>(answer.found), space = union_depth(prisms_a, prisms_b);
    EXPECT_EQ(plane.status, space.status);
    EXPECT_EQ(plane.low, space.low);
    ASSERT_EQ(plane.optima.size(), space.optima.size());
    for (std::size_t k = 0; k < plane.optima.size(); ++k) {
      EXPECT_EQ(plane.optima[k].translation, space.optima[k].translation);
      EXPECT_EQ(plane.optima[k].clearance, space.optima[k].clearance);
      for (const Points& p : a)
        for (const Points& q : b)
          EXPECT_NE(naive_depth(moved(p, plane.optima[k].translation), q).status, Status::penetrating);
    }
    if (plane.apart) {
      const Witness& witness = plane.apart->distance.witness;
      EXPECT_TRUE(witness.a.z == 0 && witness.b.z == 0);
      EXPECT_EQ(witness.b - witness.a, plane.apart->distance.translation);
    }
  }
}

TEST(Plane, OverlapsAndDistancesAreOfThePlane) {
  const Body square = in_plane(Body{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  const Body there = in_plane(Body{{{mpq_class(1, 2), 0, 0}, {3, 0, 0}, {3, 1, 0}}}), far = in_plane(Body{{{4, 0, 0}}});
  EXPECT_EQ(overlap(square, there).status, Status::penetrating);
  EXPECT_EQ(overlap(square, far).status, Status::disjoint);
  EXPECT_EQ(closer_than(square, far, 4).closer, true);
  EXPECT_EQ(closer_than(square, far, 3).closer, false);
}

TEST(Plane, CasesAreWrittenAndReadAgain) {
  for (
      const char* bodies :
      {R"("a": {"vertices": [[0, 0], ["1/3", 1]]}, "b": {"shape": "circle", "radius": 2, "pose": {"translation": [1, 2]}})",
       R"("a": {"shape": "halfplane", "normal": [1, 2], "offset": 3, "margin": 1}, "b": {"shape": "box", "half": [1, 2]})",
       R"("a": {"pieces": [[[0, 0], [1, 0], [0, 1]], {"shape": "box", "half": [1, 1]}], "pose": [[0, -1, 2], [1, 0, 0]]},
           "b": {"vertices": [[0, 0], [1, 0.1], [0, 1]], "pose": {"half_angle": 0.5}, "pose_rounding": "binary64"})"}) {
    const Case pair = read(bodies);
    EXPECT_EQ(pair.a.dimension, 2U);
    EXPECT_EQ(pair.b.dimension, 2U);
    const std::string text = files::case_json(pair);
    EXPECT_NE(text.find("\"dimension\":2"), std::string::npos) << text;
    const Case again = parse_case(text, "again").value();
    EXPECT_EQ(files::case_json(again), text);
    EXPECT_EQ(again.a.points, pair.a.points);
    EXPECT_EQ(again.b.points.in_binary64(), pair.b.points.in_binary64());
    EXPECT_EQ(again.a.shape, pair.a.shape);
  }
  // (x, y) -> (2 - y, x)
  const Case posed = read(
      R"("a": {"pieces": [[[0, 0], [1, 0], [0, 3]]], "pose": [[0, -1, 2], [1, 0, 0]]}, "b": {"vertices": [[0, 0]]})");
  EXPECT_EQ(posed.a.pieces->front(), (Points{{2, 0, 0}, {2, 1, 0}, {-1, 0, 0}}));
  // cos = 3/5, sin = 4/5
  const Case turned = read(
      R"("a": {"vertices": [[5, 0]], "pose": {"half_angle": "1/2", "translation": [1, 1]}}, "b": {"vertices": [[0, 0]]})");
  EXPECT_EQ(turned.a.points[0], (Point{4, 5, 0}));
  EXPECT_TRUE(turned.a.points.in_binary64());
}

TEST(Plane, BadCasesAreRefusedWithASentence) {
  const std::string b = R"(, "b": {"vertices": [[0, 0]]})";
  const std::vector<std::pair<std::string, std::string>> faults = {
      {R"("dimension": 4, "a": {"vertices": [[0, 0]]})", "x:1: dimension: expected 2 or 3, found 4"},
      {R"("dimension": "2", "a": {"vertices": [[0, 0]]})", "x:1: dimension: expected 2 or 3, found \"2\""},
      {R"("dimension": 2, "a": {"vertices": [[0, 0, 0]]})",
       "x:1: a.vertices[0]: expected two numbers, found an array of 3"},
      {R"("a": {"vertices": [[0, 0]]})", "x:1: a.vertices[0]: expected three coordinates, found 2"},
      {R"("dimension": 2, "a": {"vertices": []})", "x:1: a.vertices: expected an array of points, found an array of 0"},
      {R"("dimension": 2, "a": {"vertices": [[0, 0]], "faces": []})",
       "x:1: a.faces: expected no such field of a polygon, found one"},
      {R"("dimension": 2, "a": {"solid": {}})", "x:1: a.solid: expected no such field of a polygon, found one"},
      {R"("dimension": 2, "a": {"shape": "sphere", "radius": 1})",
       "x:1: a.shape: expected circle, capsule, box, polygon, halfplane, or one of them after 'rounded_', found "
       "\"sphere\""},
      {R"("dimension": 2, "a": {"shape": "capsule", "radius": 1, "half_length": 1, "axis": "z"})",
       "x:1: a.axis: expected \"x\" or \"y\", found \"z\""},
      {R"("dimension": 2, "a": {"shape": "box", "half": [1, 1, 1]})",
       "x:1: a.half: expected two numbers, found an array of 3"},
      {R"("dimension": 2, "a": {"shape": "box", "half": [1, 0]})", "x:1: a: the half lengths of a box are > 0"},
      {R"("dimension": 2, "a": {"shape": "halfplane", "normal": [0, 0], "offset": 1})",
       "x:1: a: the normal of a half-plane is not 0"},
      {R"("dimension": 2, "a": {"vertices": [[0, 0]], "pose": {"rpy": [0, 0, 1], "unit": "deg"}})",
       "x:1: a.pose: expected two rows of three numbers, or an object with 'half_angle' or 'translation', found an "
       "object"},
      {R"("dimension": 2, "a": {"vertices": [[0, 0]], "pose": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]})",
       "x:1: a.pose: expected two rows of three numbers, or an object with 'half_angle' or 'translation', found an "
       "array of 3"},
      {R"("dimension": 2, "a": {"pieces": [[[0, 0], [1, 0], [0, 1]]], "margin": 1})",
       "x:1: a.margin: expected no such field beside 'pieces', found one"},
      {R"("dimension": 2, "a": {"pieces": [{"shape": "circle", "radius": 1}]})",
       "x:1: a.pieces[0]: expected a piece without a radius: to add the radii of unions to a depth would be wrong"},
      {R"("dimension": 2, "twist": {"a": {"v": [0, 0, 0], "w": [0, 0, 1]}}, "a": {"vertices": [[0, 0]]})",
       "x:1: twist: expected no such field in the plane, found one"},
  };
  for (const auto& [fields, sentence] : faults) EXPECT_EQ(fault_of(fields + b), sentence);
}

TEST(Plane, WhatIsNoBodyOfThePlaneIsRefused) {
  const Body point = in_plane(Body{{{0, 0, 0}}}), space{{{0, 0, 0}}};
  EXPECT_THROW(in_plane(Body{{{0, 0, 1}}}), std::invalid_argument);
  Body curved;
  curved.shape = cylinder(1, 1);
  EXPECT_THROW(in_plane(curved), std::invalid_argument);
  curved.shape = halfspace({0, 1, 1}, 0);
  EXPECT_THROW(in_plane(curved), std::invalid_argument);
  EXPECT_THROW(exact_answer(point, space), std::invalid_argument);
  EXPECT_THROW(exact_answer(space, point), std::invalid_argument);
  EXPECT_THROW(penetration_depth(point, point), std::invalid_argument);
}

TEST(Plane, IsReadFromPointsAndDrawings) {
  const auto points = [](const std::string& text, const std::string& name) {
    return parse_mesh(text, name, Decimals::exact);
  };
  const Body lines = points("0 0\n0.1 2 # a corner\n-1e-3 4\n", "x.txt");
  EXPECT_EQ(lines.dimension, 2U);
  EXPECT_EQ(lines.points, (GivenPoints{{0, 0, 0}, {mpq_class(1, 10), 2, 0}, {mpq_class(-1, 1000), 4, 0}}));
  EXPECT_EQ(points("0 0 1\n", "x.txt").dimension, 3U);
  const auto svg = [&](const std::string& shape) { return points("<svg>\n" + shape + "</svg>", "x.svg"); };
  const Points triangle{{0, 0, 0}, {mpq_class(3, 2), 0, 0}, {1, -2, 0}};
  EXPECT_EQ(svg(R"(<polygon points="0,0 1.5,0 1-2"/>)").points, GivenPoints(triangle));
  EXPECT_EQ(svg(R"(<g><path d="M0 0h1.5L1-2z"/></g>)").points.exact(), triangle);
  EXPECT_EQ(svg(R"(<path d="m 0,0 1.5,0 -.5 -2 Z"/>)").points.exact(), triangle);
  EXPECT_EQ(svg(R"(<path d="M1 1h2v1zl1 3"/>)").points.exact(), (Points{{1, 1, 0}, {3, 1, 0}, {3, 2, 0}, {2, 4, 0}}));
  EXPECT_EQ(svg(R"(<path d="M 9 9 M 1 1 H 2 V 3"/>)").points.exact(), (Points{{1, 1, 0}, {2, 1, 0}, {2, 3, 0}}));
  EXPECT_EQ(svg(R"(<defs><circle r="4"/></defs><rect x="1" width="2" height="0.5"/>)").points.exact(),
            (Points{{1, 0, 0}, {3, 0, 0}, {3, mpq_class(1, 2), 0}, {1, mpq_class(1, 2), 0}}));
  EXPECT_EQ(svg(R"(<circle cx="1" cy="2" r="0.1"/>)").shape,
            (Shape{fathom::hull(Points{{1, 2, 0}}).core, mpq_class(1, 10)}));
  EXPECT_EQ(svg(R"(<line x2="3" y2="4"/>)").points.exact(), (Points{{0, 0, 0}, {3, 4, 0}}));
}

Body svg_body(const std::string& shapes) { return parse_mesh("<svg>" + shapes + "</svg>", "x.svg", Decimals::exact); }

TEST(Plane, TransformsOfDrawingsAreExact) {
  const auto line = [](const std::string& transform) {
    return svg_body("<line x1='1' y1='0' x2='5' y2='2' transform='" + transform + "'/>").points.exact();
  };
  EXPECT_EQ(line(" "), (Points{{1, 0, 0}, {5, 2, 0}}));
  EXPECT_EQ(line("matrix(1 2 3 4 .5 -6)"), (Points{{mpq_class(3, 2), -4, 0}, {mpq_class(23, 2), 12, 0}}));
  EXPECT_EQ(line("translate(0.1)"), (Points{{mpq_class(11, 10), 0, 0}, {mpq_class(51, 10), 2, 0}}));
  EXPECT_EQ(line("translate ( 1 , -2 )"), (Points{{2, -2, 0}, {6, 0, 0}}));
  EXPECT_EQ(line("scale(3)"), (Points{{3, 0, 0}, {15, 6, 0}}));
  EXPECT_EQ(line("scale(3,-1)"), (Points{{3, 0, 0}, {15, -2, 0}}));
  EXPECT_EQ(line("rotate(90)"), (Points{{0, 1, 0}, {-2, 5, 0}})) << "law: x goes to y";
  EXPECT_EQ(line("rotate(180)"), (Points{{-1, 0, 0}, {-5, -2, 0}}));
  EXPECT_EQ(line("rotate(-90)"), line("rotate(270)"));
  EXPECT_EQ(line("rotate(90)rotate(270)"), line("rotate(720)"));
  EXPECT_EQ(line("rotate(90 5 2)"), (Points{{7, -2, 0}, {5, 2, 0}})) << "law: about the point, which stays";
  EXPECT_EQ(line("translate(1 2), scale(3)"), (Points{{4, 2, 0}, {16, 8, 0}})) << "law: the last one is first";
  EXPECT_EQ(svg_body("<g transform='translate(1 2)'><a><g transform='scale(3)'>"
                     "<line x1='1' x2='5' y2='2'/></g></a></g>")
                .points.exact(),
            line("translate(1 2) scale(3)"))
      << "law: groups around it multiply";
  EXPECT_EQ(
      parse_mesh("<svg transform='scale(2)'><g transform='scale(9)'/><line x2='1'/></svg>", "x.svg", Decimals::exact)
          .points.exact(),
      (Points{{0, 0, 0}, {2, 0, 0}}))
      << "law: of what is beside it nothing is applied";
  const auto circle = [](const std::string& transform) {
    return *svg_body("<circle cx='1' r='0.5' transform='" + transform + "'/>").shape;
  };
  EXPECT_EQ(circle("translate(1 2) scale(-3)"), (Shape{fathom::hull(Points{{-2, 2, 0}}).core, mpq_class(3, 2)}));
  EXPECT_EQ(circle("matrix(6 8 8 -6 0 1)"), (Shape{fathom::hull(Points{{6, 9, 0}}).core, 5})) << "law: mirrored too";
}

TEST(Plane, StylesOfDrawingsDoNotMove) {
  const auto styled = [](const std::string& style) {
    return svg_body("<g style='" + style + "'><line x1='1' x2='5' y2='2'/></g>").points.exact();
  };
  for (const char* const style : {"", "text-transform:none", "fill:red; text-transform : none;", "scaled:2", "fill"})
    EXPECT_EQ(styled(style), (Points{{1, 0, 0}, {5, 2, 0}})) << style;
  for (const char* const style : {"scale:2", "fill:red; Scale : 2", "rotate:90deg", "translate:1px 2px",
                                  "transform:none", ";transform-origin:0 0;"})
    EXPECT_THROW(styled(style), InputError) << style;
}

TEST(Plane, HasShortWords) {
  const auto word = [](const std::string& text) { return files::parse_shape(text, Decimals::exact); };
  const auto said = [&](const std::string& text) -> std::string {
    try {
      word(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const Body box = word("plane:box:half=1:2,at=3:4,half_angle=1");
  EXPECT_EQ(box.dimension, 2U);
  EXPECT_EQ(box.points.exact(), (Points{{5, 3, 0}, {5, 5, 0}, {1, 5, 0}, {1, 3, 0}})) << "law: a quarter turn, then at";
  EXPECT_EQ(word("plane:circle:r=0.1").shape, (Shape{fathom::hull(Points{{}}).core, mpq_class(1, 10)}));
  EXPECT_EQ(word("plane:capsule:r=1,h=2").shape, capsule(1, 2, Axis::x)) << "law: along x unless it is said";
  EXPECT_EQ(word("plane:capsule:r=1,h=2,axis=y").shape, capsule(1, 2, Axis::y));
  EXPECT_EQ(word("plane:rounded_box:half=1:1,margin=2").shape->radius, 2);
  EXPECT_EQ(word("plane:halfplane:normal=0:2,offset=3").shape, halfspace({0, 2, 0}, 3));
  for (const char* const name : {"plane:circle:r=1", "plane:box:", "plane:disc:r=1"})
    EXPECT_TRUE(files::is_shape_text(name)) << name;
  for (const char* const name : {"plane:", "plane:x.txt", "plane:circle"})
    EXPECT_FALSE(files::is_shape_text(name)) << name;
  EXPECT_EQ(said("circle:r=1"),
            "circle:r=1: expected one of the shapes sphere, capsule, tapered_capsule, box, cylinder, cone, frustum, "
            "ellipsoid, hull, triangle, halfspace, sum; found 'circle': of the plane, it is plane:circle:...");
  EXPECT_EQ(said("plane:sphere:r=1"),
            "plane:sphere:r=1: expected one of the shapes circle, capsule, box, polygon, halfplane; found 'sphere'");
  EXPECT_EQ(said("plane:circle:r=1,quaternion=1:0:0:0"),
            "plane:circle:r=1,quaternion=1:0:0:0: expected a field of a circle: radius, margin, at or half_angle; "
            "found 'quaternion'");
  EXPECT_EQ(said("plane:circle:r=1,at=1:2:3"),
            "plane:circle:r=1,at=1:2:3: expected 2 numbers joined by colons, found '1:2:3'");
  EXPECT_EQ(said("plane:capsule:r=1,h=1,axis=z"), "plane:capsule:r=1,h=1,axis=z: expected the axis x or y, found 'z'");
  EXPECT_EQ(said("plane:polygon:margin=1"),
            "plane:polygon:margin=1: a polygon has no short form: give it in a case, or a file");
  EXPECT_EQ(said("box:half=1:2:3,half_angle=1"),
            "box:half=1:2:3,half_angle=1: expected a field of a box: half, margin, at or quaternion; found "
            "'half_angle'");
}

}  // namespace
}  // namespace fathom::plane
