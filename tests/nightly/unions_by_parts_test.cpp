// SPDX-License-Identifier: GPL-3.0-or-later
// The second way for unions: it finds known answers, takes each of its ways, and says what is wrong
// with a wrong first way.
#include "tests/nightly/unions_by_parts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "tests/support/stated_cases.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::nightly {
namespace {

using harness::UnionsFound;

Case case_of(const Pieces& a, const Pieces& b) {
  const auto body = [](const Pieces& pieces) {
    return Body{.points = {}, .pieces = std::make_shared<const Pieces>(pieces)};
  };
  return {"case", body(a), body(b)};
}

/// Two slabs that make a cube of side 4; with a gap between them if `gap` is not 0.
Pieces slabs(const mpq_class& gap = 0) {
  return {unions::box({0, 0, 0}, {4, 4, 2}), unions::box({0, 0, mpq_class(2 + gap)}, {4, 4, mpq_class(4 + gap)})};
}

TEST(UnionsByParts, TakesTheWayThatFits) {
  const Pieces cube{unions::box({3, 1, 1}, {6, 2, 2})};
  const auto taken = [](const Pieces& a, const Pieces& b, const UnionsFound& expected) {
    Part part{};
    const UnionsFound found = unions_by_parts(case_of(a, b), nullptr, &part);
    EXPECT_EQ(found.status, expected.status);
    EXPECT_EQ(found.squared, expected.squared);
    EXPECT_EQ(found.translations, expected.translations);
    return part;
  };
  EXPECT_EQ(taken(slabs(), cube, {Status::penetrating, 1, {{-1, 0, 0}}}), Part::whole);
  EXPECT_EQ(taken(slabs(mpq_class(1, 8)), cube, {Status::penetrating, 1, {{-1, 0, 0}}}), Part::planes)
      << "with a gap it is not convex";
  Pieces overlapping = slabs();
  overlapping.push_back(overlapping.front());
  EXPECT_EQ(taken(overlapping, cube, {Status::penetrating, 1, {{-1, 0, 0}}}), Part::whole)
      << "a piece may be there twice";
  overlapping.back() = unions::box({0, 0, 1}, {4, 4, 3});
  EXPECT_EQ(taken(overlapping, cube, {Status::penetrating, 1, {{-1, 0, 0}}}), Part::planes)
      << "law: pieces that overlap fill less";
  EXPECT_EQ(taken(slabs(), {unions::box({4, 0, 0}, {5, 1, 1})}, {Status::touching, 0, {}}), Part::none);
  EXPECT_EQ(taken(slabs(), {unions::box({6, 7, 0}, {8, 9, 1})}, {Status::disjoint, 13, {}}), Part::none);
}

TEST(UnionsByParts, KnowsTheCatalogue) {
  for (const families::UnionCatalogueEntry& entry : families::union_catalogue()) {
    SCOPED_TRACE(entry.pair.id);
    const UnionsFound found = unions_by_parts(entry.pair, nullptr);
    EXPECT_EQ(found.status, entry.status);
    EXPECT_EQ(found.squared, entry.squared);
    EXPECT_EQ(found.translations.size(), entry.status == Status::penetrating ? entry.optima : 0);
  }
}

TEST(UnionsByParts, KnowsTheAnswersOfRealCases) {
  std::size_t cases = 0;
  for (const auto& [pair, line, answer] : testing::stated_cases()) {
    if (!pair.a.pieces && !pair.b.pieces) continue;
    SCOPED_TRACE(pair.id);
    const UnionsFound found = unions_by_parts(pair, nullptr);
    EXPECT_EQ(name(found.status), answer["status"]);
    EXPECT_EQ(found.squared.get_str(), answer["signed_depth"]["exact"]["root"]);
    EXPECT_EQ(testing::translation_texts(found.translations), answer["translations"]);
    ++cases;
  }
  EXPECT_EQ(cases, 9U);
}

TEST(UnionsByParts, AgreesWithTheSearchOnEveryFamily) {
  std::array<int, 4> taken{};
  for (std::uint64_t number = 0; number < 108; ++number) {
    const Case pair = harness::random_unions(3, number);
    Part part{};
    harness::Solver parts = second_solver();
    parts.of_unions = [&](const Case& about, Monitor* monitor) { return unions_by_parts(about, monitor, &part); };
    EXPECT_EQ(harness::difference(pair, harness::solver_with_proof(), parts).value_or(""), "") << pair.id;
    ++taken.at(static_cast<std::size_t>(part));
  }
  for (const int count : taken) EXPECT_GT(count, 5) << "law: each way is taken now and then";
  EXPECT_LT(taken.back(), 108 / 3) << "law: the search is seldom its own second way";
}

TEST(UnionsByParts, DifferencesAreTold) {
  const Case pair = case_of(slabs(), slabs(mpq_class(1, 8)));
  const harness::Solver right = harness::solver_with_proof();
  const auto told = [&](void (*change)(UnionsFound&)) {
    harness::Solver wrong = second_solver();
    wrong.of_unions = [change, second = wrong.of_unions](const Case& about, Monitor* monitor) {
      UnionsFound found = second(about, monitor);
      change(found);
      return found;
    };
    return harness::difference(pair, right, wrong).value_or("");
  };
  EXPECT_EQ(told([](UnionsFound&) {}), "");
  EXPECT_EQ(told([](UnionsFound& found) { found.status = Status::touching; }),
            "automatic and exact differ: status: penetrating and touching");
  EXPECT_EQ(told([](UnionsFound& found) { found.squared += 1; }), "automatic and exact differ: squared: 16 and 17");
  EXPECT_EQ(told([](UnionsFound& found) {
              found.translations.resize(1);
            }).find("automatic and exact differ: translations: ("),
            0U);
  EXPECT_EQ(told([](UnionsFound&) { throw std::logic_error("broken law: x"); }), "exact gave no answer: broken law: x");
}

}  // namespace
}  // namespace fathom::nightly
