// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that are unions of convex pieces, and their depth, in the words of Python.
#pragma once

#include <pybind11/pybind11.h>

namespace fathom::python {

/// UnionAnswer, union, union_depth, read_pieces.
void bind_unions(pybind11::module_& module);

}  // namespace fathom::python
