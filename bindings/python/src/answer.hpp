// SPDX-License-Identifier: GPL-3.0-or-later
// The answer about two bodies, polytopes or shapes, in the words of Python. Numbers are computed when they are asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bindings/python/src/bodies.hpp"
#include "fathom/answer.hpp"

namespace fathom::python {

/// Two bodies, and where they are.
struct Asked {
  Body a, b;
  std::optional<files::GivenPose> pose_a = std::nullopt, pose_b = std::nullopt;
};

struct PairAnswer {
  Body a, b;  ///< where they are
  Question question;
  Answer answer;
  std::vector<std::string> notes = {};  ///< on the poses
  std::string dents = {};               ///< what is said of meshes that are not convex; else empty

  /// Null if a body is a shape.
  [[nodiscard]] const Depth* depth() const { return std::get_if<Depth>(&answer.found); }
  [[nodiscard]] const SignedDepth& of_shapes() const { return std::get<SignedDepth>(answer.found); }
};

/// Of arguments that Python has checked. Throws py::value_error for a method that there is not.
Question question(const std::string& method, const std::optional<std::size_t>& optima, unsigned bits);

/// May be called without Python's lock.
PairAnswer answer_to(Asked asked, const Question& question, Monitor& monitor);

/// Answer, depth, width, check.
void bind_answers(py::module_& module);

/// What the predicates were asked, by name.
py::dict predicates(const PredicateCounts& counts);
/// A dict of kind, a, b.
py::object contact(const Contact* contact);
/// A pair of points, as floats or fractions; None if there is none.
py::object witness(const std::optional<Witness>& witness, bool exact);
/// Each component of n / |n|, correctly rounded.
py::array_t<double> unit(const Vector& n);

}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::python::PairAnswer> : fathom::python::MadeCaster<fathom::python::PairAnswer> {};
