// SPDX-License-Identifier: GPL-3.0-or-later
// fathom._fathom, the C++ part of the package in bindings/python/fathom. Users import fathom, whose
// docstrings describe everything. This file defines files of cases, golden data and families, and
// the module itself.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/python/src/answers.hpp"
#include "bindings/python/src/bodies.hpp"
#include "fathom/files.hpp"
#include "verify/families/families.hpp"
#include "verify/golden/io/files.hpp"

namespace fathom::python {
namespace {

/// Returns a case as a tuple of its id and bodies.
py::tuple in_python(Case&& found) { return py::make_tuple(found.id, std::move(found.a), std::move(found.b)); }

/// Iterates over a file of cases. Raises the error of a bad case in its turn, and can continue with
/// the next one.
class Cases {
 public:
  explicit Cases(const std::string& path) : stream_(CaseStream::open(path, std::cin)) {}

  py::tuple next() {
    std::optional<CaseItem> item = stream_.next();
    if (!item) throw py::stop_iteration();
    if (!item->ok()) throw py::value_error(item->error().what());
    return in_python(std::get<Case>(std::move(item->outcome)));
  }

 private:
  CaseStream stream_;
};

}  // namespace
}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::python::Cases> : fathom::python::MadeCaster<fathom::python::Cases> {};
template <>
struct pybind11::detail::type_caster<fathom::golden::ZstdReader>
    : fathom::python::MadeCaster<fathom::golden::ZstdReader> {};

namespace fathom::python {
namespace {

py::tuple parsed_case(const std::string& text, const std::string& name, std::size_t line) {
  CaseItem item = parse_case(text, name, line);
  if (!item.ok()) throw py::value_error(item.error().what());
  return in_python(std::get<Case>(std::move(item.outcome)));
}

py::str next_line(golden::ZstdReader& reader) {
  const std::optional<std::string_view> line = reader.line();
  if (!line) throw py::stop_iteration();
  return py::str(line->data(), line->size());
}

// ---- families ----

/// Returns the case that `fathom cases` prints; None if there is no such family.
py::object family_case(const std::string& name, std::uint64_t seed, const std::optional<unsigned>& size) {
  const families::Family* const family = families::find_family(name);
  if (family == nullptr) return py::none();
  return py::object(in_python(family->make(seed, size.value_or(family->usual_size))));
}

/// Defines Cases, ZstdLines, parse_case, and functions on families.
void bind_files(py::module_& module) {
  using py::arg;
  module.def("parse_case", parsed_case, arg("text"), arg("name"), arg("line"));
  module.def("family_case", family_case, arg("name"), arg("seed"), arg("size"));
  module.def("family_names", families::family_names);
  py::class_<Cases>(module, "Cases")
      .def(py::init<const std::string&>(), arg("path"))
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &Cases::next);
  py::class_<golden::ZstdReader>(module, "ZstdLines")
      .def(py::init([](const std::string& path) {
             try {
               return std::make_unique<golden::ZstdReader>(path);
             } catch (const golden::FileError& fault) {
               throw py::value_error(fault.what());
             }
           }),
           arg("path"))
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", [](golden::ZstdReader& reader) {
        try {
          return next_line(reader);
        } catch (const golden::FileError& fault) {
          throw py::value_error(fault.what());
        }
      });
}

}  // namespace
}  // namespace fathom::python

PYBIND11_MODULE(_fathom, module) {
  namespace python = fathom::python;
  pybind11::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const fathom::InputError& fault) {
      PyErr_SetString(PyExc_ValueError, fault.what());
    } catch (const pybind11::cast_error& fault) {  // an argument has another type
      PyErr_SetString(PyExc_TypeError, fault.what());
    }
  });
  module.attr("version") = FATHOM_VERSION;
  python::bind_bodies(module);
  python::bind_manifolds(module);
  python::bind_answers(module);
  python::bind_batches(module);
  python::bind_questions(module);
  python::bind_files(module);
}
