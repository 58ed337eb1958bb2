// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/src/numbers.hpp"

#include <cmath>
#include <string>

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

/// Imported once: a Fraction is made for every exact number.
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

/// The quotient of two ints, which `number` says it is.
mpq_class quotient(py::handle number, py::handle numerator, py::handle denominator) {
  if (!PyLong_Check(numerator.ptr()) || !PyLong_Check(denominator.ptr())) refuse_what_is_no_number(number);
  mpq_class value(integer_from(numerator), integer_from(denominator));
  if (value.get_den() == 0) throw py::value_error("expected a number, found " + shown(number) + ": the denominator is zero");
  value.canonicalize();
  return value;
}

py::object integer_ratio(py::handle number) try { return number.attr("as_integer_ratio")(); } catch (py::error_already_set& raised) {
  if (!raised.matches(PyExc_OverflowError) && !raised.matches(PyExc_ValueError)) throw;  // they stand for infinity and NaN
  throw py::value_error("expected a finite number, found " + shown(number));
}

/// An attribute that is an integer of some type, as an int.
py::object int_attribute(py::handle number, const char* name) {
  auto found = py::reinterpret_steal<py::object>(PyNumber_Index(number.attr(name).ptr()));
  if (found) return found;
  PyErr_Clear();
  refuse_what_is_no_number(number);
}

}  // namespace

std::string shown(py::handle value) {
  constexpr std::size_t readable = 60;
  const auto ascii = py::reinterpret_steal<py::object>(PyObject_ASCII(value.ptr()));
  if (!ascii) {  // its own __repr__ raised, or it is an int of too many digits
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
  if (py::isinstance(number, decimal_type())) {  // its exponent may be so large that no memory holds it as an int
    if (!number.attr("is_finite")().cast<bool>()) throw py::value_error("expected a finite number, found " + shown(number));
    return number_from_text(py::str(number));
  }
  if (py::hasattr(number, "as_integer_ratio")) {
    const py::object ratio = integer_ratio(number);
    if (!PyTuple_Check(ratio.ptr()) || PyTuple_GET_SIZE(ratio.ptr()) != 2) refuse_what_is_no_number(number);
    return quotient(number, PyTuple_GET_ITEM(ratio.ptr(), 0), PyTuple_GET_ITEM(ratio.ptr(), 1));
  }
  if (py::hasattr(number, "numerator") && py::hasattr(number, "denominator"))  // numpy's integers, numbers.Rational
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

Point point_from(py::handle point) {
  if (!PySequence_Check(point.ptr()) || PyUnicode_Check(point.ptr()) || py::len(point) != 3)
    throw py::value_error("expected three numbers, found " + shown(point));
  const auto items = py::reinterpret_borrow<py::sequence>(point);
  return {number_from(items[0]), number_from(items[1]), number_from(items[2])};
}

py::object integer(const mpz_class& value) {
  if (value.fits_slong_p()) return py::int_(value.get_si());
  return py::reinterpret_steal<py::object>(PyLong_FromString(value.get_str(16).c_str(), nullptr, 16));
}

py::object fraction(const mpq_class& value) { return fraction_type()(integer(value.get_num()), integer(value.get_den())); }

py::tuple fractions(const Point& p) { return py::make_tuple(fraction(p.x), fraction(p.y), fraction(p.z)); }

py::tuple integers(const Vector& v) { return py::make_tuple(integer(v.x), integer(v.y), integer(v.z)); }

py::array_t<double> array(const std::array<double, 3>& values) { return py::array_t<double>(3, values.data()); }

py::array_t<double> array(const Point& p) { return array(std::array{round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)}); }

}  // namespace fathom::python
