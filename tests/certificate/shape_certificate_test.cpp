// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of shapes: each holds by the naive check, says what the answer says, and fails once
// it is bent.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/patch.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/shapes/core.hpp"
#include "tests/support/prepared.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom::certificate {
namespace {

std::vector<Case> few_cases() {
  std::vector<Case> cases = testing::cases_of_all_families(2, 10);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  return cases;
}

ShapeCertificate certificate_of(const Shape& a, const Shape& b) { return make_certificate(a, b, signed_depth(a, b)); }

void expect_holds(const ShapeCertificate& certificate, const std::string& id) {
  const kernels::Report report = validate(certificate);
  EXPECT_TRUE(report.ok()) << id << "\n" << testing::text(report);
}

TEST(ShapeCertificate, OfRoundedPolytopesHolds) {
  for (const Case& input : few_cases()) {
    const Shape a = with_margin(hull(input.a.points), mpq_class(1, 3)), b = hull(input.b.points);
    const SignedDepth depth = signed_depth(a, b);
    const ShapeCertificate certificate = make_certificate(a, b, depth);
    expect_holds(certificate, input.id);
    const mpq_class sign = certificate.claim == ShapeClaim::apart ? -1 : 1;
    EXPECT_EQ(compare(*depth.exact(), Surd{mpq_class(1, 3), sign * certificate.low}), 0) << input.id;
    EXPECT_EQ(certificate.directions.front(), depth.direction()) << input.id;
    EXPECT_EQ(certificate.cone.has_value(), certificate.claim == ShapeClaim::touching) << input.id;
  }
}

TEST(ShapeCertificate, OfHalfSpacesAndSumsHolds) {
  const Shape sum = minkowski_sum(box({1, 1, 1}), capsule(1, 2));
  for (const mpq_class& offset : {mpq_class(-5), mpq_class(-3), mpq_class(1, 7)}) {
    expect_holds(certificate_of(sum, halfspace({0, 0, 3}, 3 * offset)), "b");
    expect_holds(certificate_of(halfspace({0, 1, 3}, offset), sum), "a");
    expect_holds(certificate_of(sum, with_margin(hull(std::vector<Point>{{offset, 3, 0}, {0, 0, 1}}), 1)), "points");
  }
}

// Small bodies that touch in every way.
TEST(ShapeCertificate, OfTouchingCoresProvesAllDirections) {
  families::Random random(8);
  for (int found = 0; found < 400;) {
    std::vector<Point> a(static_cast<std::size_t>(random.between(1, random.coin() ? 2 : 6))),
        b(static_cast<std::size_t>(random.between(1, random.coin() ? 2 : 6)));
    for (std::vector<Point>* body : {&a, &b})
      for (Point& p : *body)
        p = {mpq_class(random.between(-1, 1)), mpq_class(random.between(-1, 1)), mpq_class(random.between(-1, 1))};
    const SignedDepth depth = signed_depth(hull(a), hull(b));
    if (!depth.cone) continue;
    ++found;
    ShapeCertificate certificate = make_certificate(hull(a), hull(b), depth);
    expect_holds(certificate, "touching");
    ConeProof& proof = *certificate.cone;
    if (proof.cone.rays.size() < 3) continue;
    EXPECT_EQ(proof.differences.size(), proof.cone.rays.size()) << "one for each facet";
    proof.differences.pop_back();
    EXPECT_FALSE(validate(proof, a, b).ok()) << "a facet without proof";
  }
}

TEST(ShapeCertificate, IsInFormat1WhereThatCanSayIt) {
  const Shape cube = box({1, 1, 1}), aside = moved(cube, {{{1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  const Shape beside = moved(cube, {{{1, 0, 0, 2}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  const auto text = [](const Shape& a, const Shape& b, ShapeFormat format) {
    return certificate_text(a, b, signed_depth(a, b), "x", format);
  };
  const auto claim = [&](const Shape& a, const Shape& b, ShapeFormat format) {
    const std::string all = text(a, b, format);
    const std::size_t start = all.find("\nclaim ") + 1;
    return all.substr(0, all.find('\n')) + ": " + all.substr(start, all.find('\n', start) - start);
  };
  std::vector<Point> corners;
  for (const Atom& atom : std::get<std::vector<Term>>(cube.core)[0].atoms) corners.push_back(atom.center);
  EXPECT_EQ(text(cube, cube, ShapeFormat::richest),
            certificate_text(corners, corners, penetration_depth(corners, corners), "x"));
  EXPECT_EQ(claim(cube, aside, ShapeFormat::shortest), "fathom-certificate 2: claim apart 9");
  EXPECT_EQ(claim(cube, aside, ShapeFormat::richest), "fathom-certificate 2: claim apart 9");
  EXPECT_EQ(claim(cube, beside, ShapeFormat::shortest), "fathom-certificate 1: claim touching");
  EXPECT_EQ(claim(cube, beside, ShapeFormat::richest), "fathom-certificate 2: claim touching");
  EXPECT_EQ(claim(with_margin(cube, 1), cube, ShapeFormat::shortest), "fathom-certificate 2: claim depth 4");
  EXPECT_EQ(claim(sphere(2), aside, ShapeFormat::shortest), "fathom-certificate 2: claim apart 16");
}

TEST(ShapeCertificate, InPrint) {
  const Shape a = capsule(mpq_class(1, 2), 1, Axis::x), b = halfspace({0, 0, 2}, -3);
  EXPECT_EQ(certificate_text(a, b, signed_depth(a, b), "rest"),
            "fathom-certificate 2\nid rest\na 2\n-1 0 0\n1 0 0\nradius_a 1/2\nhalfspace_b 0 0 2 -3\nclaim apart "
            "9/4\ndirections 1 some\n0 0 1\n"
            "end 2 1\n");
  const Shape c = capsule(1, 1, Axis::y);
  EXPECT_EQ(certificate_text(a, c, signed_depth(a, c)),
            "fathom-certificate 2\na 2\n-1 0 0\n1 0 0\nradius_a 1/2\nb 2\n0 -1 0\n0 1 0\nradius_b 1\nclaim "
            "touching\ndirections 1 some\n0 0 -1\n"
            "weights_a 2\n0 1/2\n1 1/2\nweights_b 2\n0 1/2\n1 1/2\nlineality 1\n0 0 1\nrays 0\ndifferences 4\n1 0\n1 "
            "1\n0 1\n0 0\n"
            "end 2 2 1 2 2 1 0 4\n");
}

// As any search for bounds would leave them.

/// Points on the rims, at four sides: those of the low rim first.
std::vector<InnerPoint> rim_points() {
  std::vector<InnerPoint> points;
  for (const std::uint32_t atom : {0U, 1U})
    for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) points.push_back({{atom, {x, y}}});
  return points;
}

/// Cylinders, one above the other's middle: B from 1/2 to 5/2.
ShapeCertificate of_cylinders() {
  ShapeCertificate c;
  c.a = cylinder(1, 1);
  c.b =
      moved(with_margin(cylinder(1, 1), mpq_class(1, 10)), {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, mpq_class(3, 2)}}});
  c.claim = ShapeClaim::signed_bounds;
  c.low = mpq_class(-4, 10);
  c.high = mpq_class(6, 10);
  c.low.canonicalize();
  c.high.canonicalize();
  c.directions = {{0, 0, -1}};
  c.heights_a = {1};
  c.heights_b = {mpq_class(-1, 2)};
  c.inner_a = c.inner_b = rim_points();
  c.weights_a = {{4, mpq_class(1, 2)}, {6, mpq_class(1, 2)}};  // (0,0,1)
  c.weights_b = {{0, mpq_class(1, 2)}, {2, mpq_class(1, 2)}};  // (0,0,1/2)
  return c;
}

TEST(ShapeCertificate, OfBoundsHoldsAndIsWritten) {
  const ShapeCertificate c = of_cylinders();
  expect_holds(c, "weights");
  const std::string text = certificate_text(c);
  EXPECT_NE(text.find("shape_a 1\nterm 2\ndisc 0 0 -1 1 0 0 0 1 0\ndisc 0 0 1 1 0 0 0 1 0\nshape_b 1\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("claim signed_bounds -2/5 3/5\ndirections 1 some\n0 0 -1\nheights_a 1\n1\nheights_b "
                      "1\n-1/2\ninner_a 8\n0 1 0 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("end 1 2 1 2 1 1 1 8 8 2 2\n"), std::string::npos);
  const std::vector<std::pair<const char*, std::function<void(ShapeCertificate&)>>> bent{
      {"height", [](ShapeCertificate& d) { d.heights_a[0] -= mpq_class(1, 1000); }},
      {"upper", [](ShapeCertificate& d) { d.high -= mpq_class(1, 1000); }},
      {"lower", [](ShapeCertificate& d) { d.low += mpq_class(1, 1000); }},
      {"place",
       [](ShapeCertificate& d) {
         d.inner_a[0][0].local = {1, mpq_class(1, 1000)};
       }},
      {"radius", [](ShapeCertificate& d) { d.b.radius = 0; }},
      {"weight", [](ShapeCertificate& d) { d.weights_a[0].weight += 1; }},
      {"atom", [](ShapeCertificate& d) { d.inner_a[0][0].atom = 2; }},
      {"direction",
       [](ShapeCertificate& d) {
         d.directions = {{0, 0, 1}};
       }},
  };
  for (const auto& [name, bend] : bent) {
    ShapeCertificate d = c;
    bend(d);
    EXPECT_FALSE(validate(d).ok()) << name;
  }
}

TEST(ShapeCertificate, OfBoundsByAPolytopeHolds) {
  ShapeCertificate c = of_cylinders();
  c.b = with_margin(c.a, 1);
  c.heights_b = {1};
  c.weights_a = c.weights_b = {};
  c.high = 3;
  // The octahedron of radius 2: its facets are at 2/sqrt(3).
  c.inner.vertices = {{2, 0}, {0, 2}, {3, 1}, {1, 3}, {0, 4}, {4, 0}};
  c.inner.facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  c.low = mpq_class(2154, 1000);
  c.low.canonicalize();
  expect_holds(c, "facets");
  c.low = -7;
  expect_holds(c, "facets, and nearly nothing said");
  c.low = mpq_class(431, 200);
  EXPECT_FALSE(validate(c).ok()) << "beyond the facets";
}

TEST(ShapeCertificate, OfACurvedBodyOnAPlane) {
  ShapeCertificate c;
  c.a = cone(3, 4);
  c.b = halfspace({0, 0, 1}, -4);
  c.claim = ShapeClaim::signed_bounds;
  c.directions = {{0, 0, 1}};
  c.heights_a = {4};
  c.inner_a = {{{0, {0, 0}}}};
  expect_holds(c, "touching");
  EXPECT_EQ(certificate_text(c),
            "fathom-certificate 2\nshape_a 1\nterm 2\ndisc 0 0 -4 3 0 0 0 3 0\npoint 0 0 4\nhalfspace_b 0 0 1 -4\n"
            "claim signed_bounds 0 0\ndirections 1 some\n0 0 1\nheights_a 1\n4\ninner_a 1\n0 0 0 0\nend 1 2 1 1 1\n");
  c.inner_a = {{{1, {}}}};
  EXPECT_FALSE(validate(c).ok()) << "the apex is not at the plane";
}

TEST(ShapeCertificate, IsRefusedOnceBent) {
  const Shape cube = with_margin(box({1, 1, 1}), 1), aside = moved(cube, {{{1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  const ShapeCertificate apart = certificate_of(cube, aside), deep = certificate_of(cube, cube),
                         plane = certificate_of(cube, halfspace({1, 0, 0}, 1));
  for (const ShapeCertificate* good : {&apart, &deep, &plane}) {
    expect_holds(*good, "unbent");
    const std::vector<std::pair<const char*, std::function<void(ShapeCertificate&)>>> bent{
        {"larger", [](ShapeCertificate& c) { c.low += 1, c.high += 1; }},
        {"claim", [](ShapeCertificate& c) { c.claim = ShapeClaim::touching; }},
        {"direction",
         [](ShapeCertificate& c) {
           c.directions[0] = {1, 1, 0};
         }},
        {"opposite",
         [](ShapeCertificate& c) { c.claim = c.claim == ShapeClaim::apart ? ShapeClaim::depth : ShapeClaim::apart; }},
    };
    for (const auto& [name, bend] : bent) {
      ShapeCertificate c = *good;
      bend(c);
      EXPECT_FALSE(validate(c).ok()) << name;
    }
  }
  ShapeCertificate far = apart;
  far.weights_a = {{0, 1}};
  EXPECT_FALSE(validate(far).ok());
}

TEST(ShapeCertificate, ContradictsAnAnswerAboutOtherBodies) {
  const Shape cube = box({1, 1, 1}), rounded = with_margin(cube, 1);
  EXPECT_THROW(make_certificate(cube, cube, signed_depth(cube, rounded)), std::logic_error);
  const auto east = [&](long x) { return moved(cube, {{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, 0}}}); };
  const Shape south = moved(cube, {{{1, 0, 0, 0}, {0, 1, 0, 5}, {0, 0, 1, 0}}});
  EXPECT_THROW(make_certificate(cube, east(6), signed_depth(cube, east(5))), std::logic_error) << "another distance";
  EXPECT_THROW(make_certificate(cube, south, signed_depth(cube, east(5))), std::logic_error) << "another direction";
  EXPECT_THROW(make_certificate(cube, east(3), signed_depth(cube, east(2))), std::logic_error) << "not even touching";
  EXPECT_THROW(make_certificate(cube, halfspace({1, 0, 0}, 1), signed_depth(cube, halfspace({1, 0, 0}, 2))),
               std::logic_error);
}

}  // namespace
}  // namespace fathom::certificate

// Certificates of shapes before the independent checkers: fathom-check's library and check.py print
// what the answer says.

namespace fathom {
namespace {

struct Pair {
  std::string id;
  Shape a, b;
};

Point small_point(families::Random& random) {
  return {mpq_class(random.between(-1, 1)), mpq_class(random.between(-1, 1)), mpq_class(random.between(-1, 1))};
}

/// Rounded polytopes of all families and of the catalogue; small bodies, which often touch;
/// half-spaces against sums.
std::vector<Pair> pairs() {
  std::vector<Pair> result;
  for (const Case& input : testing::cases_of_all_families(1, 10))
    result.push_back({input.id, with_margin(hull(input.a.points), mpq_class(1, 3)), hull(input.b.points)});
  for (const families::CatalogueEntry& entry : families::catalogue())
    result.push_back({std::string(entry.name), hull(entry.pair.a.points), with_margin(hull(entry.pair.b.points), 2)});
  families::Random random(9);
  for (int i = 0; i < 500; ++i) {
    std::vector<Point> a(static_cast<std::size_t>(random.between(1, random.coin() ? 2 : 6)));
    std::vector<Point> b(static_cast<std::size_t>(random.between(1, random.coin() ? 2 : 6)));
    for (std::vector<Point>* body : {&a, &b})
      for (Point& p : *body) p = small_point(random);
    result.push_back(
        {"small-" + std::to_string(i), hull(a), with_margin(hull(b), families::ratio(random.between(0, 3), 2))});
  }
  const Shape sum = minkowski_sum(box({1, 2, 3}), capsule(1, 2));
  for (int i = 0; i < 60; ++i) {
    const Point normal{mpq_class(random.between(-3, 3)), mpq_class(random.between(-3, 3)), 1};
    const Shape half = with_margin(halfspace(normal, mpq_class(random.between(-9, 9))), mpq_class(i % 3));
    result.push_back({"half-a-" + std::to_string(i), half, sum});
    result.push_back({"half-b-" + std::to_string(i), sum, half});
  }
  return result;
}

std::string expected_line(const SignedDepth& depth, const ShapeCertificate& certificate) {
  const Surd& value = *depth.exact();
  std::string line = "s VERIFIED " + std::string(name(depth.status().value())) + " signed_depth=";
  line += (certificate.claim == ShapeClaim::apart ? "-sqrt(" : "sqrt(") + mpq_class(abs(value.root)).get_str() + ")+" +
          value.rational.get_str();
  if (certificate.complete) line += " optima=" + std::to_string(depth.translations().size());
  if (certificate.cone)
    line += " cone=" + std::to_string(static_cast<int>(certificate.cone->cone.lineality)) + "+" +
            std::to_string(depth.cone->rays.size());
  return line + " " + certificate.id;
}

/// The line about a certificate with patches: that of the answer, and how many corners and rates
/// there are.
std::string with_patches(std::string line, const std::string& id, const ContactGeometry& geometry, std::size_t rates) {
  line.resize(line.size() - id.size());
  for (std::size_t i = 0; i < geometry.patches.size(); ++i)
    line += (i == 0 ? "patches=" : "+") + std::to_string(geometry.patches[i].corners.size());
  if (rates > 0) line += " rates=" + std::to_string(rates);
  return line + " " + id + "-with-patches";
}

TEST(ShapeCheckers, AcceptEveryCertificateWithTheAnswer) {
  const std::string path = ::testing::TempDir() + "shape_checkers_test.cert";
  std::ofstream file(path);
  std::vector<std::string> expected;
  families::Random random(2);
  for (const auto& [id, a, b] : pairs()) {
    const SignedDepth depth = signed_depth(a, b);
    ShapeCertificate certificate = make_certificate(a, b, depth);
    certificate.id = id;
    const std::string text = certificate_text(certificate);
    expected.push_back(expected_line(depth, certificate));
    EXPECT_EQ(fathom_check::verdict_line(fathom_check::verify(text), id), expected.back());
    file << text;

    const Body body_a{{}, a}, body_b{{}, b};
    const Answer answer{depth};
    const ContactGeometry geometry = contact_geometry(body_a, body_b, answer);
    const std::vector<Twist> motions{{{1, 0, mpq_class(-1, 2)}, {0, 3, 1}}, {small_point(random), small_point(random)}};
    const std::string of_patches = certificate_text(body_a, body_b, answer, geometry, motions, id + "-with-patches");
    EXPECT_TRUE(of_patches.starts_with("fathom-certificate 4\n")) << id;
    const bool half = shapes::is_halfspace(a) || shapes::is_halfspace(b);
    expected.push_back(with_patches(expected.back(), id, geometry, geometry.cone && !half ? 0 : motions.size()));
    EXPECT_EQ(fathom_check::verdict_line(fathom_check::verify(of_patches), id), expected.back());
    file << of_patches;
  }
  file.close();
  const std::string command = "python3 -B \"" FATHOM_TEST_DATA "/../../verify/check/check.py\" \"" + path + "\"";
  std::FILE* const pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string printed;
  std::array<char, 4096> block{};
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), pipe)) printed.append(block.data(), size);
  EXPECT_EQ(pclose(pipe), 0);
  std::string all;
  for (const std::string& line : expected) all += line + "\n";
  EXPECT_EQ(printed, all);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace fathom
