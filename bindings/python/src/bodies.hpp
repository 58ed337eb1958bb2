// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of bodies from Python: arrays, lists, meshes, shapes, each perhaps with a pose.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bindings/python/src/numbers.hpp"
#include "fathom/body.hpp"
#include "reference/files/pose.hpp"
#include "reference/polytope/convexity.hpp"

namespace fathom::python {

/// Loads an object of Python that was initialised. Of an object made by `__new__` alone, pybind11
/// would read uninitialised memory.
template <class Value>
struct MadeCaster : py::detail::type_caster_base<Value> {
  bool load(py::handle from, bool convert) {
    if (py::isinstance<Value>(from)) {
      auto* const object = reinterpret_cast<py::detail::instance*>(from.ptr());
      if (!object->get_value_and_holder(py::detail::get_type_info(typeid(Value))).value_ptr()) return false;
    }
    return py::detail::type_caster_base<Value>::load(from, convert);
  }
};

/// What errors about unions of pieces say unless a question says something else.
inline constexpr const char* union_depth_takes = "union_depth takes those";

/// Throws py::value_error unless both are of the plane, or both of space.
void require_same_dimension(const Body& a, const Body& b);

/// Returns the body for a Body; an array or a sequence of points; or an object with such
/// `vertices`, whose `faces`, if any, are kept. Arrays of floats and sequences of binary64 numbers
/// are stored as binary64. The pose is None, a Pose, a text, 3 or 4 rows of 4 numbers, or in the
/// plane 2 or 3 rows of 3. Appends warnings about the pose to `notes`. Throws py::type_error, and
/// py::value_error with a sentence that begins with `name`; refuses unions of pieces for the reason
/// `no_union`.
Body body_from(py::handle body, py::handle pose, const char* name, std::vector<std::string>* notes = nullptr,
               const char* no_union = union_depth_takes);

/// Returns the body, of any kind, moved by the pose. Throws and appends notes as body_from does.
Body posed(Body body, py::handle pose, const char* name, std::vector<std::string>* notes = nullptr);

/// Returns the same body. Throws py::value_error, which says why, if it is a union of pieces.
const Body& convex(const Body& body, const char* no_union = union_depth_takes);

/// Returns the pose of the object, for a body of this dimension: that of the plane takes rows of
/// three numbers too. nullopt for None. Throws as body_from does.
std::optional<files::GivenPose> pose_from(py::handle pose, const char* name, unsigned dimension = 3);

/// Returns the body moved by the pose. May be called without the GIL.
Body posed(Body body, const std::optional<files::GivenPose>& pose, const char* name, std::vector<std::string>* notes);

/// Returns how the mesh differs from its hull; nullopt if it has no faces, or the comparison was
/// not tried. It is computed once for all copies of a Body. May be called without the GIL.
std::optional<polytope::MeshConvexity> hull_fact(const Body& body);

/// Returns the points of a polytope. Throws py::value_error for any other body.
const GivenPoints& points_of(const Body& body, const char* name);

/// Returns the reading of decimals named "binary64" or "exact".
Decimals decimals_from(const std::string& decimals);

/// Returns the result of `work`; an error message begins with `name`.
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

/// Returns the object's union of pieces; or the union of one convex polytope or of a sequence of
/// them, each as body_from reads it. In messages `called` and `name` stand for the body: with "A" a
/// warning about a piece that is not convex says "piece 3 of A", with "a" an error says "a: piece
/// 3".
Body union_from(py::handle from, const std::string& called, const std::string& name);

/// Warns if the body is a mesh that is not convex, or is open, or a union of such pieces.
void warn_of_dents(const Body& body, const std::string& called);

/// Defines Body, Pose, read_mesh, read_pieces, union, solid; sphere and the other shapes, of space
/// and of the plane.
void bind_bodies(py::module_& module);

}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::Body> : fathom::python::MadeCaster<fathom::Body> {};
template <>
struct pybind11::detail::type_caster<fathom::files::GivenPose> : fathom::python::MadeCaster<fathom::files::GivenPose> {
};
