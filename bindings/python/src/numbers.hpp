// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers from Python and back; the points and faces of a convex body, from an array, a
// sequence of points, or an object with `vertices`.
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

/// The exact value of a float, an int, a Fraction, a Decimal, anything with as_integer_ratio; or of
/// a text as parse_number reads it, whose decimals stand for themselves, as those of a Decimal do.
/// Throws py::value_error with what was found, and py::type_error for what is no number.
mpq_class number_from(py::handle number);

/// The float that Python makes of a number, which may be NaN. Throws as number_from does, with
/// `name` before what was expected.
double float_from(py::handle number, const std::string& name);

/// The text in UTF-8. Throws py::value_error if it holds half a character, as "\ud800".
std::string text_from(py::handle text);

[[noreturn]] inline void refuse(const std::string& sentence) { throw py::value_error(sentence); }

/// What messages show of a value: ASCII, and not too long.
std::string shown(py::handle value);

/// Three numbers.
Point point_from(py::handle point);

/// A fractions.Fraction, and an int.
py::object fraction(const mpq_class& value);
py::object integer(const mpz_class& value);

py::tuple fractions(const Point& point);
py::tuple integers(const Vector& vector);

/// An array of three.
py::array_t<double> array(const std::array<double, 3>& values);
/// Each coordinate correctly rounded.
py::array_t<double> array(const Point& point);

// ---- points and faces ----

/// The points, in binary64 if all of them are. Throws py::value_error, which names the first bad
/// point, and py::type_error.
GivenPoints given_points(py::handle from);

/// Points, or what is wrong with them.
using MaybePoints = std::variant<GivenPoints, std::string>;

/// Returns the points of each body of an array of shape (n, m, 3), whose elements are binary64
/// numbers: no object is made in between. Returns nullopt for anything else.
std::optional<std::vector<MaybePoints>> stacked_points(py::handle from);

/// Returns the points, in binary64 if all of them are.
GivenPoints given_form(std::vector<Point> points);

/// The faces of an object that has some beside its `vertices`, so many points; else null. Throws
/// py::value_error.
std::shared_ptr<const MeshFaces> given_faces(py::handle from, std::size_t points);

/// Whether it is one convex body rather than a list of some: a Body, an object with `vertices`, or
/// a sequence of points, the first of which begins with a number.
bool is_one_body(py::handle from);

}  // namespace fathom::python
