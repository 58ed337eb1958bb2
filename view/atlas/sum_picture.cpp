// SPDX-License-Identifier: GPL-3.0-or-later
// The part of atlas.hpp about P.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "view/atlas/limits.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/sum_scene.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::atlas {
namespace {

using stages::Place;
using stages::StagedFacet;
using stages::StagedSum;
using stages::SumKind;

/// A place as it is before it was scaled, exactly.
Point unscaled(const Place& place, const stages::StagedScale& scale) {
  mpq_class unit = 1;
  if (scale.exponent >= 0) unit >>= static_cast<mp_bitcnt_t>(scale.exponent);
  else unit <<= static_cast<mp_bitcnt_t>(-scale.exponent);
  return unit * Point{exact_value(place[0]), exact_value(place[1]), exact_value(place[2])};
}

std::vector<Point> corners_of(const picture::Mesh& mesh, const stages::Indices& facet) {
  std::vector<Point> corners;
  for (const stages::Index v : facet) corners.push_back(mesh.vertices[v]);
  return corners;
}

picture::Mesh mesh_of(const StagedSum& sum, const stages::StagedScale& scale) {
  picture::Mesh mesh;
  mesh.creases = sum.kind == SumKind::sampled;
  for (const Place& place : sum.vertices) mesh.vertices.push_back(unscaled(place, scale));
  for (const StagedFacet& facet : sum.facets) {
    mesh.polygons.push_back(facet.vertices);
    mesh.normals.push_back({facet.normal[0], facet.normal[1], facet.normal[2]});
  }
  return mesh;
}

picture::Mesh mesh_of(const stages::PieceSum& sum, const stages::StagedScale& scale) {
  picture::Mesh mesh;
  for (const Place& place : sum.vertices) mesh.vertices.push_back(unscaled(place, scale));
  mesh.polygons = sum.facets;
  for (const Place& n : sum.normals) mesh.normals.push_back({n[0], n[1], n[2]});
  return mesh;
}

/// A unit vector across the plane between two pieces that touch; the one that is the least along the way.
std::optional<Point> second_of(const stages::StagedUnionWay& way) {
  const auto cosine = [&](const stages::StagedTouch& touch) {
    double product = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i)
      product += touch.direction[i] * way.translation[i], square += way.translation[i] * way.translation[i];
    return product * product / square;
  };
  const auto least = std::ranges::min_element(way.touching, {}, cosine);
  if (least == way.touching.end()) return std::nullopt;
  const Place& n = least->direction;
  return Point{exact_value(n[0]), exact_value(n[1]), exact_value(n[2])};
}

/// From O to the nearest facet, of any size: in the unit of places it may have vanished.
Point way_out(const stages::Stages& stages) {
  if (stages.sum.kind == SumKind::sampled) return unscaled(stages.contact.optima.front().translation, stages.scale);
  constexpr unsigned bits = 128;
  const Place& n = stages.contact.optima.front().direction;
  const mpf_class root = sqrt(mpf_class(stages.sum.facets.front().squared, bits));
  return mpq_class(root) * Point{exact_value(n[0]), exact_value(n[1]), exact_value(n[2])};
}

std::string edges_note(const picture::Mesh& mesh) {
  const std::size_t edges = picture::edges_count(mesh);
  if (mesh.creases) return " Of the mesh only sharp edges and the outline are drawn.";
  if (edges > picture::most_edges) return fmt::format(" Of its {} edges those of the outline alone are drawn.", edges);
  if (edges > picture::most_hidden) return fmt::format(" Of its {} edges those behind are not drawn.", edges);
  return "";
}

}  // namespace

SumPicture sum_picture(const stages::Stages& stages, const std::string& prefix) {
  const StagedSum& sum = stages.sum;
  if (sum.facets.empty() || stages.contact.optima.empty()) return {};
  const Point way = way_out(stages);
  if (way == Point{}) return {};
  const picture::View view(way, std::nullopt);
  const picture::Mesh mesh = mesh_of(sum, stages.scale);
  picture::SumScene scene{view, {picture::wires_of(mesh, view)}, {}, way, mesh.creases};
  const std::size_t ties = static_cast<std::size_t>(std::ranges::count(sum.facets, true, &StagedFacet::optimal));
  for (const StagedFacet& facet : sum.facets) {
    if (!facet.optimal || scene.nearest.size() == most_optima) continue;
    scene.nearest.push_back(corners_of(mesh, facet.vertices));
  }
  const std::string name = sum.kind == SumKind::q ? "Q, inside P," : mesh.creases ? "A mesh near P" : "P";
  std::string note = fmt::format("{} around O, seen across n. The circle is the ball whose radius is the depth", name);
  if (ties == 1) note += "; it touches the facet that is marked, here seen from its edge.";
  else if (ties > 1) note += fmt::format("; it touches {} facets, which are marked.", ties);
  else note += ".";
  if (ties > most_optima) note += fmt::format(" Only {} of them are.", most_optima);
  note += edges_note(mesh);
  if (picture::is_speck(scene)) note += " Beside all of it the ball is too small to be seen.";
  return {picture::sum_panels(scene, picture::markup(prefix), "P around O, with the ball that touches its nearest facets",
                              picture::markup(note)),
          note};
}

SumPicture sum_picture(const stages::UnionStages& stages, const std::string& prefix) {
  if (stages.sums.empty()) return {};
  const stages::StagedUnionWay& first = stages.ways.front();
  const Point way = unscaled(first.translation, stages.scale);
  if (way == Point{}) return {};
  const picture::View view(way, second_of(first));
  picture::SumScene scene{view, {}, {}, way};
  std::size_t touching = 0;
  for (const stages::PieceSum& sum : stages.sums) {
    if (std::ranges::find(sum.touches, 0U) == sum.touches.end()) continue;
    ++touching;
    if (sum.facets.empty()) continue;
    const picture::Mesh mesh = mesh_of(sum, stages.scale);
    scene.sums.push_back(picture::wires_of(mesh, view));
    for (const auto& [facet, end] : sum.through)
      if (end == 0) scene.nearest.push_back(corners_of(mesh, sum.facets[facet]));
  }
  if (scene.sums.empty()) return {};
  std::string note = fmt::format(
      "The differences of {} of pieces that touch after the way out, around O. The circle is the ball whose radius is the depth; the arrow "
      "ends "
      "where the facets meet that are marked.",
      touching == 1 ? "the one pair" : fmt::format("the {} pairs", touching));
  if (scene.sums.size() < touching) note += fmt::format(" {} of them are not drawn.", touching - scene.sums.size());
  if (const std::size_t others = stages.sums.size() - touching; others > 0)
    note += fmt::format(" {} reach into the ball, and are left out of this picture.",
                        others == 1 ? "One more pair's differences" : fmt::format("Those of {} more pairs", others));
  return {picture::sum_panels(scene, picture::markup(prefix), "Differences of pieces around O, with the ball", picture::markup(note)),
          note};
}

}  // namespace fathom::atlas
