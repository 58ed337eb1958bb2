// SPDX-License-Identifier: Apache-2.0
#include "solids.hpp"

#include <algorithm>
#include <numeric>

#include "limits.hpp"

namespace fathom_check {

PiecedBody::PiecedBody(const Body& body) : points_(homogeneous(body)), is_union_(body.core == Body::Core::pieces) {
  if (is_union_) {
    corners_.resize(points_.size());
    std::iota(corners_.begin(), corners_.end(), 0);
    for (const List& piece : body.pieces) ends_.push_back(piece.end);
    return;
  }
  const Facets& facets = body.solid.facets.items;
  for (std::size_t k = 0; k < body.solid.pieces.size(); ++k) {
    const std::vector<std::uint32_t> named =
        facets.named(fathom_check::begin_of(body.solid.pieces, k), body.solid.pieces[k].end);
    corners_.insert(corners_.end(), named.begin(), std::lower_bound(named.begin(), named.end(), points_.size()));
    ends_.push_back(corners_.size());
  }
}

std::optional<std::uint32_t> PiecedBody::corner(std::size_t piece, std::uint32_t number) const {
  const std::uint32_t *const begin = corners_.data() + begin_of(piece), *const end = corners_.data() + ends_[piece];
  if (!is_union_) return std::binary_search(begin, end, number) ? std::optional(number) : std::nullopt;
  return number < corners(piece) ? std::optional(begin[number]) : std::nullopt;
}

std::optional<Fault> for_each_vector(
    const UnionParts& parts, std::size_t list, std::size_t pieces_a, std::size_t pieces_b,
    const std::function<void(std::size_t block, const PieceRange& of_a, const PieceRange& of_b)>& take) {
  struct Ranges {
    PieceRange a, b;
  };
  std::vector<Ranges> left{{{0, pieces_a}, {0, pieces_b}}};
  const List& blocks = parts.separation_lists[list];
  for (std::size_t k = begin_of(parts.separation_lists, list); k < blocks.end; ++k) {
    const Block& block = parts.blocks.items[k];
    if (left.empty()) return refused(parts.blocks.lines[k], "the tree of blocks ends before this one");
    Ranges ranges = left.back();
    left.pop_back();
    if (block.kind == Block::Kind::vector) {
      take(k, ranges.a, ranges.b);
      continue;
    }
    PieceRange& split = block.kind == Block::Kind::splits_a ? ranges.a : ranges.b;
    if (split.size() < 2) return refused(parts.blocks.lines[k], "fewer than two pieces cannot be split");
    const PieceRange whole = split;
    const std::size_t middle = (whole.first + whole.last) / 2;
    split = {middle, whole.last};
    left.push_back(ranges);
    split = {whole.first, middle};
    left.push_back(ranges);
  }
  if (!left.empty()) return refused(blocks.line, "a block of this tree is missing");
  return std::nullopt;
}

void Polygons::require_points(const std::uint32_t* corners, std::size_t size, std::size_t line) const {
  for (std::size_t k = 0; k < size; ++k)
    if (corners[k] >= points_.size()) throw refused(line, "there is no point " + std::to_string(corners[k]));
}

void Polygons::find_direction(MutableVector& direction, std::uint32_t u, std::uint32_t v) {
  find_edge(direction, u, v);
  make_primitive(direction);
}

/// Finds a positive multiple of point v - point u.
void Polygons::find_edge(MutableVector& edge, std::uint32_t u, std::uint32_t v) const {
  subtract(edge, points_[v], points_[u]);
}

void Polygons::make_primitive(MutableVector& v) {
  find_gcd(divisor_, v);
  if (divisor_ != 1) divide(v, divisor_);
}

/// (v_k - v_0) x (v_(k+1) - v_0), into normal_. Returns whether it is not zero.
bool Polygons::find_fan_normal(const std::uint32_t* corners, std::size_t k) {
  find_edge(first_edge_, corners[0], corners[k]);
  find_edge(second_edge_, corners[0], corners[k + 1]);
  cross(normal_, first_edge_, second_edge_);
  return !is_zero(normal_);
}

/// Finds the normal, of which the triangles fanned out from the first corner have positive
/// multiples.
void Polygons::take(Polygon polygon) {
  if (polygon.size < 3) throw refused(polygon.line, "a facet has at least three corners");
  require_points(polygon.corners, polygon.size, polygon.line);
  for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
    if (!find_fan_normal(polygon.corners, k)) throw refused(polygon.line, "three of these corners lie on a line");
    make_primitive(normal_);
    if (k == 1) polygon.normal = kept(integers_, normal_);
    else if (ascending(normal_, polygon.normal) || ascending(polygon.normal, normal_))
      throw refused(polygon.line, "this facet is not a flat and convex polygon");
  }
  // Around a corner in its middle the fan of a polygon could go several times.
  std::vector<std::uint32_t> named(polygon.corners, polygon.corners + polygon.size);
  std::sort(named.begin(), named.end());
  if (std::adjacent_find(named.begin(), named.end()) != named.end())
    throw refused(polygon.line, "this facet has a corner twice");
  all_.push_back(polygon);
}

void Polygons::take_polytope(const Part<Facets>& part, std::size_t begin, std::size_t end, std::size_t line) {
  if (begin == end) throw refused(line, "there is no facet");
  const std::size_t first = all_.size();
  for (std::size_t f = begin; f < end; ++f) {
    const std::uint32_t* const corners = part.items.corners.data() + part.items.begin_of(f);
    take({corners, part.items.ends[f] - part.items.begin_of(f), part.lines[f], -1, {}});
  }
  const std::vector<std::uint32_t> named = part.items.named(begin, end);
  std::vector<const Polygon*> facets;
  for (std::size_t f = first; f < all_.size(); ++f) {
    check_support(all_[f], named);
    facets.push_back(&all_[f]);
  }
  const auto same = [](const Polygon* f, const Polygon* g) { return same_vector(f->normal, g->normal); };
  std::sort(facets.begin(), facets.end(), [&same](const Polygon* f, const Polygon* g) {
    return same(f, g) ? f < g : ascending(f->normal, g->normal);
  });
  if (const auto twice = std::adjacent_find(facets.begin(), facets.end(), same); twice != facets.end())
    throw refused(twice[1]->line, "another facet of this piece lies in the same plane");
  check_edges(first);
}

void Polygons::check_support(const Polygon& facet, const std::vector<std::uint32_t>& corners) {
  const Homogeneous& on = points_[facet.corners[0]];
  dot(level_, facet.normal, on.x);
  bool below = false;
  for (const std::uint32_t k : corners) {
    dot(height_, facet.normal, points_[k].x);
    height_ *= on.w;
    mpz_mul(scratch_.get_mpz_t(), level_.get_mpz_t(), points_[k].w.get_mpz_t());
    const int side = cmp(height_, scratch_);
    if (side > 0) throw refused(facet.line, "point " + std::to_string(k) + " of the piece is above this facet");
    below = below || side < 0;
  }
  if (!below) throw refused(facet.line, "the points of this piece lie in one plane");
}

/// Each edge has its reverse.
void Polygons::check_edges(std::size_t first) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t f = first; f < all_.size(); ++f)
    for (std::size_t k = 0; k < all_[f].size; ++k) edges.emplace_back(all_[f].corner(k), all_[f].corner(k + 1));
  std::sort(edges.begin(), edges.end());
  for (std::size_t f = first; f < all_.size(); ++f)
    for (std::size_t k = 0; k < all_[f].size; ++k) {
      const std::uint32_t u = all_[f].corner(k), v = all_[f].corner(k + 1);
      if (!std::binary_search(edges.begin(), edges.end(), std::pair{v, u}))
        throw refused(all_[f].line, "no facet lies across the edge " + std::to_string(u) + " " + std::to_string(v));
    }
}

}  // namespace fathom_check
