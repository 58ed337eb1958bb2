// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/src/answers.hpp"
#include "bindings/python/src/bodies.hpp"
#include "bindings/python/src/numbers.hpp"
#include "fathom/certificate.hpp"
#include "fathom/union.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/shapes/body_notes.hpp"
#include "verify/check/unreadable.hpp"

namespace fathom::python {
namespace {

struct UnionAnswer {
  Body a, b;
  UnionDepth found;
  std::vector<std::string> notes = {};
};

}  // namespace
}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::python::UnionAnswer> : fathom::python::MadeCaster<fathom::python::UnionAnswer> {};

namespace fathom::python {
namespace {

using py::literals::operator""_a;

// ---- bodies ----

/// Says that a mesh is not convex, to the caller of the function of Python that called.
void warn(const std::string& sentence) {
  constexpr py::ssize_t caller = 2;
  const py::object category = py::module_::import("fathom").attr("NotConvexWarning");
  if (PyErr_WarnEx(category.ptr(), sentence.c_str(), caller) != 0) throw py::error_already_set();
}

/// The points of a convex body, "piece 3 of A" as a warning calls it, and "a: piece 3" an error.
std::vector<Point> piece_from(py::handle from, const std::string& called, const std::string& name) {
  const Body body = body_from(from, py::none(), name.c_str());
  if (body.shape) throw py::value_error(name + ": expected a polytope, found another shape: pieces are neither round nor curved");
  const std::optional<polytope::MeshConvexity> fact = [&] {
    const py::gil_scoped_release unlocked;
    return hull_fact(body);
  }();
  if (fact && fact->dents) warn(shapes::dents_of(called, *fact->dents));
  return body.points.exact();
}

/// One piece, or as many as there are.
Pieces pieces_from(py::handle from, const std::string& called, const std::string& name) {
  if (is_one_body(from)) return {piece_from(from, called, name)};
  if (py::isinstance<py::str>(from) || !py::isinstance<py::iterable>(from))
    throw py::type_error(name + ": expected convex pieces, or one convex body, found " + py::repr(py::type::of(from)).cast<std::string>());
  Pieces pieces;
  for (const py::handle item : py::reinterpret_borrow<py::iterable>(from)) {
    const std::string piece = "piece " + std::to_string(pieces.size());
    pieces.push_back(piece_from(item, piece + " of " + called, name + ": " + piece));
  }
  if (pieces.empty()) throw py::value_error(name + ": expected at least one convex piece, found none");
  return pieces;
}

/// Takes a union that is there, or what pieces_from takes.
Body union_from(py::handle from, const std::string& called, const std::string& name) {
  if (py::isinstance<Body>(from) && from.cast<const Body&>().pieces) return from.cast<Body>();
  return files::union_of(pieces_from(from, called, name));
}

/// Warns of the pieces of a union that are not convex, where faces tell it.
void warn_of_dents(const Body& body, const std::string& called) {
  const std::optional<shapes::DentedPieces> dented = [&] {
    const py::gil_scoped_release unlocked;
    return shapes::dented_pieces(body);
  }();
  if (dented && !dented->empty()) warn(shapes::dents_text(called, *dented));
}

Body union_in_files(const std::string& path, const std::string& decimals) {
  Body body = files::read_union(path, decimals_from(decimals));
  warn_of_dents(body, path);
  return body;
}

// ---- answers ----

UnionAnswer answer_about(const py::object& a, const py::object& b, const py::object& pose_a, const py::object& pose_b, bool bounds,
                         const py::object& stop) {
  UnionAnswer answer;
  answer.a = posed(union_from(a, "A", "a"), pose_a, "a", &answer.notes);
  answer.b = posed(union_from(b, "B", "b"), pose_b, "b", &answer.notes);
  warn_of_dents(answer.a, "A");
  warn_of_dents(answer.b, "B");
  answer.found = watched([&](Monitor& monitor) { return union_depth(*answer.a.pieces, *answer.b.pieces, {&monitor, bounds}); }, stop);
  if (const std::optional<std::string> sizes = shapes::sizes_note(shapes::sizes_of(answer.a, answer.b))) answer.notes.push_back(*sizes);
  return answer;
}

py::dict touch(const PieceContact& met) {
  return py::dict("pieces"_a = py::make_tuple(met.a, met.b), "direction"_a = unit(met.direction), "normal"_a = integers(met.direction),
                  "contact"_a = contact(&met.contact));
}

py::list optima(const UnionAnswer& answer) {
  py::list list;
  for (const UnionOptimum& optimum : answer.found.optima) {
    py::list contacts;
    for (const PieceContact& met : optimum.contacts) contacts.append(touch(met));
    list.append(py::dict("translation"_a = array(optimum.translation), "exact"_a = fractions(optimum.translation),
                         "clearance"_a = optimum.clearance, "contacts"_a = contacts));
  }
  return list;
}

py::object apart(const UnionAnswer& answer) {
  if (!answer.found.apart) return py::none();
  const UnionDistance& apart = *answer.found.apart;
  const Distance& d = apart.distance;
  return py::dict("distance"_a = root_binary64(d.squared), "squared"_a = fraction(d.squared), "pieces"_a = py::make_tuple(apart.a, apart.b),
                  "translation"_a = array(d.translation), "witness"_a = witness(d.witness, true), "contact"_a = contact(&d.contact));
}

py::object bounds(const UnionAnswer& answer) {
  if (!answer.found.bounds) return py::none();
  const UnionBounds& bounds = *answer.found.bounds;
  return py::dict("deepest_pair"_a = root_binary64(bounds.deepest_pair), "pieces"_a = py::make_tuple(bounds.a, bounds.b),
                  "hulls"_a = root_binary64(bounds.hulls), "deepest_pair_squared"_a = fraction(bounds.deepest_pair),
                  "hulls_squared"_a = fraction(bounds.hulls));
}

py::dict counters(const UnionAnswer& answer) {
  const UnionCounters& counted = answer.found.counters;
  return py::dict("nodes"_a = counted.nodes, "nearest_points"_a = counted.nearest_points, "pairs"_a = counted.pairs,
                  "pairs_touched"_a = counted.pairs_touched);
}

std::string certificate(const UnionAnswer& answer, const std::string& id) {
  return watched([&](Monitor& monitor) {
    std::string text = certificate_text(*answer.a.pieces, *answer.b.pieces, answer.found, id, &monitor);
    fathom_check::require_readable(text);
    return text;
  });
}

}  // namespace

void bind_unions(py::module_& module) {
  using py::arg;
  py::class_<UnionAnswer>(module, "UnionAnswer")
      .def_property_readonly("status", [](const UnionAnswer& answer) { return std::string(name(answer.found.status)); })
      .def_property_readonly("complete", [](const UnionAnswer& answer) { return answer.found.complete; })
      .def_property_readonly("low_squared", [](const UnionAnswer& answer) { return fraction(answer.found.low); })
      .def_property_readonly("high_squared", [](const UnionAnswer& answer) { return fraction(answer.found.high); })
      .def_property_readonly("low", [](const UnionAnswer& answer) { return root_binary64(answer.found.low, Rounding::rd); })
      .def_property_readonly("high", [](const UnionAnswer& answer) { return root_binary64(answer.found.high, Rounding::ru); })
      .def_property_readonly("depth",
                             [](const UnionAnswer& answer) {
                               return answer.found.complete ? py::object(py::float_(root_binary64(answer.found.low)))
                                                            : py::object(py::none());
                             })
      .def_property_readonly("optima", optima)
      .def_property_readonly("apart", apart)
      .def_property_readonly("bounds", bounds)
      .def_property_readonly("counters", counters)
      .def_readonly("notes", &UnionAnswer::notes)
      .def_property_readonly("question",
                             [](const UnionAnswer& answer) {  // arguments of union_depth, which make the answer again
                               return py::make_tuple(answer.a, answer.b, py::none(), py::none(), answer.found.bounds.has_value(),
                                                     py::none());
                             })
      .def("certificate", certificate, arg("id"));
  module.def("union_depth", answer_about, arg("a"), arg("b"), arg("pose_a"), arg("pose_b"), arg("bounds"), arg("stop"));
  module.def(
      "union", [](const py::object& pieces) { return union_from(pieces, "the body", "pieces"); }, arg("pieces"));
  module.def("read_pieces", union_in_files, arg("path"), arg("decimals"));
}

}  // namespace fathom::python
