// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of exact numbers from Python and back; and of the points and faces of a convex body,
// from an array, a sequence of points, or an object with `vertices`.
#pragma once

#include <gmpxx.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/numbers.hpp"
#include "fathom/point.hpp"

namespace fathom::python {

namespace py = pybind11;

/// Returns the exact value of a float, an int, a Fraction, a Decimal, or an object with
/// as_integer_ratio; or of a text as parse_number reads it. Decimals are exact, in a text as in a
/// Decimal. Throws py::value_error with the value found, and py::type_error for an object that is
/// no number.
mpq_class number_from(py::handle number);

/// Returns the float that Python makes of a number, which may be NaN. Throws as number_from does;
/// `name` begins the message.
double float_from(py::handle number, const std::string& name);

/// Returns the text in UTF-8. Throws py::value_error if it holds half a surrogate pair, as
/// "\ud800".
std::string text_from(py::handle text);

[[noreturn]] inline void refuse(const std::string& sentence) { throw py::value_error(sentence); }

/// Returns how messages show a value: in ASCII, shortened if it is long.
std::string shown(py::handle value);

/// Returns the point of three numbers; with dimension 2 of two, and then z is 0.
Point point_from(py::handle point, unsigned dimension = 3);

/// Returns a fractions.Fraction, or an int.
py::object fraction(const mpq_class& value);
py::object integer(const mpz_class& value);

// With dimension 2, of the plane, these leave out z, which is 0.

py::tuple fractions(const Point& point, unsigned dimension = 3);
py::tuple integers(const Vector& vector, unsigned dimension = 3);

/// Returns an array of three floats.
py::array_t<double> array(const std::array<double, 3>& values, unsigned dimension = 3);
/// Returns an array of the coordinates, each correctly rounded.
py::array_t<double> array(const Point& point, unsigned dimension = 3);

// ---- points and faces ----

/// Returns the body of these points, in binary64 if all of them are; one of the plane if the first
/// has two coordinates. Throws py::value_error, which names the first bad point, and
/// py::type_error.
Body given_points(py::handle from);

/// The body of some points, or the sentence on what is wrong with them.
using MaybeBody = std::variant<Body, std::string>;

/// Returns each body of an array of shape (n, m, 3), or (n, m, 2) in the plane, whose elements are
/// binary64 numbers, without making objects of Python for them. Returns nullopt for anything else.
std::optional<std::vector<MaybeBody>> stacked_points(py::handle from);

/// Returns the points, in binary64 if all of them are.
GivenPoints given_form(std::vector<Point> points);

/// Returns the faces of a mesh with `points` vertices, if the object has `faces` beside its
/// `vertices`; else null. Throws py::value_error.
std::shared_ptr<const MeshFaces> given_faces(py::handle from, std::size_t points);

/// Returns whether the object is one convex body rather than a list of bodies: a Body, an object
/// with `vertices`, or a sequence whose first item is a point.
bool is_one_body(py::handle from);

}  // namespace fathom::python
