// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of shapes before the independent checkers: fathom-check's library and check.py print
// what the answer says.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/certificate.hpp"
#include "tests/support/prepared.hpp"
#include "verify/check/check.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/random.hpp"

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

TEST(ShapeCheckers, AcceptEveryCertificateWithTheAnswer) {
  const std::string path = ::testing::TempDir() + "shape_checkers_test.cert";
  std::ofstream file(path);
  std::vector<std::string> expected;
  for (const auto& [id, a, b] : pairs()) {
    const SignedDepth depth = signed_depth(a, b);
    ShapeCertificate certificate = make_certificate(a, b, depth);
    certificate.id = id;
    const std::string text = certificate_text(certificate);
    expected.push_back(expected_line(depth, certificate));
    EXPECT_EQ(fathom_check::verdict_line(fathom_check::verify(text), id), expected.back());
    file << text;
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
