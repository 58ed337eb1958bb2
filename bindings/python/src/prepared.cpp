// SPDX-License-Identifier: GPL-3.0-or-later
// Prepared polytopes in their poses.
#include "fathom/prepared.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>

#include "bindings/python/src/answers.hpp"
#include "bindings/python/src/bodies.hpp"
#include "fathom/overlap.hpp"

template <>
struct pybind11::detail::type_caster<fathom::Prepared> : fathom::python::MadeCaster<fathom::Prepared> {};

namespace fathom::python {
namespace {

/// An array of floats is taken as it is; of anything else the pose is made exact. The fourth row of
/// an array must be 0 0 0 1 for that.
std::optional<PoseBinary64> array_pose(const py::object& pose) {
  if (!py::isinstance<py::array_t<double>>(pose)) return std::nullopt;
  const auto array = pose.cast<py::array_t<double>>();
  const bool square = array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4;
  if (!square && (array.ndim() != 2 || array.shape(0) != 3 || array.shape(1) != 4)) return std::nullopt;
  const auto rows = array.unchecked<2>();
  if (square && (rows(3, 0) != 0 || rows(3, 1) != 0 || rows(3, 2) != 0 || rows(3, 3) != 1)) return std::nullopt;
  PoseBinary64 result;
  for (py::ssize_t i = 0; i < 3; ++i)
    for (py::ssize_t j = 0; j < 4; ++j) result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = rows(i, j);
  return result;
}

PlacedBody placed_from(const Prepared& prepared, const py::object& pose, const char* name) {
  PlacedBody placed{prepared};
  if (const std::optional<PoseBinary64> rows = array_pose(pose)) placed.pose = *rows;
  else if (const std::optional<files::GivenPose> given = pose_from(pose, name)) placed.pose = files::exact_pose(*given);
  return placed;
}

/// Calls ask(a, b, monitor, workspace) without Python's lock.
template <class Ask>
auto asked(const Prepared& a, const Prepared& b, const py::object& pose_a, const py::object& pose_b, Ask ask) {
  const PlacedBody first = placed_from(a, pose_a, "pose_a"), second = placed_from(b, pose_b, "pose_b");
  return watched([&](Monitor& monitor) {
    thread_local Workspace workspace;
    return ask(first, second, &monitor, &workspace);
  });
}

PairAnswer depth_of(const Prepared& a, const Prepared& b, const py::object& pose_a, const py::object& pose_b,
                    const py::object& start, const std::optional<std::size_t>& optima) {
  WarmStart warm;
  if (!start.is_none()) warm.differences = start.cast<decltype(warm.differences)>();
  Question asked_for = question("automatic", optima, SignedDepthOptions{}.bits);
  PairAnswer result =
      asked(a, b, pose_a, pose_b,
            [&](const PlacedBody& first, const PlacedBody& second, Monitor* monitor, Workspace* workspace) {
              Options options = asked_for.options;
              options.monitor = monitor;
              options.workspace = workspace;
              Depth depth = penetration_depth(first, second, start.is_none() ? nullptr : &warm, options);
              return PairAnswer{moved(first), moved(second), asked_for, Answer{std::move(depth)}};
            });
  if (!start.is_none()) start[py::slice(py::none(), py::none(), py::none())] = py::cast(warm.differences);
  return result;
}

std::string overlap_of_prepared(const Prepared& a, const Prepared& b, const py::object& pose_a,
                                const py::object& pose_b) {
  const auto ask = [](const PlacedBody& first, const PlacedBody& second, Monitor* monitor, Workspace* workspace) {
    return overlap(first, second, {.monitor = monitor, .workspace = workspace});
  };
  return std::string(name(*asked(a, b, pose_a, pose_b, ask).status));
}

bool closer_than_of_prepared(const Prepared& a, const Prepared& b, const py::object& distance, const py::object& pose_a,
                             const py::object& pose_b) {
  const mpq_class limit = number_from(distance);
  const auto ask = [&](const PlacedBody& first, const PlacedBody& second, Monitor* monitor, Workspace* workspace) {
    return closer_than(first, second, limit, {.monitor = monitor, .workspace = workspace});
  };
  return *asked(a, b, pose_a, pose_b, ask).closer;
}

}  // namespace

void bind_prepared(py::module_& module) {
  using py::arg;
  py::class_<Prepared>(module, "Prepared")
      .def(py::init([](const py::object& body) { return Prepared(body_from(body, py::none(), "body")); }), arg("body"))
      .def_property_readonly("body", &Prepared::body)
      .def_property_readonly("extreme_points",
                             [](const Prepared& prepared) { return py::tuple(py::cast(prepared.extreme_points())); })
      .def("depth", depth_of, arg("other"), arg("pose_a"), arg("pose_b"), arg("start"), arg("optima"))
      .def("overlap", overlap_of_prepared, arg("other"), arg("pose_a"), arg("pose_b"))
      .def("closer_than", closer_than_of_prepared, arg("other"), arg("distance"), arg("pose_a"), arg("pose_b"));
}

}  // namespace fathom::python
