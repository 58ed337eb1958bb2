// SPDX-License-Identifier: GPL-3.0-or-later
// Of boundary.hpp; and bodies, from the numbers and texts of C.
#include "bindings/c/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "fathom/plane.hpp"
#include "fathom/solid.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/robot.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/rounded/coordinates.hpp"

namespace fathom::c {
namespace {

/// Of a fixed size, so that a message needs no memory.
thread_local std::array<char, 1024> message{};

constexpr std::size_t most = std::size_t{1} << 31;  // of anything that is counted

std::string of_point(std::size_t i) { return "point " + std::to_string(i) + ": "; }

/// Points of so many coordinates each; z is 0 where they are two.
GivenPoints points_from(const double* numbers, std::size_t count, std::size_t dimension) {
  require_count(count, "points");
  require(numbers, dimension == 2 ? "xy" : "xyz");
  std::vector<std::array<double, 3>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(numbers + dimension * i, dimension, points[i].begin());
    for (const double x : points[i])
      if (!std::isfinite(x))
        throw std::invalid_argument(of_point(i) + "expected finite coordinates, found " + hex_text(x));
  }
  return GivenPoints(std::move(points));
}

mpq_class number_from(const char* text, std::size_t point) {
  if (text == nullptr) throw std::invalid_argument(of_point(point) + "expected a number, found NULL");
  ParsedNumber number = parse_number(text, Decimals::exact);
  if (!number.value) throw std::invalid_argument(of_point(point) + number.error);
  return *std::move(number.value);
}

GivenPoints points_from(const char* const* xyz, std::size_t count) {
  require_count(count, "points");
  require(xyz, "xyz");
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({number_from(xyz[3 * i], i), number_from(xyz[3 * i + 1], i), number_from(xyz[3 * i + 2], i)});
  return GivenPoints(std::move(points));
}

fathom_body placed(const fathom_body& from, const files::GivenPose& pose) {
  Body body = *from.body;
  files::place(body, pose);
  return handle(std::move(body));
}

/// What a mesh stands for.
files::MeshAs meshes_from(int meshes) {
  if (meshes == FATHOM_HULL) return files::MeshAs::hull;
  if (meshes == FATHOM_PIECES) return files::MeshAs::pieces;
  if (meshes == FATHOM_SOLID) return files::MeshAs::solid;
  throw std::invalid_argument("meshes: expected FATHOM_HULL, FATHOM_PIECES or FATHOM_SOLID, found " +
                              std::to_string(meshes));
}

const Body& piece_from(const fathom_body* piece, const std::string& name) {
  require(piece, name.c_str());
  require_convex(*piece->body, name);
  if (piece->body->shape)
    throw std::invalid_argument(name +
                                ": expected a polytope, found another shape: pieces are neither round nor curved");
  return *piece->body;
}

// Of solids, and of what bodies are made of.

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

void set_message(std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), message.size() - 1);
  std::memcpy(message.data(), text.data(), length);
  message[length] = '\0';
}

void require(const void* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + ": expected a pointer, found NULL");
}

void require_finite(const double* numbers, std::size_t count, const std::string& name) {
  const double* const wrong = std::find_if_not(numbers, numbers + count, [](double x) { return std::isfinite(x); });
  if (wrong != numbers + count)
    throw std::invalid_argument(name + ": expected finite numbers, found " + hex_text(*wrong) + " at index " +
                                std::to_string(wrong - numbers));
}

Twist twist_from(const double* numbers, const std::string& name) {
  if (numbers == nullptr) return {};
  require_finite(numbers, 6, name);
  const auto vector = [](const double* x) { return Point{exact_value(x[0]), exact_value(x[1]), exact_value(x[2])}; };
  return {vector(numbers), vector(numbers + 3)};
}

PoseBinary64 pose_from(const double* numbers, const std::string& name) {
  require_finite(numbers, 12, name);
  PoseBinary64 pose;
  for (std::size_t i = 0; i < 12; ++i) pose[i / 4][i % 4] = numbers[i];
  return pose;
}

char* text_for_caller(std::string_view text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.data(), text.size());
  copy[text.size()] = '\0';
  return copy;
}

void require_convex(const Body& body, const std::string& name) {
  if (body.pieces)
    throw std::invalid_argument(
        name + ": expected a convex body, found a union of pieces; those of several unions are the pieces of one");
}

void require_at_most(std::size_t count, const char* what) {
  if (count > most)
    throw std::invalid_argument(std::string("expected at most 2^31 ") + what + ", found " + std::to_string(count));
}

void require_count(std::size_t count, const char* what) {
  if (count < 1 || count > most)
    throw std::invalid_argument(std::string("expected from 1 to 2^31 ") + what + ", found " + std::to_string(count));
}

void require_below(std::size_t index, std::size_t count, const std::string& what, const std::string& of) {
  if (index < count) return;
  throw std::invalid_argument(what + ": expected one below " + std::to_string(count) + ", the number of " + of +
                              ", found " + std::to_string(index));
}

fathom_body handle(Body body) { return {std::make_shared<const Body>(std::move(body))}; }

Decimals decimals_from(int decimals) {
  if (decimals == FATHOM_BINARY64_DECIMALS) return Decimals::binary64;
  if (decimals == FATHOM_EXACT_DECIMALS) return Decimals::exact;
  throw std::invalid_argument("decimals: expected FATHOM_BINARY64_DECIMALS or FATHOM_EXACT_DECIMALS, found " +
                              std::to_string(decimals));
}

}  // namespace fathom::c

using namespace fathom::c;

const char* fathom_version() { return FATHOM_VERSION; }

const char* fathom_last_error() { return fathom::c::message.data(); }

void fathom_text_free(char* text) { std::free(text); }

// ---- bodies ----

int fathom_body_from_points(const double* xyz, size_t count, fathom_body** body) {
  return make_handle(body, [&] { return handle({points_from(xyz, count, 3)}); });
}

int fathom_body_from_plane_points(const double* xy, size_t count, fathom_body** body) {
  return make_handle(body, [&] { return handle(fathom::in_plane({points_from(xy, count, 2)})); });
}

int fathom_body_in_plane(const fathom_body* body, fathom_body** plane) {
  return make_handle(plane, [&] { return handle(fathom::in_plane(body_in(body))); });
}

int fathom_body_from_numbers(const char* const* xyz, size_t count, fathom_body** body) {
  return make_handle(body, [&] { return handle({points_from(xyz, count)}); });
}

int fathom_body_from_shape(const char* shape, int decimals, fathom_body** body) {
  return make_handle(body, [&] {
    require(shape, "shape");
    return handle(fathom::files::parse_shape(shape, decimals_from(decimals)));
  });
}

int fathom_body_read(const char* input, int meshes, const char* joints, const char* const* package_paths, size_t count,
                     int decimals, fathom_body** body) {
  return make_handle(body, [&] {
    require(input, "input");
    fathom::files::RobotOptions options{decimals_from(decimals), meshes_from(meshes)};
    if (count > 0) require(package_paths, "package_paths");
    for (std::size_t i = 0; i < count; ++i) {
      require(package_paths[i], "package_paths");
      options.package_paths.emplace_back(package_paths[i]);
    }
    const auto values = joints ? fathom::files::parse_joints(joints, options.decimals) : fathom::files::JointValues();
    if (!values)
      throw std::invalid_argument("joints: expected values such as shoulder=1/2,elbow=-0.3, found another text");
    fathom::files::InputBody read = fathom::files::read_input(input, options, *values);
    fathom::files::require_joints(read.robot ? std::vector{*read.robot} : std::vector<fathom::files::Robot>(), *values);
    const bool cut = options.meshes == fathom::files::MeshAs::solid && !read.body.pieces;
    return handle(cut ? fathom::solid_body(read.body) : std::move(read.body));
  });
}

int fathom_body_from_mesh(const char* path, int decimals, fathom_body** body) {
  return make_handle(body, [&] {
    require(path, "path");
    return handle(fathom::read_mesh(path, decimals_from(decimals)));
  });
}

int fathom_body_from_pieces(fathom_body* const* pieces, size_t count, fathom_body** body) {
  return make_handle(body, [&] {
    require_count(count, "pieces");
    require(pieces, "pieces");
    std::vector<fathom::Body> meshes;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string name = "piece " + std::to_string(i);
      meshes.push_back(piece_from(pieces[i], name));
      if (meshes.back().dimension != meshes.front().dimension)
        throw std::invalid_argument(name + ": expected pieces that are all of the plane, or all of space");
    }
    return handle(fathom::files::union_of(meshes));
  });
}

int fathom_body_from_piece_files(const char* path, int decimals, fathom_body** body) {
  return make_handle(body, [&] {
    require(path, "path");
    return handle(fathom::files::read_union(path, decimals_from(decimals)));
  });
}

int fathom_bodies_from_case(const char* json, fathom_body** a, fathom_body** b) {
  if (a) *a = nullptr;
  if (b) *b = nullptr;
  return guarded([&] {
    require(json, "json");
    require(a, "the place for body a");
    require(b, "the place for body b");
    fathom::CaseItem item = fathom::parse_case(json, "case");
    if (!item.ok()) throw item.error();
    auto& both = std::get<fathom::Case>(item.outcome);
    auto first = std::make_unique<fathom_body>(handle(std::move(both.a)));
    *b = std::make_unique<fathom_body>(handle(std::move(both.b))).release();
    *a = first.release();
  });
}

int fathom_body_moved(const fathom_body* body, const double pose[12], fathom_body** moved) {
  return make_handle(moved, [&] {
    require(body, "body");
    require(pose, "pose");
    return placed(*body, {fathom::files::exact_pose(pose_from(pose, "pose"))});
  });
}

int fathom_body_posed(const fathom_body* body, const char* pose, int decimals, fathom_body** moved) {
  return make_handle(moved, [&] {
    require(body, "body");
    require(pose, "pose");
    std::string fault;
    const fathom::files::GivenPose read = fathom::files::parse_pose(pose, decimals_from(decimals), fault);
    if (!fault.empty()) throw std::invalid_argument("pose: " + fault);
    return placed(*body, read);
  });
}

void fathom_body_free(fathom_body* body) { delete body; }

// Closed meshes and their solids; and what bodies are made of, read back.

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
    fathom::Body result{pieces[index]};
    result.dimension = body->body->dimension;
    return handle(std::move(result));
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
