// SPDX-License-Identifier: GPL-3.0-or-later
// What a solid says of itself: its volume, its pieces for others, its notes.
#include "reference/solids/solid_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "kernels/messages.hpp"
#include "kernels/nearest.hpp"
#include "kernels/vector.hpp"

namespace fathom::solids {

std::vector<std::uint32_t> corners_of(const Solid::Piece& piece) {
  std::vector<std::uint32_t> corners;
  for (const std::vector<std::uint32_t>& facet : piece.facets)
    corners.insert(corners.end(), facet.begin(), facet.end());
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool is_repeated(const Solid& solid, std::size_t i) {
  return i > 0 && solid.pieces[i].facets == solid.pieces[i - 1].facets;
}

namespace {

using FacetCorners = std::span<const std::uint32_t>;

/// Vectors up to sign and length, by number.
class Directions {
 public:
  std::size_t number(const Point& v) {
    const Vector u = primitive_along(v);
    const Vector& canonical = lexicographically_less(u, {0, 0, 0}) ? Vector(-u) : u;
    return known_.try_emplace(canonical, known_.size()).first->second;
  }

 private:
  std::map<Vector, std::size_t, LexicographicOrder> known_;
};

class TilingCheck {
 public:
  explicit TilingCheck(const Solid& solid) : points_(solid.points), solid_(solid) {}

  kernels::Report run() {
    std::vector<std::tuple<mpq_class, mpq_class, mpq_class>> sorted;
    for (const Point& p : points_) sorted.emplace_back(p.x, p.y, p.z);
    std::ranges::sort(sorted);
    report_.expect(std::ranges::adjacent_find(sorted) == sorted.end(), "a point is there twice");
    for (std::size_t i = 0; i < solid_.pieces.size(); ++i) check_piece(solid_.pieces[i], fmt::format("piece {}", i));
    for (const auto& triangle : solid_.triangles)
      if (const Point n = fan_normal(triangle, 1); n != Point{}) add(triangle, n, -1);
    report_.expect(std::ranges::all_of(flags_, [](const auto& flag) { return flag.second == 0; }),
                   "the pieces do not tile what the mesh goes around");
    return std::move(report_);
  }

 private:
  // Of the i-th triangle of the fan.
  [[nodiscard]] Point fan_normal(FacetCorners f, std::size_t i) const {
    return cross(points_[f[i]] - points_[f[0]], points_[f[i + 1]] - points_[f[0]]);
  }

  // Each directed edge counts 1 at its end and -1 where it begins.
  void add(FacetCorners f, const Point& normal, int sign) {
    const std::size_t plane = directions_.number(normal);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const std::uint32_t p = f[i], q = f[(i + 1) % f.size()];
      const std::size_t line = directions_.number(points_[q] - points_[p]);
      flags_[{p, plane, line}] -= sign;
      flags_[{q, plane, line}] += sign;
    }
  }

  void check_piece(const Solid::Piece& piece, const std::string& name) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    bool is_solid = false;
    for (const std::vector<std::uint32_t>& f : piece.facets) {
      if (!report_.expect(f.size() >= 3, name + " has a facet of fewer than three corners")) return;
      Point normal;
      for (std::size_t i = 1; i + 1 < f.size(); ++i) {
        const Point n = fan_normal(f, i);
        if (normal == Point{}) normal = n;
        report_.expect(cross(normal, n) == Point{} && dot(normal, n) >= 0, name + " has a facet that is not convex");
      }
      if (!report_.expect(normal != Point{}, name + " has a facet without area")) return;
      for (const std::vector<std::uint32_t>& other : piece.facets)
        for (const std::uint32_t corner : other) {
          const int side = sgn(dot(normal, points_[corner] - points_[f[0]]));
          report_.expect(side <= 0, name + " is not convex");
          is_solid = is_solid || side < 0;
        }
      for (std::size_t i = 0; i < f.size(); ++i) {
        ++edges[{f[i], f[(i + 1) % f.size()]}];
        --edges[{f[(i + 1) % f.size()], f[i]}];
      }
      add(f, normal, 1);
    }
    report_.expect(is_solid, name + " is flat");
    report_.expect(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; }),
                   name + " is not closed");
  }

  const std::vector<Point>& points_;
  const Solid& solid_;
  kernels::Report report_;
  Directions directions_;
  std::map<std::tuple<std::uint32_t, std::size_t, std::size_t>, long> flags_;
};

}  // namespace

kernels::Report validate(const Solid& solid) { return TilingCheck(solid).run(); }

}  // namespace fathom::solids

namespace fathom {
namespace {

using solids::is_repeated;

mpq_class det_at(const Solid& solid, std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  const Point& origin = solid.points.front();
  return dot(cross(solid.points[p] - origin, solid.points[q] - origin), solid.points[r] - origin);
}

}  // namespace

std::size_t given_points(const Solid& solid) {
  std::uint32_t count = 0;
  for (const auto& triangle : solid.triangles) count = std::max(count, *std::ranges::max_element(triangle) + 1);
  return count;
}

// What the mesh goes around several times is taken away: of the rest, numbers are short.
mpq_class volume(const Solid& solid) {
  mpq_class sum;
  for (const auto& [p, q, r] : solid.triangles) sum += det_at(solid, p, q, r);
  for (std::size_t k = 0; k < solid.pieces.size(); ++k) {
    if (!is_repeated(solid, k)) continue;
    for (const std::vector<std::uint32_t>& facet : solid.pieces[k].facets)
      for (std::size_t i = 1; i + 1 < facet.size(); ++i) sum -= det_at(solid, facet[0], facet[i], facet[i + 1]);
  }
  return sum / 6;
}

Pieces pieces_of(const Solid& solid) {
  Pieces pieces;
  for (std::size_t k = 0; k < solid.pieces.size(); ++k) {
    if (is_repeated(solid, k)) continue;
    std::vector<Point>& points = pieces.emplace_back();
    for (const std::uint32_t i : solids::corners_of(solid.pieces[k])) points.push_back(solid.points[i]);
  }
  return pieces;
}

Body solid_body(const Body& mesh) {
  Body body;
  body.solid = std::make_shared<const Solid>(solid_of(mesh));
  body.pieces = std::make_shared<const Pieces>(pieces_of(*body.solid));
  return body;
}

std::vector<std::string> notes(const Solid& solid) {
  std::vector<std::string> found;
  if (solid.bent_faces > 0)
    found.push_back(fmt::format("{} not flat: cut from the first corner{}",
                                kernels::counted(solid.bent_faces, "face of the mesh is", "faces of the mesh are"),
                                solid.bent_faces == 1 ? "" : " of each"));
  if (solid.turned) found.emplace_back("the faces of the mesh look inwards: turned over");
  if (solid.overlaps) found.emplace_back("the mesh overlaps itself: what it goes around more than once counts once");
  return found;
}

std::string pieces_obj(const Solid& solid) {
  std::string text = "# convex pieces, one a group; coordinates are exact\n";
  for (const Point& p : solid.points)
    text += fmt::format("v {} {} {}\n", exact_text(p.x), exact_text(p.y), exact_text(p.z));
  std::size_t number = 0;
  for (std::size_t k = 0; k < solid.pieces.size(); ++k) {
    if (is_repeated(solid, k)) continue;
    text += fmt::format("g piece_{}\n", number++);
    for (const std::vector<std::uint32_t>& facet : solid.pieces[k].facets) {
      text += 'f';
      for (const std::uint32_t i : facet) text += fmt::format(" {}", i + 1);
      text += '\n';
    }
  }
  return text;
}

}  // namespace fathom
