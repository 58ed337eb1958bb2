// SPDX-License-Identifier: GPL-3.0-or-later
// The filter of the scan over pairs of arcs against exact signs: whatever it leaves out does not cross, or is strictly farther.
#include <gtest/gtest.h>

#include "kernels/filters/line_filter.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "tests/support/line_scenes.hpp"
#include "tests/support/signs.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

/// Arcs of a diagram of rank 3, with lines along their circles' normals.
struct Arcs {
  gaussian::GaussianDiagram diagram;
  std::vector<Line> lines;
  [[nodiscard]] const gaussian::Arc& arc(std::size_t i) const { return diagram.arcs[gaussian::ArcId(static_cast<std::uint32_t>(i))]; }
};

/// Arcs of small integers, rank 3 or (half-circles between the poles) rank 2: shared ends, ends on circles, overlaps.
Arcs random_arcs(Random& random, int rank, unsigned long size, int n) {
  Arcs arcs;
  arcs.diagram.rank = rank;
  const auto add = [&](const Vector& from, const Vector& to, const Vector& circle) {
    const auto node = static_cast<std::uint32_t>(arcs.diagram.nodes.size());
    arcs.diagram.nodes.emplace_back(from);
    arcs.diagram.nodes.emplace_back(to);
    arcs.diagram.arcs.push_back({Direction(circle), gaussian::NodeId(node), gaussian::NodeId(node + 1), {}, {}});
    arcs.lines.push_back({random_vector(random, size), circle});
  };
  const Vector pole = random_direction(random, size);
  while (arcs.lines.size() < static_cast<std::size_t>(n)) {
    const Vector from = rank == 2 ? pole : random_direction(random, size), other = random_direction(random, size);
    const Vector circle = cross(from, other);
    if (!is_zero(circle)) add(from, rank == 2 ? -pole : other, circle);
  }
  return arcs;
}

ArcImages arc_images(const gaussian::GaussianDiagram& diagram) {
  ArcImages result;
  for (const gaussian::Arc& arc : diagram.arcs) result.push_back(diagram.nodes[arc.from].exact(), diagram.nodes[arc.to].exact());
  return result;
}

/// Calls check(i, j, whether the pair came back) for all pairs of two sets of arcs.
template <class Check>
void scan_arcs(const Arcs& one, const Arcs& many, double bound, const Check& check) {
  const std::size_t size = std::max(bits(one.lines[0].point), bits(many.lines[0].point)) + 60;
  const LineImages a = images(Scene{static_cast<long>(size), one.lines}), b = images(Scene{static_cast<long>(size), many.lines});
  const ArcImages arcs_a = arc_images(one.diagram), arcs_b = arc_images(many.diagram);
  std::vector<std::uint32_t> unsure;
  for (std::size_t i = 0; i < a.size(); ++i) {
    crossing_and_not_farther({a, arcs_a}, i, {b, arcs_b}, bound, unsure);
    const std::vector<std::uint32_t> out = left_out(b.size(), unsure);
    for (const std::uint32_t j : unsure) check(i, j, true);
    for (const std::uint32_t j : out) check(i, j, false);
  }
}

// With small integers the images' products are exact up to much less than the least product: the filter decides as exact signs would.
TEST(CrossingAndNotFarther, KeepsThePairsThatTouchAndNoOthers) {
  Random random(11);
  int kept = 0, dropped = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    const Arcs one = random_arcs(random, 2 + repeat % 2, 3, 12), many = random_arcs(random, 2 + repeat / 2 % 2, 3, 70);
    scan_arcs(one, many, infinite, [&](std::size_t i, std::uint32_t j, bool back) {
      const gaussian::Arc &e = one.arc(i), &f = many.arc(j);
      const bool parallel = is_zero(cross(e.circle.exact(), f.circle.exact()));
      ASSERT_EQ(back, parallel || gaussian::touch(one.diagram, e, many.diagram, f));
      ASSERT_TRUE(back || gaussian::strict_crossings(unperturbed().kernel, one.diagram, e, many.diagram, f).empty());
      ++(back ? kept : dropped);
    });
  }
  EXPECT_GT(kept, 5000);
  EXPECT_GT(dropped, 20000);
}

TEST(CrossingAndNotFarther, KeepsWhatBothTestsKeep) {
  Random random(13);
  std::vector<std::uint32_t> crossing, near, both, expected;
  for (int repeat = 0; repeat < 30; ++repeat) {
    const Arcs one = random_arcs(random, 3, 30, 5), many = random_arcs(random, 3, 30, 131);
    const LineImages a = images(Scene{30, one.lines}), b = images(Scene{30, many.lines});
    const ArcImages arcs_a = arc_images(one.diagram), arcs_b = arc_images(many.diagram);
    for (std::size_t i = 0; i < a.size(); ++i) {
      crossing_and_not_farther({a, arcs_a}, i, {b, arcs_b}, infinite, crossing);
      for (const double bound : {least_normal, 0.01, 0.3}) {
        not_farther(a, i, b, bound, near);
        crossing_and_not_farther({a, arcs_a}, i, {b, arcs_b}, bound, both);
        expected.clear();
        std::set_intersection(crossing.begin(), crossing.end(), near.begin(), near.end(), std::back_inserter(expected));
        ASSERT_EQ(both, expected);
      }
    }
  }
}

TEST(CrossingAndNotFarther, LeavesOutOnlyWhatDoesNotCrossOrIsFarther) {
  Random random(12);
  int near = 0, far = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    const unsigned long size = repeat % 4 == 0 ? 4 : repeat % 4 == 1 ? 30 : 400;
    const Arcs one = random_arcs(random, 2 + repeat % 2, size, 6);
    Arcs many = random_arcs(random, 3, size, 30);
    // Ends one unit off the circles of the others.
    for (std::uint32_t k = 0; k < 20; ++k) {
      const Vector& circle = one.lines[k % 6].direction;
      const Vector end = cross(circle, random_direction(random, size)) + random_vector(random, 1);
      const Vector other = many.diagram.nodes[many.diagram.arcs[gaussian::ArcId(k)].to].exact(), normal = cross(end, other);
      if (is_zero(normal)) continue;
      many.diagram.nodes[many.diagram.arcs[gaussian::ArcId(k)].from] = Direction(end);
      many.diagram.arcs[gaussian::ArcId(k)].circle = Direction(normal);
      many.lines[k].direction = normal;
    }
    const long exponent = static_cast<long>(std::max(bits(one.lines[0].point), bits(many.lines[0].point)) + 60);
    const Squared tie = squared_distance(one.lines[1], many.lines[3]);
    if (tie.denominator == 0) continue;
    for (const double bound : {infinite, image_bound(tie.numerator, tie.denominator, exponent), least_normal}) {
      const RoundingMode mode(rounding_modes[repeat / 2 % 4]);
      scan_arcs(one, many, bound, [&](std::size_t i, std::uint32_t j, bool back) {
        const gaussian::Arc &e = one.arc(i), &f = many.arc(j);
        ++(back ? near : far);
        ASSERT_TRUE(back || !gaussian::touch(one.diagram, e, many.diagram, f) ||
                    strictly_farther(one.lines[i], many.lines[j], bound, exponent));
      });
    }
  }
  EXPECT_GT(near, 500);
  EXPECT_GT(far, 5000);
}

}  // namespace
}  // namespace fathom::kernels
