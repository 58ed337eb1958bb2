// SPDX-License-Identifier: GPL-3.0-or-later
// The plain ways to what verify/families/small_world.cpp makes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "fathom/study.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::testing {

/// A signed permutation of the axes about the centre (1, 1, 1).
struct SmallSymmetry {
  std::array<std::size_t, 3> axes;
  std::array<int, 3> signs;
};

inline std::array<int, 3> image(const SmallSymmetry& symmetry, const std::array<int, 3>& p) {
  std::array<int, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = 1 + symmetry.signs[i] * (p[symmetry.axes[i]] - 1);
  return result;
}

/// The identity is the first.
inline std::vector<SmallSymmetry> small_symmetries() {
  std::vector<SmallSymmetry> result;
  for (const auto& axes : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}})
    for (const int x : {1, -1})
      for (const int y : {1, -1})
        for (const int z : {1, -1}) result.push_back({axes, {x, y, z}});
  return result;
}

inline families::SmallPair least_image_naive(const families::SmallPair& pair) {
  static const std::vector<SmallSymmetry> symmetries = small_symmetries();
  families::SmallPair least = pair;
  for (const SmallSymmetry& symmetry : symmetries) {
    families::SmallPair other = pair;
    for (families::SmallTetrahedron* body : {&other.a, &other.b}) {
      for (std::array<int, 3>& p : *body) p = image(symmetry, p);
      std::ranges::sort(*body);
    }
    least = std::min(least, other);
  }
  return least;
}

inline std::vector<Point> points_of(const families::SmallTetrahedron& body) {
  std::vector<Point> points;
  for (const auto& [x, y, z] : body) points.push_back({x, y, z});
  return points;
}

/// Returns the faces of A and B that touch: the corners that are extreme in every direction that
/// separates the bodies. Cross products of two differences have coordinates of at most 8.
inline std::array<std::vector<Point>, 2> touching_faces_naive(const families::SmallPair& pair) {
  constexpr int most = 8;
  std::array<bool, 4> in_a{true, true, true, true}, in_b = in_a;
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z) {
        const auto height = [&](const std::array<int, 3>& p) { return x * p[0] + y * p[1] + z * p[2]; };
        const int least_a = height(*std::ranges::min_element(pair.a, {}, height)),
                  most_b = height(*std::ranges::max_element(pair.b, {}, height));
        if (most_b != least_a) continue;
        for (std::size_t i = 0; i < 4; ++i) {
          in_a[i] = in_a[i] && height(pair.a[i]) == least_a;
          in_b[i] = in_b[i] && height(pair.b[i]) == most_b;
        }
      }
  std::array<std::vector<Point>, 2> result;
  const std::vector<Point> a = points_of(pair.a), b = points_of(pair.b);
  for (std::size_t i = 0; i < 4; ++i) {
    if (in_a[i]) result[0].push_back(a[i]);
    if (in_b[i]) result[1].push_back(b[i]);
  }
  return result;
}

/// Returns the word among all kinds; fails to find a misspelt one.
inline std::string_view word_of(const std::string& text) {
  const std::vector<std::string_view> all = families::all_small_kinds();
  const auto found = std::ranges::find(all, text);
  return found == all.end() ? "unknown" : *found;
}

/// Returns the kinds by `study`, whose depth is that of the exact method.
inline std::vector<std::string_view> small_kinds_naive(const families::SmallPair& pair) {
  const std::vector<Point> a = points_of(pair.a), b = points_of(pair.b);
  const Study found = study(a, b);
  constexpr std::array<const char*, 3> features{"vertex", "edge", "face"};
  std::string meeting = "disjoint";
  if (found.depth.status() == Status::touching) {
    const auto [of_a, of_b] = touching_faces_naive(pair);
    const auto name = [&](const std::vector<Point>& face) { return features.at(study(face, face).a.rank); };
    meeting = std::string("touching_") + name(of_a) + "_" + name(of_b);
  } else if (found.depth.status() == Status::penetrating && found.depth.optima().size() > 1) {
    meeting = "ties";
  } else if (found.depth.status() == Status::penetrating) {
    meeting = "contact_" + std::string(name(found.depth.optima()[0].contact.kind));
    std::ranges::replace(meeting, '-', '_');
  }
  std::vector<std::string_view> kinds{word_of(meeting)};
  if (found.a.rank < 3) kinds.push_back("flat_a");
  if (found.b.rank < 3) kinds.push_back("flat_b");
  if (std::ranges::any_of(a, [&](const Point& p) { return std::ranges::count(b, p) > 0; }))
    kinds.push_back("shared_vertices");
  for (const Coincidence kind : {Coincidence::parallel_edges, Coincidence::coincident_normals,
                                 Coincidence::equal_normals, Coincidence::coplanar_facets})
    if (found[kind].count > 0) kinds.push_back(coincidence_names.at(static_cast<std::size_t>(kind)));
  return kinds;
}

}  // namespace fathom::testing
