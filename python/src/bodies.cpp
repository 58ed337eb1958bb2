// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/src/bodies.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/shape.hpp"

namespace fathom::python {
namespace {

using Triples = std::vector<std::array<double, 3>>;

/// A Pose in Python: pybind11 would make lists of a bare array.
struct ExactPose {
  Pose matrix;
};

[[noreturn]] void refuse(const std::string& sentence) { throw py::value_error(sentence); }

/// Whether each element of the array is a binary64 number.
bool fits_binary64(const py::dtype& type) {
  constexpr py::ssize_t exact_integer = 4, binary64 = 8;
  return type.kind() == 'f' ? type.itemsize() <= binary64 : (type.kind() == 'i' || type.kind() == 'u') && type.itemsize() <= exact_integer;
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

GivenPoints points_from_sequence(const py::iterable& sequence) {
  std::vector<Point> points;
  Triples doubles;
  for (const py::handle item : sequence) {
    try {
      points.push_back(point_from(item));
    } catch (const py::value_error& fault) {
      refuse("point " + std::to_string(points.size()) + ": " + fault.what());
    }
    const Point& p = points.back();
    if (doubles.size() + 1 == points.size() && are_binary64(p))
      doubles.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
  }
  if (doubles.size() == points.size()) return GivenPoints(std::move(doubles));
  return GivenPoints(std::move(points));
}

GivenPoints given_points(py::handle from) {
  if (py::isinstance<py::array>(from)) {
    const auto array = py::reinterpret_borrow<py::array>(from);
    if (fits_binary64(array.dtype())) return points_from_array(array);
  }
  if (py::hasattr(from, "vertices")) return given_points(from.attr("vertices"));
  if (py::isinstance<py::str>(from) || !py::isinstance<py::iterable>(from))
    throw py::type_error("expected an array of points, an object with `vertices`, or a shape, found " +
                         py::repr(py::type::of(from)).cast<std::string>());
  return points_from_sequence(py::reinterpret_borrow<py::iterable>(from));
}

Pose pose_from(py::handle from) {
  if (py::isinstance<ExactPose>(from)) return from.cast<ExactPose>().matrix;
  const auto rows = py::reinterpret_borrow<py::sequence>(from);
  const std::size_t count = PySequence_Check(from.ptr()) ? py::len(from) : 0;
  if (count != 3 && count != 4) refuse("expected a pose of 3 or 4 rows of 4 numbers");
  Pose pose;
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = py::reinterpret_borrow<py::sequence>(rows[i]);
    if (!PySequence_Check(row.ptr()) || py::len(row) != 4) refuse("expected a pose of 3 or 4 rows of 4 numbers");
    for (std::size_t j = 0; j < 4; ++j) {
      const mpq_class entry = number_from(row[j]);
      if (i < 3) pose[i][j] = entry;
      else if (entry != (j == 3 ? 1 : 0)) refuse("expected 0 0 0 1 as the last row of a pose of 4 rows");
    }
  }
  return pose;
}

Point placed(const Point& p, const Pose& pose) {
  const auto row = [&](std::size_t i) { return mpq_class(pose[i][0] * p.x + pose[i][1] * p.y + pose[i][2] * p.z + pose[i][3]); };
  return {row(0), row(1), row(2)};
}

Body posed(Body body, const Pose& pose) {
  if (body.shape) return {{}, moved(*body.shape, pose)};
  std::vector<Point> points;
  points.reserve(body.points.size());
  for (const Point& p : body.points) points.push_back(placed(p, pose));
  return {GivenPoints(std::move(points))};
}

/// A hull of points without radius is told by its points.
Body body_of(Shape shape) {
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (shape.radius != 0 || !terms || terms->size() != 1) return {{}, std::move(shape)};
  std::vector<Point> points;
  for (const Atom& atom : terms->front().atoms) {
    if (!atom.axes.empty()) return {{}, std::move(shape)};
    points.push_back(atom.center);
  }
  return {GivenPoints(std::move(points))};
}

Shape shape_of(const Body& body) { return body.shape ? *body.shape : hull(body.points); }

Axis axis_from(const std::string& axis) {
  if (axis == "x") return Axis::x;
  if (axis == "y") return Axis::y;
  if (axis == "z") return Axis::z;
  refuse("expected the axis 'x', 'y' or 'z', found '" + axis + "'");
}

py::object points_in_python(const Body& body) {
  if (body.shape) return py::none();
  if (body.points.in_binary64()) {
    const auto points = body.points.binary64();
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
    auto view = array.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < view.shape(0); ++i)
      for (py::ssize_t j = 0; j < 3; ++j) view(i, j) = points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    return array;
  }
  py::list list;
  for (const Point& p : body.points) list.append(fractions(p));
  return list;
}

std::string described(const Body& body) {
  if (!body.shape) return "<fathom.Body of " + std::to_string(body.points.size()) + " points>";
  if (std::holds_alternative<HalfSpace>(body.shape->core)) return "<fathom.Body, a half-space>";
  return "<fathom.Body, a shape>";
}

void bind_shapes(py::module_& module) {
  using py::arg;
  const auto number = [](const py::object& from) { return number_from(from); };
  module.def("sphere", [number](const py::object& radius) { return body_of(sphere(number(radius))); }, arg("radius"));
  module.def(
      "capsule",
      [number](const py::object& radius, const py::object& half_length, const std::string& axis) {
        return body_of(capsule(number(radius), number(half_length), axis_from(axis)));
      },
      arg("radius"), arg("half_length"), arg("axis") = "z");
  module.def(
      "tapered_capsule",
      [number](const py::object& low, const py::object& high, const py::object& half_length, const std::string& axis) {
        return body_of(tapered_capsule(number(low), number(high), number(half_length), axis_from(axis)));
      },
      arg("radius_low"), arg("radius_high"), arg("half_length"), arg("axis") = "z");
  module.def("box", [](const py::object& half) { return body_of(box(point_from(half))); }, arg("half"));
  module.def(
      "cylinder",
      [number](const py::object& radius, const py::object& half_length, const std::string& axis) {
        return body_of(cylinder(number(radius), number(half_length), axis_from(axis)));
      },
      arg("radius"), arg("half_length"), arg("axis") = "z");
  module.def(
      "cone",
      [number](const py::object& radius, const py::object& half_length, const std::string& axis) {
        return body_of(cone(number(radius), number(half_length), axis_from(axis)));
      },
      arg("radius"), arg("half_length"), arg("axis") = "z");
  module.def(
      "frustum",
      [number](const py::object& low, const py::object& high, const py::object& half_length, const std::string& axis) {
        return body_of(frustum(number(low), number(high), number(half_length), axis_from(axis)));
      },
      arg("radius_low"), arg("radius_high"), arg("half_length"), arg("axis") = "z");
  module.def("ellipsoid", [](const py::object& radii) { return body_of(ellipsoid(point_from(radii))); }, arg("radii"));
  module.def(
      "halfspace", [number](const py::object& normal, const py::object& offset) { return body_of(halfspace(point_from(normal), number(offset))); },
      arg("normal"), arg("offset"));
}

}  // namespace

Body body_from(py::handle from, py::handle pose, const char* name) try {
  Body body = py::isinstance<Body>(from) ? from.cast<Body>() : Body{given_points(from)};
  if (!body.shape && body.points.empty()) refuse("expected at least one point, found none");
  return pose.is_none() ? body : posed(std::move(body), pose_from(pose));
} catch (const py::value_error& fault) {
  refuse(std::string(name) + ": " + fault.what());
} catch (const std::invalid_argument& fault) {
  refuse(std::string(name) + ": " + fault.what());
} catch (const py::type_error& fault) {
  throw py::type_error(std::string(name) + ": " + fault.what());
}

const GivenPoints& points_of(const Body& body, const char* name) {
  if (body.shape) refuse(std::string(name) + ": expected a polytope, found a shape that is none: depth and distance take those");
  return body.points;
}

void bind_bodies(py::module_& module) {
  py::class_<ExactPose>(module, "Pose", "An exact affine map: `rows` are three rows of four numbers, or four with the last 0 0 0 1.")
      .def(py::init([](const py::object& rows) { return ExactPose{pose_from(rows)}; }), py::arg("rows"))
      .def_property_readonly("rows", [](const ExactPose& pose) {
        py::list rows;
        for (const auto& row : pose.matrix) rows.append(py::make_tuple(fraction(row[0]), fraction(row[1]), fraction(row[2]), fraction(row[3])));
        return py::tuple(rows);
      });
  module.def(
      "pose",
      [](const py::object& quaternion, const py::object& translation) {
        const auto q = py::reinterpret_borrow<py::sequence>(quaternion);
        if (!PySequence_Check(quaternion.ptr()) || py::len(quaternion) != 4) refuse("expected a quaternion w, x, y, z");
        return ExactPose{rigid_pose({number_from(q[0]), number_from(q[1]), number_from(q[2]), number_from(q[3])}, point_from(translation))};
      },
      py::arg("quaternion"), py::arg("translation"));
  py::class_<Body>(module, "Body", "A convex body: the hull of `points`, or a shape.")
      .def(py::init([](const py::object& points) { return body_from(points, py::none(), "points"); }), py::arg("points"))
      .def_property_readonly("points", points_in_python)
      .def_property_readonly("is_shape", [](const Body& body) { return body.shape.has_value(); })
      .def_property_readonly("is_flat", [](const Body& body) { return is_flat(shape_of(body)); })
      .def("moved", [](const Body& body, const py::object& pose) { return body_from(py::cast(body), pose, "body"); }, py::arg("pose"))
      .def("with_margin", [](const Body& body, const py::object& margin) { return body_of(with_margin(shape_of(body), number_from(margin))); },
           py::arg("margin"))
      .def("__add__", [](const Body& a, const Body& b) { return body_of(minkowski_sum(shape_of(a), shape_of(b))); }, py::is_operator())
      .def("__repr__", described);
  bind_shapes(module);
  module.def(
      "read_mesh",
      [](const std::string& path, const std::string& decimals) {
        if (decimals != "binary64" && decimals != "exact") refuse("expected decimals 'binary64' or 'exact', found '" + decimals + "'");
        return read_mesh(path, decimals == "exact" ? Decimals::exact : Decimals::binary64);
      },
      py::arg("path"), py::arg("decimals") = "binary64");
}

}  // namespace fathom::python
