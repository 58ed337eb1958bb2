// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh becomes chains, which say whether it is closed; what these go around is cut into convex
// parts; parts that fit are joined again.                                     [proofs/solids.md]
#include "fathom/solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solids/arrangement.hpp"
#include "reference/unions/pair_table.hpp"

namespace fathom::solids {
namespace {

using Corners = std::array<PointId, 3>;

/// "(0, 1, 0.5)"; with "near" before it where these decimals are not the point.
std::string place_text(const Point& p) {
  std::string text;
  bool exact = true;
  for (const mpq_class* c : {&p.x, &p.y, &p.z}) {
    const double nearest = round_binary64(*c);
    exact = exact && kernels::in_binary64(*c).has_value();
    text += fmt::format("{}{}", text.empty() ? "(" : ", ", nearest);
  }
  return (exact ? "" : "near ") + text + ")";
}

/// The mesh as a closed chain.
class MeshChain {
 public:
  /// Throws std::invalid_argument if it is not closed or holds no volume.
  MeshChain(Arrangement& space, const polytope::PlacedPair& placed, const MeshFaces& faces)
      : space_(space), placed_(placed) {
    for (std::size_t i = 0; i < placed.a.size(); ++i) ids_.push_back(space.point(placed.a[i]));
    files::for_each_face(faces, ids_.size(), [&](std::span<const std::uint32_t> face) { add_face(face); });
    require_closed();
    mpz_class volume;
    for (const auto& [p, q, r] : triangles_) volume += det(space_[p].v, space_[q].v, space_[r].v);
    if (volume < 0) turn();
    for (auto& [side, edges] : edges_)
      if (std::vector<ChainEdge> reduced = normalised(space_, edges); !reduced.empty())
        surface_.push_back({side, std::move(reduced)});
  }

  [[nodiscard]] const Chunk& surface() const { return surface_; }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }
  [[nodiscard]] bool turned() const { return turned_; }
  [[nodiscard]] std::size_t bent_faces() const { return bent_faces_; }

 private:
  // All triangles of a flat face look to one side, so that those of its fan that turn the other way
  // cancel.
  void add_face(std::span<const std::uint32_t> face) {
    std::vector<std::pair<Corners, PlaneSide>> fan;
    Vector sum{0, 0, 0};
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Corners c{ids_[face[0]], ids_[face[i]], ids_[face[i + 1]]};
      const std::optional<PlaneSide> side = space_.plane(c[0], c[1], c[2]);
      if (!side) continue;
      fan.emplace_back(c, *side);
      const Vector& origin = space_[c[0]].v;
      sum = sum + cross(space_[c[1]].v - origin, space_[c[2]].v - origin);
    }
    const bool flat = std::ranges::all_of(fan, [&](const auto& t) { return t.second.plane == fan[0].second.plane; });
    if (!flat) ++bent_faces_;
    for (auto& [corners, side] : fan) {
      if (flat && !is_zero(sum)) side.reversed = lexicographically_less(sum, {0, 0, 0});
      triangles_.push_back(corners);
      for (std::size_t k = 0; k < 3; ++k)
        edges_[side].push_back(edge_from_to(space_, corners[k], corners[(k + 1) % 3]));
    }
  }

  void turn() {
    turned_ = true;
    for (Corners& t : triangles_) std::swap(t[1], t[2]);
    std::map<PlaneSide, std::vector<ChainEdge>> edges;
    for (auto& [side, all] : edges_) {
      for (ChainEdge& e : all) e.times = -e.times;
      edges[side.opposite()] = std::move(all);
    }
    edges_ = std::move(edges);
  }

  void require_closed() const {
    std::vector<ChainEdge> all;
    for (const auto& [side, edges] : edges_) all.insert(all.end(), edges.begin(), edges.end());
    if (all.empty()) throw std::invalid_argument("the mesh encloses no volume: its faces have no area");
    const std::vector<ChainEdge> open = normalised(space_, all);
    if (open.empty()) return;
    const auto doubled = std::ranges::find_if(open, [](const ChainEdge& e) { return e.times > 1 || e.times < -1; });
    const ChainEdge& shown = doubled == open.end() ? open.front() : *doubled;
    const auto place = [&](PointId p) { return place_text(placed_.position(space_[p].v)); };
    const std::string edge = place(shown.from()) + " -> " + place(shown.to());
    const std::string edges = kernels::counted(open.size(), "edge", "edges");
    std::string fault =
        fmt::format("the mesh is not closed: {} {} more faces on one side than on the other, such as {}", edges,
                    open.size() == 1 ? "has" : "have", edge);
    if (given_twice()) fault += "; a face is given twice";
    else if (doubled != open.end()) fault += ", where two faces run in the same direction: one of them is turned over";
    throw std::invalid_argument(fault + ". A solid has no hole in its surface");
  }

  [[nodiscard]] bool given_twice() const {
    std::set<Corners> known;
    return std::ranges::any_of(triangles_, [&](Corners t) {
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      return !known.insert(t).second;
    });
  }

  Arrangement& space_;
  const polytope::PlacedPair& placed_;
  std::vector<PointId> ids_;
  std::vector<Corners> triangles_;
  std::map<PlaneSide, std::vector<ChainEdge>> edges_;
  Chunk surface_;
  bool turned_ = false;
  std::size_t bent_faces_ = 0;
};

/// A point in the interior of the hull of these points, which is not flat.
Point inner_point(const Arrangement& space, const polytope::PlacedPair& placed, const std::vector<PointId>& corners) {
  Point sum;
  for (const PointId p : corners) sum = sum + placed.position(space[p].v, space[p].w);
  return mpq_class(1, static_cast<unsigned long>(corners.size())) * sum;
}

std::vector<ConvexPart> parts_of(Arrangement& space, const polytope::PlacedPair& placed, const MeshChain& mesh) {
  CutSurface cut = convex_parts(space, mesh.surface());
  if (cut.parts.empty() || cut.parts.back().times > 0) return std::move(cut.parts);
  const ConvexPart& part = cut.parts.back();
  const long times = static_cast<long>(mesh.turned() ? -part.times : part.times);
  std::string place = place_text(inner_point(space, placed, part.corners));
  if (!place.starts_with("near ")) place = "at " + place;
  throw std::invalid_argument(fmt::format(
      "the mesh crosses itself, or a part of it is inside out: its winding number is {} {}, and has the other sign "
      "elsewhere",
      times, place));
}

/// The parts in the order of halves of space, so that proofs can speak of many neighbours at once.
std::vector<ConvexPart> in_order(const Arrangement& space, std::vector<ConvexPart> parts) {
  std::vector<unions::BoxTree::Node> boxes;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    unions::BoxTree::Node& box = boxes.emplace_back();
    box.first = i;
    box.low.fill(std::numeric_limits<double>::infinity());
    box.high.fill(-std::numeric_limits<double>::infinity());
    for (const PointId p : parts[i].corners)
      for (std::size_t k = 0; k < 3; ++k) {
        const double c = kernels::coordinate(space[p].image, static_cast<int>(k));
        box.low[k] = std::min(box.low[k], c);
        box.high[k] = std::max(box.high[k], c);
      }
  }
  std::vector<ConvexPart> result;
  for (const std::uint32_t i : unions::BoxTree(std::move(boxes)).order()) result.push_back(std::move(parts[i]));
  return result;
}

/// The solid as users read it: points by numbers, facets by their corners.
class SolidWriter {
 public:
  SolidWriter(const Arrangement& space, const polytope::PlacedPair& placed)
      : space_(space), placed_(placed), numbers_(space.point_count(), PointId::none().value) {}

  Solid run(const MeshChain& mesh, const std::vector<ConvexPart>& parts) {
    for (const Corners& t : mesh.triangles()) solid_.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
    for (const ConvexPart& part : parts) {
      Solid::Piece piece;
      for (const ChainFacet& facet : part.facets) piece.facets.push_back(corners_in_order(facet));
      solid_.pieces.insert(solid_.pieces.end(), static_cast<std::size_t>(part.times), piece);
      solid_.overlaps = solid_.overlaps || part.times > 1;
    }
    solid_.turned = mesh.turned();
    solid_.bent_faces = mesh.bent_faces();
    return std::move(solid_);
  }

 private:
  std::uint32_t number(PointId p) {
    std::uint32_t& n = numbers_[p.value];
    if (n != PointId::none().value) return n;
    n = static_cast<std::uint32_t>(solid_.points.size());
    solid_.points.push_back(placed_.position(space_[p].v, space_[p].w));
    return n;
  }

  std::vector<std::uint32_t> corners_in_order(const ChainFacet& facet) {
    std::map<PointId, PointId> next;
    for (const ChainEdge& e : facet.edges) next[e.from()] = e.to();
    std::vector<std::uint32_t> corners;
    PointId p = next.begin()->first;
    do {
      corners.push_back(number(p));
      p = next.at(p);
    } while (p != next.begin()->first);
    return corners;
  }

  const Arrangement& space_;
  const polytope::PlacedPair& placed_;
  std::vector<std::uint32_t> numbers_;
  Solid solid_;
};

}  // namespace
}  // namespace fathom::solids

namespace fathom {

Solid solid_of(const Body& mesh) {
  const kernels::DefaultFloatEnvironment environment;
  if (mesh.shape || mesh.pieces) throw std::invalid_argument("expected a mesh, found a shape or a union of pieces");
  if (!mesh.faces) throw std::invalid_argument("expected a mesh with faces, found points alone");
  const std::vector<Point>& points = mesh.points.exact();
  if (points.empty()) throw std::invalid_argument("expected a mesh with points, found faces alone");
  const polytope::PlacedPair placed = polytope::place(points, std::span(points).first(1));
  solids::Arrangement space(placed.exponent());
  const solids::MeshChain chain(space, placed, *mesh.faces);
  std::vector<solids::ConvexPart> parts = solids::joined_parts(space, solids::parts_of(space, placed, chain));
  if (parts.empty()) throw std::invalid_argument("the mesh encloses no volume: its faces cancel");
  Solid solid = solids::SolidWriter(space, placed).run(chain, solids::in_order(space, std::move(parts)));
  solid.mesh_points = mesh.points;
  solid.mesh_faces = mesh.faces;
  return solid;
}

}  // namespace fathom
