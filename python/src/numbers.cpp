// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/src/numbers.hpp"

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

std::string shown(py::handle value) {
  constexpr std::size_t readable = 60;
  const auto text = py::repr(value).cast<std::string>();
  return text.size() <= readable ? text : text.substr(0, readable) + "...";
}

/// Imported once: a Fraction is made for every exact number.
const py::object& fraction_type() {
  static const py::object& type = *new py::object(py::module_::import("fractions").attr("Fraction"));
  return type;
}

}  // namespace

mpq_class number_from(py::handle number) {
  if (PyFloat_Check(number.ptr())) {
    const double value = PyFloat_AS_DOUBLE(number.ptr());
    if (!std::isfinite(value)) throw py::value_error("expected a finite number, found " + shown(number));
    return exact_value(value);
  }
  if (PyBool_Check(number.ptr())) throw py::type_error("expected a number, found " + shown(number));
  if (PyLong_Check(number.ptr())) return integer_from(number);
  if (PyUnicode_Check(number.ptr())) {
    ParsedNumber parsed = parse_number(number.cast<std::string>(), Decimals::exact);
    if (!parsed.value) throw py::value_error(parsed.error);
    return *std::move(parsed.value);
  }
  if (py::hasattr(number, "as_integer_ratio")) {
    const py::tuple ratio = number.attr("as_integer_ratio")();
    mpq_class value(integer_from(ratio[0]), integer_from(ratio[1]));
    value.canonicalize();
    return value;
  }
  if (py::hasattr(number, "numerator") && py::hasattr(number, "denominator")) {  // numpy's integers, numbers.Rational
    mpq_class value(integer_from(py::int_(number.attr("numerator"))), integer_from(py::int_(number.attr("denominator"))));
    value.canonicalize();
    return value;
  }
  throw py::type_error("expected a number (float, int, Fraction, Decimal or text), found " + shown(number));
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
