// SPDX-License-Identifier: GPL-3.0-or-later
// The points and faces of a convex body, from an array, a sequence of points, or an object with `vertices`.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "fathom/body.hpp"

namespace fathom::python {

namespace py = pybind11;

/// The points, in binary64 if all of them are. Throws py::value_error, which names the first bad point, and py::type_error.
GivenPoints given_points(py::handle from);

/// The same of points that are there.
GivenPoints given_form(std::vector<Point> points);

/// The faces of an object that has some beside its `vertices`, so many points; else null. Throws py::value_error.
std::shared_ptr<const MeshFaces> given_faces(py::handle from, std::size_t points);

/// Whether it is one convex body rather than a list of some: a Body, an object with `vertices`, or a sequence of points, the first of which
/// begins with a number.
bool is_one_body(py::handle from);

}  // namespace fathom::python
