// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs by how they meet. A stands above the plane z = 0 and B below; a roof over a square base ends in a vertex, an edge or a face.
#include "verify/families/catalogue_groups.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

constexpr std::string_view interior = "O is in the interior of P", edges_cross = "no parallel edges", full_normals = "facets are simplices";

/// A's lowest feature, at z = 0 and around O; the edge runs along x. The base is at z = 2.
Body above(FeatureKind feature) {
  Body body;
  if (feature == FeatureKind::vertex) body.points = {{0, 0, 0}};
  if (feature == FeatureKind::edge) body.points = {{-1, 0, 0}, {1, 0, 0}};
  if (feature == FeatureKind::face) body.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  for (const Point& corner : {Point{-2, -2, 2}, Point{2, -2, 2}, Point{2, 2, 2}, Point{-2, 2, 2}}) body.points.push_back(corner);
  return body;
}

/// B's highest feature, at z = 0 and around O; the edge runs along y. The base is at z = -2.
Body below(FeatureKind feature) { return rotated(above(feature), {Point{0, 1, 0}, Point{1, 0, 0}, Point{0, 0, -1}}); }

Body lowered(const Body& body, const mpq_class& by) { return translated(body, {0, 0, mpq_class(-by)}); }

CatalogueEntry touching_entry(std::string_view name, std::string_view description, FeatureKind a, FeatureKind b) {
  return entry(name, interior, description, touches, above(a), below(b));
}

CatalogueEntry contact_entry(std::string_view name, std::string_view description, ContactKind kind, FeatureKind a, FeatureKind b) {
  return entry(name, kind == ContactKind::edge_edge ? "no shared facet normals" : full_normals, description, {Status::penetrating, 1, kind},
               lowered(above(a), ratio(1, 4)), below(b));
}

}  // namespace

Entries touching_entries() {
  using enum FeatureKind;
  return {
      touching_entry("touching_vertex_vertex", "the tips of two pyramids touch in exactly one point", vertex, vertex),
      touching_entry("touching_vertex_edge", "the tip of a pyramid touches the ridge of a roof in exactly one point", vertex, edge),
      touching_entry("touching_vertex_face", "the tip of a pyramid touches a face in exactly one point", vertex, face),
      touching_entry("touching_edge_vertex", "the ridge of a roof touches the tip of a pyramid in exactly one point", edge, vertex),
      touching_entry("touching_edge_edge", "two ridges cross in exactly one point", edge, edge),
      touching_entry("touching_edge_face", "the ridge of a roof lies in a face", edge, face),
      touching_entry("touching_face_vertex", "a face touches the tip of a pyramid in exactly one point", face, vertex),
      touching_entry("touching_face_edge", "the ridge of a roof lies in a face of A", face, edge),
      touching_entry("touching_face_face", "two faces lie in one plane and overlap", face, face),
      entry("touching_parallel_edges", edges_cross, "two ridges overlap in a segment", touches, above(edge),
            translated(scaled(above(edge), 1, 1, -1), {1, 0, 0})),
      entry("touching_cubes_corner", interior, "two cubes of a grid share exactly one point, a corner of both", touches,
            block({0, 0, 0}, {1, 1, 1}), block({1, 1, 1}, {2, 2, 2})),
      entry("touching_cubes_edge", interior, "two cubes of a grid share an edge", touches, block({0, 0, 0}, {1, 1, 1}),
            block({1, 1, 0}, {2, 2, 1})),
      entry("touching_cubes_facet", interior, "two cubes of a grid share a facet", touches, block({0, 0, 0}, {1, 1, 1}),
            block({1, 0, 0}, {2, 1, 1})),
  };
}

Entries contact_entries() {
  using enum FeatureKind;
  using enum ContactKind;
  const Body roof = lowered(above(edge), ratio(1, 4));
  return {
      contact_entry("contact_facet_vertex", "a face is a quarter deep in the tip of a pyramid", facet_vertex, face, vertex),
      contact_entry("contact_vertex_facet", "the tip of a pyramid is a quarter deep in a face", vertex_facet, vertex, face),
      contact_entry("contact_facet_edge", "a face is a quarter deep in the ridge of a roof", facet_edge, face, edge),
      contact_entry("contact_edge_facet", "the ridge of a roof is a quarter deep in a face", edge_facet, edge, face),
      contact_entry("contact_facet_facet", "a face is a quarter deep in a face", facet_facet, face, face),
      contact_entry("contact_edge_edge", "two crossing ridges are a quarter deep in each other", edge_edge, edge, edge),
      entry("contact_parallel_edges", edges_cross,
            "two parallel ridges are a quarter deep in each other: no facet of P is theirs, the nearest are of the roofs",
            {Status::penetrating, 2, facet_facet}, roof, scaled(above(edge), 1, 1, -1)),
      entry("contact_cubes", full_normals, "two unit cubes of a grid, a third deep: four pairs of coplanar facets",
            {Status::penetrating, 1, facet_facet}, block({0, 0, 0}, {1, 1, 1}), block({ratio(2, 3), 0, 0}, {ratio(5, 3), 1, 1})),
  };
}

}  // namespace fathom::families
