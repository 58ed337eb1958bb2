// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "bindings/python/src/numbers.hpp"

namespace fathom::python {
namespace {

using Triples = std::vector<std::array<double, 3>>;

[[noreturn]] void refuse(const std::string& sentence) { throw py::value_error(sentence); }

/// Whether each element of the array is a binary64 number.
bool fits_binary64(const py::dtype& type) {
  constexpr py::ssize_t exact_integer = 4, binary64 = 8;
  return type.kind() == 'f' ? type.itemsize() <= binary64 : (type.kind() == 'i' || type.kind() == 'u') && type.itemsize() <= exact_integer;
}

/// A mask says that some numbers are none: which ones are to count, only the caller knows.
void refuse_masks(py::handle from) {
  if (!py::hasattr(from, "mask")) return;
  const py::object any = py::module_::import("numpy").attr("any")(from.attr("mask"));
  if (any.cast<bool>()) refuse("expected an array without a mask, found one where some numbers are masked: drop or fill them first");
}

GivenPoints points_from_array(const py::array& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i) shape += (i == 0 ? "" : " x ") + std::to_string(array.shape(i));
    refuse("expected an array of n x 3 coordinates, found one of " + (shape.empty() ? "no dimension" : shape));
  }
  const auto doubles = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!doubles) throw py::error_already_set();
  const auto view = doubles.unchecked<2>();
  Triples points(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < view.shape(0); ++i) {
    std::array<double, 3>& point = points[static_cast<std::size_t>(i)];
    point = {view(i, 0), view(i, 1), view(i, 2)};
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
      refuse("expected finite coordinates, found others in row " + std::to_string(i));
  }
  return GivenPoints(std::move(points));
}

bool are_binary64(const Point& p) {
  const auto is = [](const mpq_class& x) {
    const double nearest = round_binary64(x);
    return std::isfinite(nearest) && exact_value(nearest) == x;
  };
  return is(p.x) && is(p.y) && is(p.z);
}

/// The first item of a sequence that has one and is no text; else None.
py::object first_of(py::handle from) {
  if (py::isinstance<py::str>(from) || !PySequence_Check(from.ptr())) return py::none();
  auto item = py::reinterpret_steal<py::object>(PySequence_GetItem(from.ptr(), 0));
  if (item) return item;
  PyErr_Clear();
  return py::none();
}

GivenPoints points_from_sequence(const py::iterable& sequence) {
  std::vector<Point> points;
  for (const py::handle item : sequence) {
    try {
      points.push_back(point_from(item));
    } catch (const py::value_error& fault) {
      if (is_one_body(item)) refuse("expected a convex body, found a list of bodies: union_depth takes such a list as their union");
      refuse("point " + std::to_string(points.size()) + ": " + fault.what());
    }
  }
  return given_form(std::move(points));
}

[[noreturn]] void refuse_type(const std::string& expected, py::handle found) {
  throw py::type_error("expected " + expected + ", found " + py::repr(py::type::of(found)).cast<std::string>());
}

/// As many indices in each face, three as trimesh has them, or more.
MeshFaces faces_from(py::handle from, std::size_t points) {
  if (py::isinstance<py::array>(from)) refuse_masks(from);
  const auto given = py::array::ensure(from);
  const bool integers = given && (given.dtype().kind() == 'i' || given.dtype().kind() == 'u');
  if (!integers || given.ndim() != 2 || given.shape(1) < 3) {
    PyErr_Clear();
    refuse("expected faces as an array of integers, n x 3");
  }
  const auto indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(given);
  const auto view = indices.unchecked<2>();
  MeshFaces faces;
  for (py::ssize_t i = 0; i < view.shape(0); ++i) {
    for (py::ssize_t j = 0; j < view.shape(1); ++j) {
      const std::int64_t corner = view(i, j);
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        refuse("face " + std::to_string(i) + ": expected an index below " + std::to_string(points) + ", found " + std::to_string(corner));
      faces.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
  return faces;
}

/// Whether there is at least one face.
bool has_faces(py::handle from) {
  const py::object faces = py::getattr(from, "faces", py::none());
  return !faces.is_none() && !(PySequence_Check(faces.ptr()) && py::len(faces) == 0);
}

/// Of an array, or of a sequence of points.
GivenPoints plain_points(py::handle from) {
  if (py::isinstance<py::array>(from)) {
    refuse_masks(from);
    const auto array = py::reinterpret_borrow<py::array>(from);
    if (fits_binary64(array.dtype())) return points_from_array(array);
  }
  if (py::isinstance<py::str>(from) || !py::isinstance<py::iterable>(from))
    refuse_type("an array of points, an object with `vertices`, or a shape", from);
  return points_from_sequence(py::reinterpret_borrow<py::iterable>(from));
}

}  // namespace

GivenPoints given_form(std::vector<Point> points) {
  if (!std::ranges::all_of(points, are_binary64)) return GivenPoints(std::move(points));
  Triples doubles;
  for (const Point& p : points) doubles.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
  return GivenPoints(std::move(doubles));
}

GivenPoints given_points(py::handle from) {
  if (py::isinstance<py::array>(from) || !py::hasattr(from, "vertices")) return plain_points(from);
  const py::object vertices = from.attr("vertices");
  if (!py::isinstance<py::array>(vertices) && py::hasattr(vertices, "vertices"))  // it may go on like that for ever
    refuse_type("`vertices` to be an array of points", vertices);
  return plain_points(vertices);
}

std::shared_ptr<const MeshFaces> given_faces(py::handle from, std::size_t points) {
  if (!py::hasattr(from, "vertices") || !has_faces(from)) return nullptr;
  return std::make_shared<const MeshFaces>(faces_from(from.attr("faces"), points));
}

bool is_one_body(py::handle from) {
  if (py::isinstance<Body>(from) || py::hasattr(from, "vertices")) return true;
  const py::object number = first_of(first_of(from));
  return !number.is_none() && first_of(number).is_none();
}

}  // namespace fathom::python
