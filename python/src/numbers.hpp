// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers from Python and back.
#pragma once

#include <gmpxx.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>

#include "fathom/numbers.hpp"
#include "fathom/point.hpp"

namespace fathom::python {

namespace py = pybind11;

/// The exact value of a float, an int, a Fraction, a Decimal, anything with as_integer_ratio; or of a text as parse_number reads it, whose
/// decimals stand for themselves. Throws py::value_error with what was found, and py::type_error for what is no number.
mpq_class number_from(py::handle number);

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

}  // namespace fathom::python
