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
#include "reference/solve/depth.hpp"

namespace fathom::python {
namespace {

using py::literals::operator""_a;

/// Returns the point in the form of the answer's exact witness.
py::object exact_place(const RoundedPoint& p, bool of_shapes, unsigned dimension) {
  return of_shapes ? rounded_point(p, true, dimension) : py::object(fractions(p.core, dimension));
}

/// Returns a k x 3 array of the corners on one body, in the plane k x 2.
py::array_t<double> corner_array(const Patch& patch, RoundedPoint (Patch::*of)(std::size_t) const, unsigned dimension) {
  py::array_t<double> result({static_cast<py::ssize_t>(patch.corners.size()), static_cast<py::ssize_t>(dimension)});
  auto view = result.mutable_unchecked<2>();
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const std::array<double, 3> nearest = rounded::nearest_binary64((patch.*of)(k));
    for (std::size_t i = 0; i < dimension; ++i)
      view(static_cast<py::ssize_t>(k), static_cast<py::ssize_t>(i)) = nearest[i];
  }
  return result;
}

/// Returns a tuple of indices; None for a half-space, which has none.
py::object on_face(const std::vector<std::uint32_t>& ids) {
  return ids.empty() ? py::object(py::none()) : py::object(py::tuple(py::cast(ids)));
}

py::dict patch_in_python(const Patch& patch, const ToldManifold& told) {
  const unsigned dimension = told.manifold.geometry.dimension;
  const auto place = [&](const RoundedPoint& p) { return exact_place(p, told.of_shapes, dimension); };
  py::list corners;
  for (std::size_t k = 0; k < patch.corners.size(); ++k)
    corners.append(py::dict("a"_a = place(patch.a(k)), "b"_a = place(patch.b(k)),
                            "on_a"_a = on_face(patch.corners[k].on_a), "on_b"_a = on_face(patch.corners[k].on_b)));
  const RoundedWitness centroid = patch.centroid();
  const mpq_class squared = patch.squared();
  return py::dict("rank"_a = patch.rank(), "direction"_a = unit(patch.direction, dimension),
                  "normal"_a = integers(patch.direction, dimension), "corners"_a = corners,
                  "a_f64"_a = corner_array(patch, &Patch::a, dimension),
                  "b_f64"_a = corner_array(patch, &Patch::b, dimension),
                  "centroid"_a = py::make_tuple(place(centroid.a), place(centroid.b)),
                  "size"_a = root_binary64(squared), "size_squared"_a = fraction(squared), "optimum"_a = patch.way,
                  "pieces"_a = told.manifold.geometry.of_unions
                                   ? py::object(py::make_tuple(patch.pieces.first, patch.pieces.second))
                                   : py::object(py::none()),
                  "mesh_a"_a = features(patch.mesh_a), "mesh_b"_a = features(patch.mesh_b));
}

py::list patches_in_python(const ToldManifold& told) {
  py::list result;
  for (const Patch& patch : told.manifold.geometry.patches) result.append(patch_in_python(patch, told));
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
  const unsigned dimension = told.manifold.geometry.dimension;
  const std::array<double, 3> by_w = rounded::nearest_binary64(found->by_rotation());
  return py::dict("v"_a = array(rounded::nearest_binary64(found->by_translation()), dimension),
                  "w"_a = dimension == 2 ? py::object(py::float_(by_w[2])) : py::object(array(by_w)),
                  "normal"_a = integers(found->normal, dimension), "point"_a = fractions(found->point, dimension));
}

py::object vertex_weights_in_python(const ToldManifold& told) {
  const std::optional<VertexWeights>& found = told.manifold.weights;
  if (!found) return py::none();
  return py::dict("a"_a = weights(found->a), "b"_a = weights(found->b));
}

py::object cone_in_python(const ToldManifold& told) {
  const std::optional<OptimalCone>& cone = told.manifold.geometry.cone;
  if (!cone) return py::none();
  const unsigned dimension = told.manifold.geometry.dimension;
  py::list rays;
  for (const Vector& ray : cone->rays) rays.append(integers(ray, dimension));
  return py::dict(
      "lineality"_a = std::string(output::lineality_name(*cone)),
      "axis"_a = cone->axis == Vector{0, 0, 0} ? py::object(py::none()) : py::object(integers(cone->axis, dimension)),
      "rays"_a = py::tuple(rays));
}

py::str word(LeftOut reason) { return std::string(name(reason)); }

py::object left_out_in_python(const ToldManifold& told) {
  const std::optional<LeftOut> reason = told.manifold.geometry.no_patches;
  return reason ? py::object(word(*reason)) : py::object(py::none());
}

py::dict derivative_in_python(const ToldManifold& told, const py::object& v, const py::object& w, const py::object& v_b,
                              const py::object& w_b) {
  const unsigned dimension = told.manifold.geometry.dimension;
  const Twist of_a = twist_from(v, w, "v", "w", dimension), of_b = twist_from(v_b, w_b, "v_b", "w_b", dimension);
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
                  "root"_a = fraction(rate.root()), "direction"_a = unit(rate.direction, dimension),
                  "normal"_a = integers(rate.direction, dimension), "patch"_a = rate.patch, "corner"_a = rate.corner);
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

Twist twist_from(py::handle v, py::handle w, const char* v_name, const char* w_name, unsigned dimension) {
  const auto is_rest = [](py::handle from) { return from.equal(py::make_tuple(0, 0, 0)); };
  const auto velocity = [&](py::handle from, const char* name) {
    if (dimension == 2 && is_rest(from)) return Point();
    return named(name, [&] { return point_from(from, dimension); });
  };
  const auto speed = [&](py::handle from) {
    return is_rest(from) ? Point() : named(w_name, [&] { return Point{0, 0, number_from(from)}; });
  };
  return {velocity(v, v_name), dimension == 2 ? speed(w) : velocity(w, w_name)};
}

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
