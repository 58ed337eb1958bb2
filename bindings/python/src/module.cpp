// SPDX-License-Identifier: GPL-3.0-or-later
// fathom._fathom: what bindings/python/fathom is made of. Users import fathom, whose docstrings say what everything means.
#include <pybind11/pybind11.h>

#include "bindings/python/src/answers.hpp"
#include "bindings/python/src/bodies.hpp"
#include "fathom/files.hpp"

PYBIND11_MODULE(_fathom, module) {
  namespace python = fathom::python;
  pybind11::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const fathom::InputError& fault) {
      PyErr_SetString(PyExc_ValueError, fault.what());
    } catch (const pybind11::cast_error& fault) {  // an argument is of another type
      PyErr_SetString(PyExc_TypeError, fault.what());
    }
  });
  module.attr("version") = FATHOM_VERSION;
  python::bind_bodies(module);
  python::bind_answers(module);
  python::bind_batches(module);
  python::bind_questions(module);
  python::bind_files(module);
  python::bind_unions(module);
}
