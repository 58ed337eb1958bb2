// SPDX-License-Identifier: Apache-2.0
// How a project that computes penetration depths tests itself with golden cases and GoogleTest.
// CMakeLists.txt beside it gets the sample of them; `fathom golden export --format c` makes other
// ones.
#include <fathom_golden_sample.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace {

using Vector = std::array<double, 3>;
using Points = std::vector<Vector>;

Points points(const double* numbers, std::size_t count) {
  Points result;
  for (std::size_t i = 0; i < count; ++i) result.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
  return result;
}

// ---- what stands for the project's own code: the separating axis test over all triples of points
// and all pairs of differences ----

Vector minus(const Vector& p, const Vector& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Points differences(const Points& body) {
  Points result;
  for (std::size_t i = 0; i < body.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) result.push_back(minus(body[i], body[j]));
  return result;
}

/// The normals of all facets are among these, and if there are two bodies those of pairs of edges.
void add_crosses(const Points& edges, const Points& others, Points& axes) {
  for (const Vector& edge : edges)
    for (const Vector& other : others) axes.push_back(cross(edge, other));
}

struct Answer {
  bool overlap = true;
  double depth = HUGE_VAL;
  Vector direction{};
};

enum class Axes { all, of_facets };

Answer penetration(const Points& a, const Points& b, Axes which) {
  const Points edges_of_a = differences(a), edges_of_b = differences(b);
  Points axes;
  add_crosses(edges_of_a, edges_of_a, axes);
  add_crosses(edges_of_b, edges_of_b, axes);
  if (which == Axes::all) add_crosses(edges_of_a, edges_of_b, axes);
  Answer answer;
  for (const Vector& axis : axes) {
    const double length = std::sqrt(dot(axis, axis));
    if (length == 0) continue;
    double least_a = HUGE_VAL, greatest_a = -HUGE_VAL, least_b = HUGE_VAL, greatest_b = -HUGE_VAL;
    for (const Vector& p : a)
      least_a = std::min(least_a, dot(axis, p)), greatest_a = std::max(greatest_a, dot(axis, p));
    for (const Vector& p : b)
      least_b = std::min(least_b, dot(axis, p)), greatest_b = std::max(greatest_b, dot(axis, p));
    for (const double sign : {1.0, -1.0}) {
      const double depth = (sign > 0 ? greatest_b - least_a : greatest_a - least_b) / length;
      if (depth < answer.depth)
        answer.depth = depth, answer.direction = {sign * axis[0], sign * axis[1], sign * axis[2]};
    }
  }
  answer.overlap = answer.depth > 0;
  return answer;
}

// ---- the tests ----

bool right(const fathom_golden_case& golden, Axes which) {
  const Answer answer = penetration(points(golden.a, golden.a_count), points(golden.b, golden.b_count), which);
  const fathom_golden_tolerance tolerance = {1e-9, 1e-12};
  if (!answer.overlap) return fathom_golden_accept_apart(&golden, tolerance);
  return fathom_golden_accept(&golden, answer.direction.data(), answer.depth, tolerance);
}

TEST(Penetration, IsRightInEveryGoldenCase) {
  for (const fathom_golden_case& golden : fathom_golden_cases)
    EXPECT_TRUE(right(golden, Axes::all))
        << golden.name << ", whose signed depth is " << golden.signed_depth << "; " << golden.flags;
}

TEST(Penetration, WithoutPairsOfEdgesIsFoundToBeWrong) {
  int wrong = 0;
  for (const fathom_golden_case& golden : fathom_golden_cases) wrong += right(golden, Axes::of_facets) ? 0 : 1;
  EXPECT_GT(wrong, 0);
}

}  // namespace
