// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/points.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/unions/pieces.hpp"
#include "view/stages/parts.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {
namespace {

constexpr std::size_t most_piece_pairs = 2000;  // pairs of pieces whose depth is computed for the list
constexpr std::size_t most_drawn = 40;          // P_ij
constexpr std::size_t most_differences = 4000;  // of vertices, for one P_ij
constexpr std::size_t most_ways = 100;
constexpr std::size_t most_edges_of_pieces = 50'000;

using Hulls = std::vector<polytope::Polytope>;

StagedPiece piece_of(const std::vector<Point>& points, const polytope::Polytope& hull, const Placing& placing) {
  StagedPiece piece;
  piece.ids.assign(hull.input_ids.begin(), hull.input_ids.end());
  for (const std::uint32_t id : hull.input_ids) piece.vertices.push_back(placing.point(points[id]));
  for (const polytope::Edge& edge : hull.edges) piece.edges.push_back({edge.from.value, edge.to.value});
  for (const polytope::Facet& facet : hull.facets) {
    Indices& corners = piece.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.corners[i].value);
  }
  return piece;
}

StagedUnionWay way_of(const UnionOptimum& optimum, const Placing& placing) {
  StagedUnionWay way{placing.vector(optimum.translation), optimum.clearance, {}};
  for (const PieceContact& c : optimum.contacts) way.touching.push_back({c.a, c.b, unit(c.direction), c.contact});
  return way;
}

StagedUnionWay way_of(const UnionDistance& apart, const Placing& placing) {
  const Distance& d = apart.distance;
  return {placing.vector(d.translation), true, {{apart.a, apart.b, unit(d.direction), d.contact}}};
}

/// The listed sums, without their facets.
class Sums {
 public:
  Sums(const Pieces& a, const Pieces& b, const UnionDepth& depth, const Placing& placing, Monitor* monitor)
      : a_(a), b_(b), depth_(depth), placing_(placing), monitor_(monitor) {}

  std::vector<PieceSum> all(bool only_touching) {
    std::vector<PieceSum> result;
    for (Index i = 0; i < a_.size(); ++i)
      for (Index j = 0; j < b_.size(); ++j) {
        Indices touches = touches_of(i, j);
        if (only_touching && touches.empty()) continue;
        PieceSum sum = measured(i, j);
        sum.touches = std::move(touches);
        if (!sum.touches.empty() || sum.inside || sum.squared < depth_.low) result.push_back(std::move(sum));
      }
    std::ranges::stable_sort(result, [](const PieceSum& p, const PieceSum& q) {
      if (p.touches.empty() != q.touches.empty()) return q.touches.empty();
      if (p.inside != q.inside) return p.inside;
      return p.inside ? p.squared > q.squared : p.squared < q.squared;
    });
    return result;
  }

 private:
  [[nodiscard]] Indices touches_of(Index i, Index j) const {
    Indices result;
    for (Index k = 0; k < std::min(depth_.optima.size(), most_ways); ++k)
      if (std::ranges::any_of(depth_.optima[k].contacts, [&](const PieceContact& c) { return c.a == i && c.b == j; }))
        result.push_back(k);
    return result;
  }
  [[nodiscard]] PieceSum measured(Index i, Index j) const {
    const Depth depth = penetration_depth(a_[i], b_[j], {.monitor = monitor_});
    PieceSum sum;
    sum.a = i;
    sum.b = j;
    sum.inside = depth.status() == Status::penetrating;
    if (sum.inside) sum.squared = depth.squared();
    else if (depth.distance() != nullptr) sum.squared = depth.distance()->squared;
    sum.distance = placing_.length(sum.squared);
    return sum;
  }

  const Pieces &a_, &b_;
  const UnionDepth& depth_;
  const Placing& placing_;
  Monitor* monitor_;
};

/// Returns whether the facet's plane contains the translation.
bool holds(const polytope::Facet& facet, const mpz_class& height, const Point& t, const mpz_class& denominator) {
  return dot(facet.normal, t) * denominator == height;
}

/// Adds the facets of a sum; returns false if there would be too many differences.
bool add_facets(PieceSum& sum, const polytope::Polytope& a, const polytope::Polytope& b, const UnionDepth& depth,
                const mpz_class& denominator, const Placing& placing) {
  if (a.vertices.size() * b.vertices.size() > most_differences) return false;
  std::vector<Vector> differences;
  for (const Vector& p : a.vertices)
    for (const Vector& q : b.vertices) differences.push_back(q - p);
  const polytope::Polytope hull = polytope::convex_hull(differences);
  for (const Vector& v : hull.vertices) sum.vertices.push_back(placing.vector(v));
  for (const polytope::Facet& facet : hull.facets) {
    Indices& corners = sum.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.corners[i].value);
    sum.normals.push_back(unit(facet.normal));
    const mpz_class height = dot(facet.normal, hull.vertices[hull.corners[facet.begin]]);
    for (const Index k : sum.touches)
      if (holds(facet, height, depth.optima[k].translation, denominator))
        sum.through.push_back({static_cast<Index>(sum.facets.size() - 1), k});
  }
  return true;
}

void add_sums(const Pieces& a, const Pieces& b, const UnionDepth& depth, const unions::PlacedPieces& placed,
              const Hulls& of_a, const Hulls& of_b, const Placing& placing, Monitor* monitor, UnionStages& stages) {
  if (depth.status != Status::penetrating) {
    stages.left_out.emplace_back("The differences of pieces are not drawn: O is in the interior of none of them.");
    return;
  }
  const bool only_touching = a.size() * b.size() > most_piece_pairs;
  stages.sums = Sums(a, b, depth, placing, monitor).all(only_touching);
  if (only_touching)
    stages.left_out.push_back(
        fmt::format("There are {} pairs of pieces: of their differences those are here that touch after the way out.",
                    a.size() * b.size()));
  std::size_t drawn = 0, left = 0;
  for (PieceSum& sum : stages.sums) {
    if (drawn < most_drawn && add_facets(sum, of_a[sum.a], of_b[sum.b], depth, placed.whole.denominator, placing))
      ++drawn;
    else ++left;
  }
  if (left > 0)
    stages.left_out.push_back(
        fmt::format("Of the {} differences of pieces that are listed {} are not drawn.", stages.sums.size(), left));
}

Hulls hulls_of(const std::vector<unions::PlacedPiece>& pieces) {
  Hulls hulls;
  for (const unions::PlacedPiece& piece : pieces) hulls.push_back(polytope::convex_hull(piece.cloud.points()));
  return hulls;
}

Hulls hulls_of(const Pieces& pieces) {
  Hulls hulls;
  for (const std::vector<Point>& piece : pieces) hulls.push_back(polytope::hull_of(piece));
  return hulls;
}

void add_pieces(const Pieces& points, const Hulls& hulls, const Placing& placing, std::vector<StagedPiece>& pieces) {
  for (std::size_t i = 0; i < hulls.size(); ++i) pieces.push_back(piece_of(points[i], hulls[i], placing));
}

void require_drawable(const Hulls& a, const Hulls& b) {
  std::size_t edges = 0;
  for (const Hulls* hulls : {&a, &b})
    for (const polytope::Polytope& hull : *hulls) edges += hull.edges.size();
  if (edges > most_edges_of_pieces)
    throw std::invalid_argument(
        fmt::format("the pieces have {} edges, and a page shows at most {}", edges, most_edges_of_pieces));
}

}  // namespace

UnionStages stages_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, Monitor* monitor, unsigned dimension) {
  const kernels::DefaultFloatEnvironment environment;
  if (!depth.complete) throw std::invalid_argument("the search was stopped before its end");
  const bool plane = dimension == 2;
  std::optional<unions::PlacedPieces> placed;  // none of the plane: there they are flat
  if (!plane) placed = unions::place_pieces(a, b, unions::Lattices::one);
  const polytope::PlacedPair whole = placed ? placed->whole : polytope::place(polytope::joined(a), polytope::joined(b));
  const Placing placing(whole);
  const Hulls of_a = placed ? hulls_of(placed->a) : hulls_of(a), of_b = placed ? hulls_of(placed->b) : hulls_of(b);
  require_drawable(of_a, of_b);
  UnionStages stages;
  stages.status = depth.status;
  stages.scale = placing.scale();
  add_pieces(a, of_a, placing, stages.a);
  add_pieces(b, of_b, placing, stages.b);
  if (depth.apart) stages.ways.push_back(way_of(*depth.apart, placing));
  for (std::size_t k = 0; k < std::min(depth.optima.size(), most_ways); ++k)
    stages.ways.push_back(way_of(depth.optima[k], placing));
  stages.left_out.emplace_back(
      plane ? only_what_happens
            : "Sections 3 to 5 of the pages of convex bodies are left out: the stages of the algorithm of AGHRS, what "
              "coincided and what it cost are those of convex pairs. The depth of unions is found by a search among "
              "the differences of their pieces.");
  if (depth.optima.size() > most_ways)
    stages.left_out.push_back(fmt::format("Of {} optima the first {} are here.", depth.optima.size(), most_ways));
  if (placed) add_sums(a, b, depth, *placed, of_a, of_b, placing, monitor, stages);
  return stages;
}

}  // namespace fathom::stages
