// SPDX-License-Identifier: GPL-3.0-or-later
// Convex pieces of others against the solid of a mesh: every convex cell of one is cut by the
// planes of the other's, into parts inside of them and parts outside. What is left is convex, lies
// between planes of the input, and has volumes that sum.                       [proofs/solids.md]
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fathom/solid.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/solids/arrangement.hpp"

namespace fathom::solids {
namespace {

/// A convex polytope.
struct Cell {
  Chunk facets;
  std::vector<PointId> points;
  ChunkBox box;
};

Cell cell_of(const Arrangement& space, Chunk facets) {
  std::vector<PointId> points = Cutter::points_of(facets);
  const ChunkBox box = box_of(space, facets);
  return {std::move(facets), std::move(points), box};
}

/// The least e for which all coordinates are surely at most 2^e in size.
long exponent_of(const Pieces& a, const Pieces& b) {
  std::optional<long> exponent;
  for (const Pieces* pieces : {&a, &b})
    for (const std::vector<Point>& piece : *pieces)
      for (const Point& p : piece)
        for (const mpq_class* c : {&p.x, &p.y, &p.z})
          if (*c != 0) exponent = std::max(exponent, std::optional(kernels::binary_order(*c) + 1));  // none is least
  return exponent.value_or(0);
}

/// The hull of each piece as a cell. Throws std::invalid_argument if one is flat.
std::vector<Cell> cells_of(Arrangement& space, const Pieces& pieces) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::vector<Point>& points = pieces[i];
    const std::string name = "piece " + std::to_string(i);
    if (points.empty()) throw std::invalid_argument(name + " has no points");
    const polytope::Polytope hull = polytope::hull_of(points);
    if (hull.rank < 3) throw std::invalid_argument(name + " is flat: pieces that cover a solid need interiors");
    std::vector<PointId> ids;
    for (const std::uint32_t k : hull.input_ids) ids.push_back(space.point_at(points[k]));
    Chunk facets;
    for (const polytope::Facet& facet : hull.facets) {
      const std::span<const polytope::VertexId> corners(&hull.corners[facet.begin], facet.end - facet.begin);
      const auto corner = [&](std::size_t k) { return ids[corners[k % corners.size()].value]; };
      facets.push_back({*space.plane(corner(0), corner(1), corner(2)), {}});
      for (std::size_t k = 0; k < corners.size(); ++k)
        facets.back().edges.push_back(edge_from_to(space, corner(k), corner(k + 1)));
    }
    cells.push_back(cell_of(space, std::move(facets)));
  }
  return cells;
}

using Cells = std::vector<Cell>;
using Others = std::vector<const Cell*>;

/// The parts of a cell inside of at least one other, or outside of all.
enum class Wanted { inside, outside };

class Splitter {
 public:
  explicit Splitter(Arrangement& space) : space_(space), cutter_(space) {}

  /// Adds the convex parts that are wanted of a cell to `parts`.
  void split(Cell whole, const Others& others, Wanted wanted, Cells& parts) {
    std::vector<std::pair<Cell, Others>> todo;
    todo.emplace_back(std::move(whole), others);
    while (!todo.empty()) {
      Cell cell = std::move(todo.back().first);
      Others near = std::move(todo.back().second);
      todo.pop_back();
      std::erase_if(near, [&](const Cell* other) { return !overlap(space_, cell.box, other->box); });
      std::optional<Cut> cut;
      while (!cut && !near.empty()) {
        cut = cut_by(cell, *near.back());
        near.pop_back();
      }
      if (!cut) {
        if (wanted == Wanted::outside) parts.push_back(std::move(cell));
        continue;
      }
      for (Chunk& part : cut->outside) todo.emplace_back(cell_of(space_, std::move(part)), near);
      if (wanted == Wanted::inside) parts.push_back(cell_of(space_, std::move(cut->inside)));
    }
  }

 private:
  struct Cut {
    Chunk inside;
    std::vector<Chunk> outside;
  };

  struct SideParts {
    bool inside, outside;  // whether points lie there, strictly
  };
  SideParts look(PlaneSide side, const std::vector<PointId>& points) {
    const auto [above, below] = cutter_.look(side.plane, points);
    return side.reversed ? SideParts{above > 0, below > 0} : SideParts{below > 0, above > 0};
  }

  // Whether a facet of one of them has the other one on its outside.
  bool surely_apart(const Cell& a, const Cell& b) {
    const auto parts_from = [&](const Cell& by, const Cell& from) {
      return std::ranges::any_of(by.facets, [&](const ChainFacet& f) { return !look(f.side, from.points).inside; });
    };
    return parts_from(b, a) || parts_from(a, b);
  }

  // nullopt if the interiors have no common point: then the cell stays whole.
  std::optional<Cut> cut_by(const Cell& cell, const Cell& other) {
    if (surely_apart(cell, other)) return std::nullopt;
    Cut cut{cell.facets, {}};
    std::vector<PointId> points = cell.points;
    for (const ChainFacet& facet : other.facets) {
      const auto [inside, outside] = look(facet.side, points);
      if (!inside) return std::nullopt;
      if (!outside) continue;
      auto [above, below] = cutter_.cut(std::move(cut.inside), facet.side.plane);
      if (facet.side.reversed) std::swap(above, below);
      cut.outside.push_back(std::move(above));
      cut.inside = std::move(below);
      points = Cutter::points_of(cut.inside);
    }
    return cut;
  }

  Arrangement& space_;
  Cutter cutter_;
};

/// Calls f with numerators and denominators that sum to six times the volume, if the facets make a
/// closed surface: for each edge of a facet, the tetrahedron of it, O and a corner of the facet.
template <class F>
void for_each_term(const Arrangement& space, const Chunk& facets, F f) {
  for (const ChainFacet& facet : facets) {
    const kernels::RationalPoint& r = space[facet.edges.front().low];
    for (const ChainEdge& e : facet.edges) {
      const kernels::RationalPoint &p = space[e.low], &q = space[e.high];
      const mpz_class n = det(r.v, p.v, q.v);
      if (n != 0) f(mpz_class(n * static_cast<long>(e.times)), mpz_class(r.w * p.w * q.w));
    }
  }
}

// What cells have in common cancels first: so there are few terms. They are added up in pairs, then
// pairs of these: the numbers of two sums of as many terms have about one length.
mpq_class volume_of(const Arrangement& space, const Cells& cells) {
  std::map<PlaneId, std::vector<ChainEdge>> in_plane;
  for (const Cell& cell : cells)
    for (const ChainFacet& facet : cell.facets) {
      std::vector<ChainEdge>& all = in_plane[facet.side.plane];
      all.insert(all.end(), facet.edges.begin(), facet.edges.end());
    }
  Chunk boundary;
  for (const auto& [plane, edges] : in_plane)
    if (std::vector<ChainEdge> rest = normalised(space, edges); !rest.empty())
      boundary.push_back({{plane, false}, std::move(rest)});
  std::vector<mpq_class> terms(1);
  for_each_term(space, boundary,
                [&](const mpz_class& n, const mpz_class& d) { terms.push_back(kernels::ratio(n, d)); });
  for (std::size_t step = 1; step < terms.size(); step *= 2)
    for (std::size_t i = 0; i + step < terms.size(); i += 2 * step) terms[i] += terms[i + step];
  return terms.front() / 6;
}

/// The cell of about the largest volume: numbers are cut off after 64 bits.
const Cell& largest(const Arrangement& space, long exponent, const Cells& cells) {
  const auto size = [&](const Cell& cell) {
    mpz_class sum;
    for_each_term(space, cell.facets, [&](const mpz_class& n, const mpz_class& d) {
      sum += mpz_class(kernels::times_power_of_two(kernels::ratio(n, d), 64 - 3 * exponent));
    });
    return sum;
  };
  return *std::ranges::max_element(cells, {}, size);
}

/// A point in the interior of the largest cell, with few digits; nullopt if there is no cell.
std::optional<Point> short_inner_point(Arrangement& space, long exponent, const Cells& cells) {
  if (cells.empty()) return std::nullopt;
  const Cell& cell = largest(space, exponent, cells);
  Point center;
  for (const PointId id : cell.points) {
    const kernels::RationalPoint& p = space[id];
    center = center + Point{kernels::ratio(p.v.x, p.w), kernels::ratio(p.v.y, p.w), kernels::ratio(p.v.z, p.w)};
  }
  center = mpq_class(1, static_cast<unsigned long>(cell.points.size())) * center;
  for (long bits = 3;; bits *= 2) {
    const auto rounded = [&](const mpq_class& c) {
      const mpz_class whole(kernels::times_power_of_two(c, bits - exponent));
      return kernels::times_power_of_two(whole, exponent - bits);
    };
    const Point candidate{rounded(center.x), rounded(center.y), rounded(center.z)};
    const PointId p = space.point_at(candidate);
    if (std::ranges::all_of(cell.facets, [&](const ChainFacet& f) { return space.side(f.side, p) < 0; }))
      return candidate;
  }
}

Others pointers(std::span<const Cell> cells) {
  Others all;
  for (const Cell& cell : cells) all.push_back(&cell);
  return all;
}

}  // namespace
}  // namespace fathom::solids

namespace fathom {

std::optional<std::size_t> PieceCoverage::most_outside() const {
  if (outside == 0) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::max_element(outside_of) - outside_of.begin());
}

PieceCoverage coverage(const Solid& solid, const Pieces& pieces) {
  using namespace solids;
  const kernels::DefaultFloatEnvironment environment;
  if (pieces.empty()) throw std::invalid_argument("there are no pieces");
  const Pieces of_solid = pieces_of(solid);
  const long exponent = exponent_of(of_solid, pieces);
  Arrangement space(exponent);
  const Cells tiles = cells_of(space, of_solid), given = cells_of(space, pieces);
  const Others all_given = pointers(given), all_tiles = pointers(tiles);
  Splitter splitter(space);
  Cells missing, overlapping, stray;
  PieceCoverage result;
  for (const Cell& tile : tiles) splitter.split(tile, all_given, Wanted::outside, missing);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Others earlier = pointers(std::span(given).first(i));
    splitter.split(given[i], earlier, Wanted::inside, overlapping);
    Cells outside;
    splitter.split(given[i], all_tiles, Wanted::outside, outside);
    result.outside_of.push_back(volume_of(space, outside));
    for (Cell& part : outside) splitter.split(std::move(part), earlier, Wanted::outside, stray);
  }
  result.missing = volume_of(space, missing);
  result.outside = volume_of(space, stray);
  result.overlap = volume_of(space, overlapping);
  result.uncovered = short_inner_point(space, exponent, missing);
  result.stray = short_inner_point(space, exponent, stray);
  return result;
}

}  // namespace fathom
