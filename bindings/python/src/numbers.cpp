// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/src/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace fathom::python {
namespace {

mpz_class integer_from(py::handle number) {
  int overflow = 0;
  const long small = PyLong_AsLongAndOverflow(number.ptr(), &overflow);
  if (overflow == 0) return small;
  const auto digits = py::reinterpret_steal<py::str>(PyNumber_ToBase(number.ptr(), 16));
  if (!digits) throw py::error_already_set();
  return mpz_class(digits.cast<std::string>(), 0);
}

/// Returns the type Fraction, imported once, because every exact number becomes one.
const py::object& fraction_type() {
  static const py::object& type = *new py::object(py::module_::import("fractions").attr("Fraction"));
  return type;
}

const py::object& decimal_type() {
  static const py::object& type = *new py::object(py::module_::import("decimal").attr("Decimal"));
  return type;
}

mpq_class number_from_text(py::handle text) {
  ParsedNumber parsed = parse_number(text_from(text), Decimals::exact);
  if (!parsed.value) throw py::value_error(parsed.error);
  return *std::move(parsed.value);
}

[[noreturn]] void refuse_what_is_no_number(py::handle found) {
  throw py::type_error("expected a number (float, int, Fraction, Decimal or text), found " + shown(found));
}

/// Returns numerator / denominator, two ints; `number`, which they belong to, is for messages.
mpq_class quotient(py::handle number, py::handle numerator, py::handle denominator) {
  if (!PyLong_Check(numerator.ptr()) || !PyLong_Check(denominator.ptr())) refuse_what_is_no_number(number);
  mpq_class value(integer_from(numerator), integer_from(denominator));
  if (value.get_den() == 0)
    throw py::value_error("expected a number, found " + shown(number) + ": the denominator is zero");
  value.canonicalize();
  return value;
}

py::object integer_ratio(py::handle number) try {
  return number.attr("as_integer_ratio")();
} catch (py::error_already_set& raised) {
  if (!raised.matches(PyExc_OverflowError) && !raised.matches(PyExc_ValueError)) throw;  // infinity and NaN
  throw py::value_error("expected a finite number, found " + shown(number));
}

/// Returns an attribute of some integer type as an int.
py::object int_attribute(py::handle number, const char* name) {
  auto found = py::reinterpret_steal<py::object>(PyNumber_Index(number.attr(name).ptr()));
  if (found) return found;
  PyErr_Clear();
  refuse_what_is_no_number(number);
}

// ---- points and faces ----

using Triples = std::vector<std::array<double, 3>>;

/// Returns whether each element of the array is a binary64 number.
bool fits_binary64(const py::dtype& type) {
  constexpr py::ssize_t exact_integer = 4, binary64 = 8;
  return type.kind() == 'f' ? type.itemsize() <= binary64
                            : (type.kind() == 'i' || type.kind() == 'u') && type.itemsize() <= exact_integer;
}

/// Throws for a masked array: only the caller knows what to do with the numbers that are masked.
void refuse_masks(py::handle from) {
  if (!py::hasattr(from, "mask")) return;
  const py::object any = py::module_::import("numpy").attr("any")(from.attr("mask"));
  if (any.cast<bool>())
    refuse("expected an array without a mask, found one where some numbers are masked: drop or fill them first");
}

/// Each row has two or three numbers.
Body body_from_rows(const double* rows, py::ssize_t count, py::ssize_t dimension) {
  const auto length = static_cast<std::size_t>(dimension);
  Triples points(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::copy_n(rows + length * i, length, points[i].begin());
    if (!std::ranges::all_of(points[i], [](double c) { return std::isfinite(c); }))
      refuse("expected finite coordinates, found others in row " + std::to_string(i));
  }
  Body body{GivenPoints(std::move(points))};
  body.dimension = static_cast<unsigned>(dimension);
  return body;
}

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns the rows of an array of `dimensions` dimensions.
Rows rows_of(const py::array& array, py::ssize_t dimensions, const char* expected) {
  if (array.ndim() != dimensions || (array.shape(dimensions - 1) != 3 && array.shape(dimensions - 1) != 2)) {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i) shape += (i == 0 ? "" : " x ") + std::to_string(array.shape(i));
    refuse(std::string("expected an array of ") + expected + " coordinates, found one of " +
           (shape.empty() ? "no dimension" : shape));
  }
  Rows rows = Rows::ensure(array);
  if (!rows) throw py::error_already_set();
  return rows;
}

Body body_from_array(const py::array& array) {
  const Rows rows = rows_of(array, 2, "n x 3 or n x 2");
  return body_from_rows(rows.data(), rows.shape(0), rows.shape(1));
}

bool are_binary64(const Point& p) {
  const auto is = [](const mpq_class& x) {
    const double nearest = round_binary64(x);
    return std::isfinite(nearest) && exact_value(nearest) == x;
  };
  return is(p.x) && is(p.y) && is(p.z);
}

/// Returns the first item of a nonempty sequence that is no text; else None.
py::object first_of(py::handle from) {
  if (py::isinstance<py::str>(from) || !PySequence_Check(from.ptr())) return py::none();
  auto item = py::reinterpret_steal<py::object>(PySequence_GetItem(from.ptr(), 0));
  if (item) return item;
  PyErr_Clear();
  return py::none();
}

/// Returns whether the object is two things that are no sequences, as a point of the plane is.
bool are_two(py::handle from) {
  return PySequence_Check(from.ptr()) && !py::isinstance<py::str>(from) && py::len(from) == 2 &&
         first_of(first_of(from)).is_none();
}

Body body_from_sequence(const py::iterable& sequence) {
  std::vector<Point> points;
  unsigned dimension = 3;
  for (const py::handle item : sequence) {
    if (points.empty() && are_two(item)) dimension = 2;
    try {
      points.push_back(point_from(item, dimension));
    } catch (const py::value_error& fault) {
      if (is_one_body(item))
        refuse("expected a convex body, found a list of bodies: union_depth takes such a list as their union");
      refuse("point " + std::to_string(points.size()) + ": " + fault.what());
    }
  }
  Body body{given_form(std::move(points))};
  body.dimension = dimension;
  return body;
}

[[noreturn]] void refuse_type(const std::string& expected, py::handle found) {
  throw py::type_error("expected " + expected + ", found " + py::repr(py::type::of(found)).cast<std::string>());
}

/// Returns the faces of a mesh. Each has the same number of indices: three, as in trimesh, or more.
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
        refuse("face " + std::to_string(i) + ": expected an index below " + std::to_string(points) + ", found " +
               std::to_string(corner));
      faces.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
  return faces;
}

/// Returns whether there is at least one face.
bool has_faces(py::handle from) {
  const py::object faces = py::getattr(from, "faces", py::none());
  return !faces.is_none() && !(PySequence_Check(faces.ptr()) && py::len(faces) == 0);
}

/// Returns the body of an array, or of a sequence of points.
Body plain_points(py::handle from) {
  if (py::isinstance<py::array>(from)) {
    refuse_masks(from);
    const auto array = py::reinterpret_borrow<py::array>(from);
    if (fits_binary64(array.dtype())) return body_from_array(array);
  }
  if (py::isinstance<py::str>(from) || !py::isinstance<py::iterable>(from))
    refuse_type("an array of points, an object with `vertices`, or a shape", from);
  return body_from_sequence(py::reinterpret_borrow<py::iterable>(from));
}

}  // namespace

std::string shown(py::handle value) {
  constexpr std::size_t readable = 60;
  const auto ascii = py::reinterpret_steal<py::object>(PyObject_ASCII(value.ptr()));
  if (!ascii) {  // its __repr__ raised, or it is an int of too many digits
    PyErr_Clear();
    return std::string("an object of type ") + Py_TYPE(value.ptr())->tp_name;
  }
  const auto text = ascii.cast<std::string>();
  return text.size() <= readable ? text : text.substr(0, readable) + "...";
}

std::string text_from(py::handle text) {
  Py_ssize_t size = 0;
  const char* const bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes) return {bytes, static_cast<std::size_t>(size)};
  PyErr_Clear();
  throw py::value_error("expected a text of whole characters, found " + shown(text));
}

mpq_class number_from(py::handle number) {
  if (PyFloat_Check(number.ptr())) {
    const double value = PyFloat_AS_DOUBLE(number.ptr());
    if (!std::isfinite(value)) throw py::value_error("expected a finite number, found " + shown(number));
    return exact_value(value);
  }
  if (PyBool_Check(number.ptr())) throw py::type_error("expected a number, found " + shown(number));
  if (PyLong_Check(number.ptr())) return integer_from(number);
  if (PyUnicode_Check(number.ptr())) return number_from_text(number);
  if (py::isinstance(number, decimal_type())) {  // a large exponent would make an int beyond any memory
    if (!number.attr("is_finite")().cast<bool>())
      throw py::value_error("expected a finite number, found " + shown(number));
    return number_from_text(py::str(number));
  }
  if (py::hasattr(number, "as_integer_ratio")) {
    const py::object ratio = integer_ratio(number);
    if (!PyTuple_Check(ratio.ptr()) || PyTuple_GET_SIZE(ratio.ptr()) != 2) refuse_what_is_no_number(number);
    return quotient(number, PyTuple_GET_ITEM(ratio.ptr(), 0), PyTuple_GET_ITEM(ratio.ptr(), 1));
  }
  if (py::hasattr(number, "numerator") && py::hasattr(number, "denominator"))  // integers of numpy, numbers.Rational
    return quotient(number, int_attribute(number, "numerator"), int_attribute(number, "denominator"));
  refuse_what_is_no_number(number);
}

double float_from(py::handle number, const std::string& name) {
  const double value = PyFloat_AsDouble(number.ptr());
  if (value != -1 || !PyErr_Occurred()) return value;
  const bool too_large = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
  PyErr_Clear();
  if (too_large) throw py::value_error(name + ": expected a number within binary64, found " + shown(number));
  throw py::type_error(name + ": expected a number, found " + shown(number));
}

Point point_from(py::handle point, unsigned dimension) {
  if (!PySequence_Check(point.ptr()) || PyUnicode_Check(point.ptr()) || py::len(point) != dimension)
    throw py::value_error((dimension == 2 ? "expected two numbers, found " : "expected three numbers, found ") +
                          shown(point));
  const auto items = py::reinterpret_borrow<py::sequence>(point);
  return {number_from(items[0]), number_from(items[1]), dimension == 2 ? mpq_class(0) : number_from(items[2])};
}

py::object integer(const mpz_class& value) {
  if (value.fits_slong_p()) return py::int_(value.get_si());
  return py::reinterpret_steal<py::object>(PyLong_FromString(value.get_str(16).c_str(), nullptr, 16));
}

py::object fraction(const mpq_class& value) {
  return fraction_type()(integer(value.get_num()), integer(value.get_den()));
}

py::tuple fractions(const Point& p, unsigned dimension) {
  if (dimension == 2) return py::make_tuple(fraction(p.x), fraction(p.y));
  return py::make_tuple(fraction(p.x), fraction(p.y), fraction(p.z));
}

py::tuple integers(const Vector& v, unsigned dimension) {
  if (dimension == 2) return py::make_tuple(integer(v.x), integer(v.y));
  return py::make_tuple(integer(v.x), integer(v.y), integer(v.z));
}

py::array_t<double> array(const std::array<double, 3>& values, unsigned dimension) {
  return py::array_t<double>(dimension, values.data());
}

py::array_t<double> array(const Point& p, unsigned dimension) {
  return array(std::array{round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)}, dimension);
}

GivenPoints given_form(std::vector<Point> points) {
  if (!std::ranges::all_of(points, are_binary64)) return GivenPoints(std::move(points));
  Triples doubles;
  for (const Point& p : points) doubles.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
  return GivenPoints(std::move(doubles));
}

Body given_points(py::handle from) {
  if (py::isinstance<py::array>(from) || !py::hasattr(from, "vertices")) return plain_points(from);
  const py::object vertices = from.attr("vertices");
  if (!py::isinstance<py::array>(vertices) && py::hasattr(vertices, "vertices"))  // a chain of them may be endless
    refuse_type("`vertices` to be an array of points", vertices);
  return plain_points(vertices);
}

std::optional<std::vector<MaybeBody>> stacked_points(py::handle from) {
  if (!py::isinstance<py::array>(from)) return std::nullopt;
  const auto array = py::reinterpret_borrow<py::array>(from);
  if (array.ndim() != 3 || !fits_binary64(array.dtype())) return std::nullopt;
  refuse_masks(from);
  const Rows rows = rows_of(array, 3, "n x m x 3 or n x m x 2");
  std::vector<MaybeBody> bodies(static_cast<std::size_t>(rows.shape(0)));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    try {
      if (rows.shape(1) == 0) refuse("expected at least one point, found none");
      bodies[i] = body_from_rows(rows.data(static_cast<py::ssize_t>(i), 0, 0), rows.shape(1), rows.shape(2));
    } catch (const py::value_error& fault) {
      bodies[i] = std::string(fault.what());
    }
  }
  return bodies;
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
