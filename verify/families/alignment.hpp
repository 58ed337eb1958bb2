// SPDX-License-Identifier: GPL-3.0-or-later
// Features of a body's hull, and exact linear maps that make one of them point where it should.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "kernels/vector.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

/// Edges and facets in no particular order. A polygon has two facets, one with each of its normals.
struct Features {
  std::vector<Point> vertices;
  std::vector<std::pair<Point, Point>> edges;  ///< ends
  std::vector<Point> edge_directions;          ///< of each edge
  std::vector<Point> normals;                  ///< of each facet
  std::vector<std::vector<Point>> facets;      ///< corners of each facet
  std::vector<std::pair<Point, Point>> arcs;   ///< the two normals beside each edge that has two facets
};
Features features(const Body& body);

/// The linear map that takes the direction `from` to its projection on the line of `to`, and is the identity across `from`: edges with
/// direction `from` become parallel to `to`. <from, to> must not be 0.
Body edge_aligned(const Body& body, const Point& from, const Point& to);

/// The linear map after which facets with the outward normal `from` have one along `to`, or against it if <from, to> < 0.
/// <from, to> must not be 0.
Body normal_aligned(const Body& body, const Point& from, const Point& to);

/// The projection of p into the plane across `normal`; and on the line along `direction`.
Point across(const Point& p, const Point& normal);
Point along(const Point& p, const Point& direction);

/// How well two directions agree: cos^2 of their angle with the sign of the cosine. Neither may be 0.
mpq_class agreement(const Point& p, const Point& q);

/// Returns the indices of the pair, one of each list, that agrees best; nullopt if a list is empty or no agreement is positive.
std::optional<std::pair<std::size_t, std::size_t>> best_agreement(const std::vector<Point>& p, const std::vector<Point>& q);

}  // namespace fathom::families
