// SPDX-License-Identifier: GPL-3.0-or-later
// Where bodies meet, as objects of Python: contact manifolds, one-sided derivatives of the signed
// depth, and the first contact of bodies that move.
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/python/src/answers.hpp"
#include "bindings/python/src/bodies.hpp"
#include "bindings/python/src/numbers.hpp"
#include "fathom/impact.hpp"
#include "fathom/patch.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/solve/require_space.hpp"

namespace fathom::python {
namespace {

using py::literals::operator""_a;

/// Returns the point in the form of the answer's exact witness.
py::object exact_place(const RoundedPoint& p, bool of_shapes) {
  return of_shapes ? rounded_point(p, true) : py::object(fractions(p.core));
}

/// Returns a k x 3 array of the corners on one body.
py::array_t<double> corner_array(const Patch& patch, RoundedPoint (Patch::*of)(std::size_t) const) {
  py::array_t<double> result({static_cast<py::ssize_t>(patch.corners.size()), py::ssize_t{3}});
  auto view = result.mutable_unchecked<2>();
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const std::array<double, 3> nearest = rounded::nearest_binary64((patch.*of)(k));
    for (std::size_t i = 0; i < 3; ++i) view(static_cast<py::ssize_t>(k), static_cast<py::ssize_t>(i)) = nearest[i];
  }
  return result;
}

/// Returns a tuple of indices; None for a half-space, which has none.
py::object on_face(const std::vector<std::uint32_t>& ids) {
  return ids.empty() ? py::object(py::none()) : py::object(py::tuple(py::cast(ids)));
}

py::dict patch_in_python(const Patch& patch, bool of_shapes, bool of_unions) {
  py::list corners;
  for (std::size_t k = 0; k < patch.corners.size(); ++k)
    corners.append(py::dict("a"_a = exact_place(patch.a(k), of_shapes), "b"_a = exact_place(patch.b(k), of_shapes),
                            "on_a"_a = on_face(patch.corners[k].on_a), "on_b"_a = on_face(patch.corners[k].on_b)));
  const RoundedWitness centroid = patch.centroid();
  const mpq_class squared = patch.squared();
  return py::dict("rank"_a = patch.rank(), "direction"_a = unit(patch.direction),
                  "normal"_a = integers(patch.direction), "corners"_a = corners,
                  "a_f64"_a = corner_array(patch, &Patch::a), "b_f64"_a = corner_array(patch, &Patch::b),
                  "centroid"_a = py::make_tuple(exact_place(centroid.a, of_shapes), exact_place(centroid.b, of_shapes)),
                  "size"_a = root_binary64(squared), "size_squared"_a = fraction(squared), "optimum"_a = patch.way,
                  "pieces"_a = of_unions ? py::object(py::make_tuple(patch.pieces.first, patch.pieces.second))
                                         : py::object(py::none()),
                  "mesh_a"_a = features(patch.mesh_a), "mesh_b"_a = features(patch.mesh_b));
}

py::list patches_in_python(const ToldManifold& told) {
  py::list result;
  const ContactGeometry& geometry = told.manifold.geometry;
  for (const Patch& patch : geometry.patches) result.append(patch_in_python(patch, told.of_shapes, geometry.of_unions));
  return result;
}

py::object smooth_in_python(const ToldManifold& told) {
  if (!told.manifold.geometry.tells_smoothness()) return py::none();
  return py::bool_(told.manifold.geometry.smooth());
}

py::object kinks_in_python(const ToldManifold& told) {
  if (!told.manifold.geometry.tells_smoothness()) return py::none();
  std::vector<std::string> words;
  for (const Kink kink : told.manifold.geometry.kinks) words.emplace_back(name(kink));
  return py::tuple(py::cast(words));
}

py::object gradient_in_python(const ToldManifold& told) {
  const std::optional<Gradient> found = told.manifold.geometry.gradient();
  if (!found) return py::none();
  return py::dict("v"_a = array(rounded::nearest_binary64(found->by_translation())),
                  "w"_a = array(rounded::nearest_binary64(found->by_rotation())), "normal"_a = integers(found->normal),
                  "point"_a = fractions(found->point));
}

py::object vertex_weights_in_python(const ToldManifold& told) {
  const std::optional<VertexWeights>& found = told.manifold.weights;
  if (!found) return py::none();
  return py::dict("a"_a = weights(found->a), "b"_a = weights(found->b));
}

py::object cone_in_python(const ToldManifold& told) {
  const std::optional<OptimalCone>& cone = told.manifold.geometry.cone;
  if (!cone) return py::none();
  py::list rays;
  for (const Vector& ray : cone->rays) rays.append(integers(ray));
  return py::dict("lineality"_a = std::string(output::lineality_name(*cone)),
                  "axis"_a = cone->axis == Vector{0, 0, 0} ? py::object(py::none()) : py::object(integers(cone->axis)),
                  "rays"_a = py::tuple(rays));
}

py::str word(LeftOut reason) { return std::string(name(reason)); }

py::object left_out_in_python(const ToldManifold& told) {
  const std::optional<LeftOut> reason = told.manifold.geometry.no_patches;
  return reason ? py::object(word(*reason)) : py::object(py::none());
}

py::dict derivative_in_python(const ToldManifold& told, const py::object& v, const py::object& w, const py::object& v_b,
                              const py::object& w_b) {
  const auto velocity = [](const py::object& from, const char* what) {
    return named(what, [&] { return point_from(from); });
  };
  const Twist of_a{velocity(v, "v"), velocity(w, "w")}, of_b{velocity(v_b, "v_b"), velocity(w_b, "w_b")};
  const std::variant<DirectionalDerivative, LeftOut> found = [&] {
    const py::gil_scoped_release unlocked;
    return directional_derivative(told.manifold.geometry, of_a, of_b);
  }();
  if (const LeftOut* const reason = std::get_if<LeftOut>(&found)) return py::dict("left_out"_a = word(*reason));
  const DirectionalDerivative& rate = std::get<DirectionalDerivative>(found);
  const Surd value = rate.value();
  // Adding 0.0 turns -0.0 into 0.0.
  return py::dict("value"_a = round_binary64(value) + 0.0, "low"_a = round_binary64(value, Rounding::rd) + 0.0,
                  "high"_a = round_binary64(value, Rounding::ru) + 0.0, "sign"_a = rate.sign(),
                  "root"_a = fraction(rate.root()), "direction"_a = unit(rate.direction),
                  "normal"_a = integers(rate.direction), "patch"_a = rate.patch, "corner"_a = rate.corner);
}

// ---- when bodies that move meet first ----

/// Returns the motion between two poses, which may be None; at rest if there are none.
RigidMotion motion_from(const py::object& poses, const char* name) {
  if (poses.is_none()) return {};
  if (!py::isinstance<py::sequence>(poses) || py::isinstance<py::str>(poses) || py::len(poses) != 2)
    throw py::value_error(std::string(name) + ": expected two poses, where the body is at t = 0 and at t = 1");
  const py::sequence ends = poses.cast<py::sequence>();
  std::string fault;
  RigidMotion motion =
      files::motion_between(pose_from(py::object(ends[0]), name), pose_from(py::object(ends[1]), name), fault);
  return fault.empty() ? motion : throw py::value_error(std::string(name) + ": " + fault);
}

py::list pieces_of(const Impact& impact) {
  py::list pieces;
  for (const ImpactPiece& piece : impact.pieces) {
    py::dict entry("until"_a = fraction(piece.until));
    if (piece.near) {
      entry["gap"] = fraction(piece.near->gap);
    } else {
      const auto& [kind, first, second] = *piece.plane;
      entry["plane"] = std::string(name(kind));
      entry["directions"] = kind == MovingPlane::Kind::of_edges ? py::make_tuple(integers(first), integers(second))
                                                                : py::make_tuple(integers(first));
    }
    pieces.append(entry);
  }
  return pieces;
}

py::dict impact(const py::object& a, const py::object& b, const py::object& motion_a, const py::object& motion_b,
                unsigned bits, const py::object& delta, bool certificate) {
  const Body body_a = body_from(a, py::none(), "a"), body_b = body_from(b, py::none(), "b");
  solve::require_space(body_a, body_b, "impact");
  warn_of_dents(body_a, "A");
  warn_of_dents(body_b, "B");
  const RigidMotion of_a = motion_from(motion_a, "motion_a"), of_b = motion_from(motion_b, "motion_b");
  const std::vector<Point>&p = points_of(body_a, "a").exact(), &q = points_of(body_b, "b").exact();
  ImpactOptions options;
  options.bits = bits;
  if (!delta.is_none()) options.delta = number_from(delta);
  std::string text;
  const Impact found = watched([&](Monitor& monitor) {
    options.monitor = &monitor;
    Impact impact = first_contact(p, of_a, q, of_b, options);
    if (certificate) text = certificate_text(p, of_a, q, of_b, impact, {}, &monitor);
    return impact;
  });
  py::dict result("status"_a = std::string(name(found.status)), "pieces"_a = pieces_of(found));
  if (certificate) result["certificate"] = text;
  if (found.beginning)
    result["beginning"] =
        py::make_tuple(std::string(name(found.beginning->status())), fraction(found.beginning->squared()));
  if (!found.contact) return result;
  const FirstContact& at = *found.contact;
  result["times"] = py::make_tuple(fraction(at.t0), fraction(at.t1));
  result["points"] = py::make_tuple(fractions(at.point), fractions(at.in_a), fractions(at.in_b));
  result["normal"] = integers(at.normal);
  result["contact"] = contact(&at.contact);
  result["weights"] = py::make_tuple(weights(at.a), weights(at.b));
  return result;
}

}  // namespace

std::shared_ptr<ToldManifold> manifold_told(PairAnswer& asked) {
  if (!asked.answer.complete()) return nullptr;
  if (!asked.manifold) {
    output::Manifold found = watched(
        [&](Monitor& monitor) { return output::manifold_of(asked.a, asked.b, asked.answer, std::nullopt, &monitor); });
    asked.manifold = std::make_shared<ToldManifold>(std::move(found), asked.of_shapes() != nullptr);
  }
  return asked.manifold;
}

void bind_manifolds(py::module_& module) {
  using py::arg;
  py::class_<ToldManifold, std::shared_ptr<ToldManifold>>(module, "Manifold")
      .def_property_readonly("patches", patches_in_python)
      .def_property_readonly("smooth", smooth_in_python)
      .def_property_readonly("kinks", kinks_in_python)
      .def_property_readonly("gradient", gradient_in_python)
      .def_property_readonly("vertex_weights", vertex_weights_in_python)
      .def_property_readonly("optimal_cone", cone_in_python)
      .def_property_readonly("left_out", left_out_in_python)
      .def("derivative", derivative_in_python, arg("v"), arg("w"), arg("v_b"), arg("w_b"));
  module.def("impact", impact, arg("a"), arg("b"), arg("motion_a"), arg("motion_b"), arg("bits"), arg("delta"),
             arg("certificate"));
}

}  // namespace fathom::python
