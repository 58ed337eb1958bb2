// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies from Python: arrays, lists, meshes, shapes, each perhaps with a pose.
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

/// Loads an object of Python that has its value. Of one that `__new__` made alone pybind11 would
/// read memory that nobody wrote.
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

inline constexpr const char* union_depth_takes = "union_depth takes those";

/// Takes a Body; an array or a sequence of points; or anything that has one in `vertices`. Arrays
/// of floats and sequences of numbers that are binary64 stay in binary64. `faces` beside `vertices`
/// are kept. The pose is None, a Pose, a text, or 3 or 4 rows of 4 numbers. Throws py::value_error
/// with a sentence that begins with `name`, and py::type_error; a union of pieces is refused for
/// the reason `no_union`. What there is to say of the pose goes to `notes`.
Body body_from(py::handle body, py::handle pose, const char* name, std::vector<std::string>* notes = nullptr,
               const char* no_union = union_depth_takes);

/// Returns the body, of any kind, moved by the pose. Throws and takes notes as body_from does.
Body posed(Body body, py::handle pose, const char* name, std::vector<std::string>* notes = nullptr);

/// Returns the same body. Throws py::value_error, which says why, if it is a union of pieces.
const Body& convex(const Body& body, const char* no_union = union_depth_takes);

/// Returns the pose that the object stands for; nullopt for None. Throws as body_from does.
std::optional<files::GivenPose> pose_from(py::handle pose, const char* name);

/// Returns the body moved by a pose that was read. May be called without Python's lock.
Body posed(Body body, const std::optional<files::GivenPose>& pose, const char* name, std::vector<std::string>* notes);

/// How the mesh differs from its hull; nullopt if it has no faces, or that was not tried. Found
/// once for a Body of Python, whoever asks. May be called without Python's lock.
std::optional<polytope::MeshConvexity> hull_fact(const Body& body);

/// Returns the points of a polytope. Throws py::value_error for any other body.
const GivenPoints& points_of(const Body& body, const char* name);

/// Returns how decimals are read, by the word "binary64" or "exact".
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

/// A union that is there; or one of convex pieces, of one or as many as there are, each as
/// body_from takes it: polytopes. A warning of pieces that are not convex says "piece 3 of A" where
/// `called` is "A", an error "a: piece 3" where `name` is "a".
Body union_from(py::handle from, const std::string& called, const std::string& name);

/// Warns if the body is a mesh that is not convex, or is open, or a union of such pieces.
void warn_of_dents(const Body& body, const std::string& called);

/// Body, Pose, read_mesh, read_pieces, union, solid; sphere and its like.
void bind_bodies(py::module_& module);

}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::Body> : fathom::python::MadeCaster<fathom::Body> {};
template <>
struct pybind11::detail::type_caster<fathom::files::GivenPose> : fathom::python::MadeCaster<fathom::files::GivenPose> {
};
