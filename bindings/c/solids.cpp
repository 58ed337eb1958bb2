// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes and their solids, for C; and what bodies are made of, read back.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bindings/c/boundary.hpp"
#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "reference/rounded/coordinates.hpp"

namespace fathom::c {
namespace {

const Body& body_in(const fathom_body* body) {
  require(body, "body");
  return *body->body;
}

const Pieces& pieces_in(const fathom_body* body) {
  if (!body_in(body).pieces) throw Absence("the body is no union of pieces");
  return *body->body->pieces;
}

/// Of the hull of points: those that were given.
const std::vector<Point>& points_in(const fathom_body* body) {
  const Body& of = body_in(body);
  if (of.pieces || of.shape) throw Absence("the body is not the hull of points");
  return of.points.exact();
}

std::shared_ptr<const MeshFaces> faces_from(const unsigned* corners, std::size_t count, std::size_t points) {
  require_count(count, "triangles");
  require(corners, "corners");
  MeshFaces faces;
  for (std::size_t i = 0; i < 3 * count; ++i) {
    if (corners[i] >= points) require_below(corners[i], points, "triangle " + std::to_string(i / 3), "points");
    faces.corners.push_back(static_cast<std::uint32_t>(corners[i]));
  }
  return std::make_shared<const MeshFaces>(std::move(faces));
}

}  // namespace
}  // namespace fathom::c

using namespace fathom::c;

int fathom_body_with_triangles(const fathom_body* points, const unsigned* corners, size_t count, fathom_body** mesh) {
  return make_handle(mesh, [&] {
    fathom::Body result{body_in(points).points};
    result.faces = faces_from(corners, count, points_in(points).size());
    return handle(std::move(result));
  });
}

int fathom_body_solid(const fathom_body* mesh, fathom_body** solid) {
  return make_handle(solid, [&] { return handle(solid_body(body_in(mesh))); });
}

int fathom_body_volume(const fathom_body* solid, double* volume, char** exact) {
  if (exact) *exact = nullptr;
  return guarded([&] {
    if (!body_in(solid).solid) throw Absence("the body is not the solid of a mesh");
    const mpq_class value = fathom::volume(*solid->body->solid);
    if (volume) *volume = fathom::round_binary64(value);
    if (exact) *exact = text_for_caller(fathom::exact_text(value));
  });
}

int fathom_body_pieces(const fathom_body* body, size_t* count) {
  return guarded([&] {
    require(count, "count");
    *count = pieces_in(body).size();
  });
}

int fathom_body_piece(const fathom_body* body, size_t index, fathom_body** piece) {
  return make_handle(piece, [&] {
    const fathom::Pieces& pieces = pieces_in(body);
    require_below(index, pieces.size(), "index", "pieces");
    return handle({pieces[index]});
  });
}

int fathom_body_points(const fathom_body* body, size_t* count) {
  return guarded([&] {
    require(count, "count");
    *count = points_in(body).size();
  });
}

int fathom_body_point(const fathom_body* body, size_t index, double point[3], char** exact) {
  if (exact) *exact = nullptr;
  return guarded([&] {
    const std::vector<fathom::Point>& points = points_in(body);
    require_below(index, points.size(), "index", "points");
    const fathom::SurdPoint values = fathom::rounded::coordinates(points[index]);
    if (point) copy_numbers(fathom::rounded::nearest_binary64(values), point);
    if (exact) *exact = text_for_caller(coordinates_text(values));
  });
}
