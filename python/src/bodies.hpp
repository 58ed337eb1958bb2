// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies from Python: arrays, lists, meshes, shapes, each perhaps with a pose.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/body.hpp"
#include "python/src/numbers.hpp"

namespace fathom::python {

/// Takes a Body; an array or a sequence of points; or anything that has one in `vertices`. Arrays of floats and sequences of numbers that
/// are binary64 stay in binary64. `faces` beside `vertices` are kept. The pose is None, a Pose, a text, or 3 or 4 rows of 4 numbers. Throws
/// py::value_error with a sentence that begins with `name`, and py::type_error; unions of pieces are refused. What there is to say of the
/// pose goes to `notes`.
Body body_from(py::handle body, py::handle pose, const char* name, std::vector<std::string>* notes = nullptr);

/// The same of a body that is there, of any kind.
Body posed(Body body, py::handle pose, const char* name, std::vector<std::string>* notes = nullptr);

/// Its points, if it is a polytope; throws py::value_error else.
const GivenPoints& points_of(const Body& body, const char* name);

/// Of "binary64" or "exact".
Decimals decimals_from(const std::string& decimals);

/// Returns what `work` does; each message about what is wrong begins with the name.
template <class Work>
auto named(const std::string& name, Work work) try {
  return work();
} catch (const py::value_error& fault) {
  throw py::value_error(name + ": " + fault.what());
} catch (const std::invalid_argument& fault) {
  throw py::value_error(name + ": " + fault.what());
} catch (const py::type_error& fault) {
  throw py::type_error(name + ": " + fault.what());
}

/// Body, Pose, the makers of shapes, read_mesh.
void bind_bodies(py::module_& module);

}  // namespace fathom::python
