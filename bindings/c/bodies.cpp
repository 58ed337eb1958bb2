// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies from the numbers and texts of C.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/boundary.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::c {
namespace {

std::string of_point(std::size_t i) { return "point " + std::to_string(i) + ": "; }

GivenPoints points_from(const double* xyz, std::size_t count) {
  require_count(count, "points");
  require(xyz, "xyz");
  std::vector<std::array<double, 3>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
    for (const double x : points[i])
      if (!std::isfinite(x)) throw std::invalid_argument(of_point(i) + "expected finite coordinates, found " + hex_text(x));
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

files::GivenPose pose_from(const double* numbers) {
  Pose pose;
  for (std::size_t i = 0; i < 12; ++i) {
    if (!std::isfinite(numbers[i]))
      throw std::invalid_argument("pose: expected finite numbers, found " + hex_text(numbers[i]) + " at index " + std::to_string(i));
    pose[i / 4][i % 4] = exact_value(numbers[i]);
  }
  return {pose};
}

const std::vector<Point>& piece_from(const fathom_body* piece, const std::string& name) {
  require(piece, name.c_str());
  require_convex(*piece->body, name);
  if (piece->body->shape)
    throw std::invalid_argument(name + ": expected a polytope, found another shape: pieces are neither round nor curved");
  return piece->body->points.exact();
}

}  // namespace
}  // namespace fathom::c

using namespace fathom::c;

int fathom_body_from_points(const double* xyz, size_t count, fathom_body** body) {
  return make_handle(body, [&] { return handle({points_from(xyz, count)}); });
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
    fathom::Pieces points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(piece_from(pieces[i], "piece " + std::to_string(i)));
    return handle(fathom::files::union_of(std::move(points)));
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
    return placed(*body, pose_from(pose));
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
