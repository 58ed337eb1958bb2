// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/src/answers.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/src/bodies.hpp"
#include "bindings/python/src/numbers.hpp"
#include "fathom/certificate.hpp"
#include "fathom/study.hpp"
#include "kernels/context.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/shapes/body_notes.hpp"
#include "reference/shapes/core.hpp"
#include "verify/check/check.hpp"
#include "verify/check/reader.hpp"

namespace fathom::python {
namespace {

using py::literals::operator""_a;

py::str status(const PairAnswer& asked) { return std::string(asked.answer.status_name()); }

py::object nearest(const PairAnswer& asked) {
  return py::cast(asked.answer.complete() ? asked.answer.nearest_binary64() : std::nullopt);
}

py::object exact_in_python(const PairAnswer& asked) {
  const Part<Surd> value = asked.answer.exact();
  return value ? py::object(py::make_tuple(fraction(value->rational), fraction(value->root))) : py::object(py::none());
}

py::object bounds(const PairAnswer& asked) {
  const Bounds* const bounds = asked.of_shapes() ? asked.of_shapes()->bounds() : nullptr;
  return bounds ? py::object(py::make_tuple(fraction(bounds->low), fraction(bounds->high))) : py::object(py::none());
}

/// The bounds of the squared depth of unions; both are equal if the depth is known.
py::object squares(const PairAnswer& asked) {
  const UnionDepth* const unions = asked.of_unions();
  return unions ? py::object(py::make_tuple(fraction(unions->low), fraction(unions->high))) : py::object(py::none());
}

py::object direction(const PairAnswer& asked) {
  const Part<Vector> n = asked.answer.direction();
  return n ? py::object(unit(*n, asked.answer.dimension())) : py::object(py::none());
}

py::object normal(const PairAnswer& asked) {
  const Part<Vector> n = asked.answer.direction();
  return n ? py::object(integers(*n, asked.answer.dimension())) : py::object(py::none());
}

py::object around(const PairAnswer& asked) {
  const Vector* const axis = asked.of_shapes() ? asked.of_shapes()->around() : nullptr;
  return axis ? py::object(integers(*axis)) : py::object(py::none());
}

/// The translation of polytopes and unions; of a search that was stopped, the shortest one found.
std::optional<Point> rational_translation(const PairAnswer& asked) {
  if (const Depth* const depth = asked.depth()) return depth->contact_translation();
  const UnionDepth* const unions = asked.of_unions();
  if (!unions) return std::nullopt;
  return unions->apart ? unions->apart->distance.translation : unions->optima.front().translation;
}

/// (n, alpha, beta).
py::tuple along_normal(const AlongNormal& t, unsigned dimension) {
  return py::make_tuple(integers(t.normal, dimension), fraction(t.alpha), fraction(t.beta));
}

py::object translation(const PairAnswer& asked, bool exact) {
  const unsigned dimension = asked.answer.dimension();
  if (const std::optional<Point> t = rational_translation(asked))
    return exact ? py::object(fractions(*t, dimension)) : py::object(array(*t, dimension));
  const Part<SurdPoint> rounding = asked.answer.translation();
  if (!rounding) return py::none();
  if (!exact) return array(rounded::nearest_binary64(*rounding), dimension);
  return along_normal(asked.of_shapes()->translations().front(), dimension);
}

py::object witness_in_python(const PairAnswer& asked, bool exact) {
  const unsigned dimension = asked.answer.dimension();
  if (const Depth* const depth = asked.depth())
    return witness(std::optional(depth->contact_points()), exact, dimension);
  if (const UnionDepth* const unions = asked.of_unions())
    return witness(unions->apart ? std::optional(unions->apart->distance.witness) : std::nullopt, exact, dimension);
  const std::optional<RoundedWitness> found = asked.of_shapes()->witness();
  if (!found) return py::none();
  return py::make_tuple(rounded_point(found->a, exact, dimension), rounded_point(found->b, exact, dimension));
}

py::dict optimum(const Vector& n, const Contact* touching, py::array_t<double> translation, py::object exact,
                 unsigned dimension) {
  return py::dict("direction"_a = unit(n, dimension), "normal"_a = integers(n, dimension),
                  "translation"_a = std::move(translation), "exact_translation"_a = std::move(exact),
                  "contact"_a = contact(touching));
}

py::dict touch(const PieceContact& met, unsigned dimension) {
  return py::dict("pieces"_a = py::make_tuple(met.a, met.b), "direction"_a = unit(met.direction, dimension),
                  "normal"_a = integers(met.direction, dimension), "contact"_a = contact(&met.contact),
                  "mesh_a"_a = features(met.mesh_a), "mesh_b"_a = features(met.mesh_b));
}

py::list optima_of_unions(const UnionDepth& found, unsigned dimension) {
  py::list list;
  for (const UnionOptimum& optimum : found.optima) {
    py::list contacts;
    for (const PieceContact& met : optimum.contacts) contacts.append(touch(met, dimension));
    list.append(py::dict("translation"_a = array(optimum.translation, dimension),
                         "exact"_a = fractions(optimum.translation, dimension), "clearance"_a = optimum.clearance,
                         "contacts"_a = contacts));
  }
  return list;
}

py::list optima(const PairAnswer& answer) {
  const unsigned dimension = answer.answer.dimension();
  if (const UnionDepth* const unions = answer.of_unions()) return optima_of_unions(*unions, dimension);
  py::list list;
  const Depth* const core = answer.answer.core();
  if (const Depth* const depth = answer.depth()) {
    for (const Optimum& o : depth->optima()) {
      const Point t = o.translation();
      list.append(optimum(o.direction, &o.contact, array(t, dimension), fractions(t, dimension), dimension));
    }
    return list;
  }
  const std::vector<AlongNormal> translations = answer.of_shapes()->translations();
  for (std::size_t i = 0; i < translations.size(); ++i) {
    const AlongNormal& t = translations[i];
    const Contact* const touching =
        core && i < core->optima().size() ? &core->optima()[i].contact : answer.of_shapes()->contact();
    list.append(optimum(t.normal, touching, array(rounded::nearest_binary64(t), dimension), along_normal(t, dimension),
                        dimension));
  }
  return list;
}

std::size_t optima_count(const PairAnswer& answer) {
  if (const UnionDepth* const unions = answer.of_unions()) return unions->optima.size();
  if (const Depth* const core = answer.answer.core(); core && core->optima_count() > 0) return core->optima_count();
  return answer.depth() ? 0 : answer.of_shapes()->translations().size();
}

py::object apart(const PairAnswer& answer) {
  const UnionDepth* const unions = answer.of_unions();
  if (!unions || !unions->apart) return py::none();
  const UnionDistance& apart = *unions->apart;
  const Distance& d = apart.distance;
  const unsigned dimension = answer.answer.dimension();
  return py::dict("distance"_a = root_binary64(d.squared), "squared"_a = fraction(d.squared),
                  "pieces"_a = py::make_tuple(apart.a, apart.b), "translation"_a = array(d.translation, dimension),
                  "witness"_a = witness(d.witness, true, dimension), "contact"_a = contact(&d.contact),
                  "mesh_a"_a = features(apart.mesh_a), "mesh_b"_a = features(apart.mesh_b));
}

py::object union_bounds(const PairAnswer& answer) {
  const Part<UnionBounds> found = answer.answer.union_bounds();
  if (!found) return py::none();
  const UnionBounds& bounds = *found;
  return py::dict("deepest_pair"_a = root_binary64(bounds.deepest_pair),
                  "pieces"_a = py::make_tuple(bounds.a, bounds.b), "hulls"_a = root_binary64(bounds.hulls),
                  "deepest_pair_squared"_a = fraction(bounds.deepest_pair), "hulls_squared"_a = fraction(bounds.hulls));
}

std::string certificate(PairAnswer& answer, const std::string& id, bool patches) {
  const std::shared_ptr<ToldManifold> told = patches ? manifold_told(answer) : nullptr;
  return watched([&](Monitor& monitor) {
    std::string text =
        output::certificate_of(answer.a, answer.b, answer.answer, told ? &told->manifold : nullptr, {}, id, &monitor);
    fathom_check::require_readable(text);
    return text;
  });
}

py::object method(const PairAnswer& answer) {
  const Depth* const depth = answer.answer.core();
  return depth && depth->method ? py::object(py::str(std::string(name(*depth->method)))) : py::object(py::none());
}

py::tuple flatness(const PairAnswer& asked) {
  const BodyFacts facts = facts_of(asked.a, asked.b, asked.answer);
  return py::make_tuple(facts.flat_a, facts.flat_b);
}

py::object contact_in_python(const PairAnswer& answer) { return contact(answer.answer.contact()); }

py::dict counters_in_python(const PairAnswer& answer) {
  if (const UnionDepth* const unions = answer.of_unions()) {
    const UnionCounters& counted = unions->counters;
    return py::dict("nodes"_a = counted.nodes, "nearest_points"_a = counted.nearest_points, "pairs"_a = counted.pairs,
                    "pairs_touched"_a = counted.pairs_touched);
  }
  const Counters counters = answer.depth() ? answer.depth()->counters : answer.of_shapes()->counters();
  py::dict result;
  py::list stages;
  for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
    if (stage.ran()) stages.append(std::string(stage.stage));
    for (const kernels::Count& count : stage.counts) result[py::str(std::string(count.name))] = count.value;
  }
  result["stages"] = stages;
  result["predicates"] = predicates(counters.predicates);
  return result;
}

std::vector<std::string> notes(const PairAnswer& answer) {
  std::vector<std::string> result = answer.notes;
  for (const Body* body : {&answer.a, &answer.b})
    std::ranges::move(files::file_notes(*body), std::back_inserter(result));
  if (const std::optional<std::string> sizes = shapes::sizes_note(shapes::sizes_of(answer.a, answer.b)))
    result.push_back(*sizes);
  if (!answer.dents.empty()) result.push_back(answer.dents);
  return result;
}

py::dict checked(const std::string& text) {
  const fathom_check::Verdict verdict = [&] {
    const py::gil_scoped_release unlocked;
    return fathom_check::verify(text);
  }();
  return py::dict("accepted"_a = verdict.accepted(),
                  "malformed"_a = verdict.outcome == fathom_check::Outcome::malformed, "line_number"_a = verdict.line,
                  "reason"_a = verdict.reason, "status"_a = verdict.status,
                  "verdict"_a = fathom_check::verdict_line(verdict, ""));
}

/// The question that the answer replies to: the name of a function of this module, and its
/// arguments. pickle keeps it to compute the answer again.
py::tuple question_of(const PairAnswer& answer) {
  if (answer.of_unions())
    return py::make_tuple("union_depth", answer.a, answer.b, py::none(), py::none(), answer.question.union_bounds,
                          py::none());
  const Options& options = answer.question.options;
  return py::make_tuple("depth", answer.a, answer.b, py::none(), py::none(), std::string(name(options.method)),
                        options.optima, answer.question.bits);
}

PairAnswer union_answer(const py::object& a, const py::object& b, const py::object& pose_a, const py::object& pose_b,
                        bool bounds, const py::object& stop) {
  PairAnswer result;
  result.a = posed(union_from(a, "A", "a"), pose_a, "a", &result.notes);
  result.b = posed(union_from(b, "B", "b"), pose_b, "b", &result.notes);
  warn_of_dents(result.a, "A");
  warn_of_dents(result.b, "B");
  result.question.union_bounds = bounds;
  result.answer = watched(
      [&](Monitor& monitor) {
        Question of_call = result.question;
        of_call.options.monitor = &monitor;
        return exact_answer(result.a, result.b, of_call);
      },
      stop);
  return result;
}

}  // namespace

Question question(const std::string& method, const std::optional<std::size_t>& optima, unsigned bits) {
  Question result;
  result.bits = bits;
  result.options.optima = optima;
  for (const Method known : {Method::automatic, Method::exact, Method::naive, Method::certificate})
    if (name(known) == method) {
      result.options.method = known;
      return result;
    }
  throw py::value_error("expected method 'automatic', 'exact', 'naive' or 'certificate', found '" + method + "'");
}

PairAnswer answer_to(Asked asked, const Question& question, Monitor& monitor) {
  thread_local Workspace workspace;
  std::vector<std::string> notes;
  std::string dents = shapes::dents_text({hull_fact(asked.a), hull_fact(asked.b)});
  Body a = posed(std::move(asked.a), asked.pose_a, "a", &notes),
       b = posed(std::move(asked.b), asked.pose_b, "b", &notes);
  Question of_call = question;
  of_call.options.monitor = &monitor;
  of_call.options.workspace = &workspace;
  Answer answer = exact_answer(a, b, of_call);
  return {std::move(a), std::move(b), question, std::move(answer), std::move(notes), std::move(dents)};
}

py::dict predicates(const PredicateCounts& counts) {
  py::dict result;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const TierCounts& tier = counts[i];
    py::dict decided;
    for (const auto& [monomial, count] : tier.decided) decided[py::str(monomial_name(monomial))] = count;
    result[py::str(std::string(predicate_names[i]))] =
        py::dict("calls"_a = tier.calls, "exact"_a = tier.exact, "zero"_a = tier.zero, "decided"_a = decided);
  }
  return result;
}

py::list features(const std::vector<MeshFeature>& of_mesh) {
  py::list list;
  for (const MeshFeature& f : of_mesh)
    list.append(py::dict("kind"_a = std::string(name(f.kind)), "ids"_a = py::tuple(py::cast(f.ids))));
  return list;
}

py::object contact(const Contact* touching) {
  if (!touching) return py::none();
  return py::dict("kind"_a = std::string(name(touching->kind)), "a"_a = py::tuple(py::cast(touching->a)),
                  "b"_a = py::tuple(py::cast(touching->b)));
}

py::object witness(const std::optional<Witness>& found, bool exact, unsigned dimension) {
  if (!found) return py::none();
  if (exact) return py::make_tuple(fractions(found->a, dimension), fractions(found->b, dimension));
  return py::make_tuple(array(found->a, dimension), array(found->b, dimension));
}

py::dict weights(const std::vector<Weight>& of_points) {
  py::dict result;
  for (const Weight& w : of_points) result[py::int_(w.index)] = fraction(w.weight);
  return result;
}

py::array_t<double> unit(const Vector& n, unsigned dimension) { return array(rounded::nearest_unit(n), dimension); }

py::object rounded_point(const RoundedPoint& p, bool exact, unsigned dimension) {
  if (exact) return py::make_tuple(fractions(p.core, dimension), integers(p.normal, dimension), fraction(p.distance));
  return array(rounded::nearest_binary64(p), dimension);
}

void bind_answers(py::module_& module) {
  using py::arg;
  py::class_<PairAnswer>(module, "Answer")
      .def_property_readonly("status", status)
      .def_property_readonly("complete", [](const PairAnswer& asked) { return asked.answer.complete(); })
      .def_property_readonly("low", [](const PairAnswer& asked) { return asked.answer.low_binary64(); })
      .def_property_readonly("high", [](const PairAnswer& asked) { return asked.answer.high_binary64(); })
      .def_property_readonly("nearest", nearest)
      .def_property_readonly("exact_value", exact_in_python)
      .def_property_readonly("bounds", bounds)
      .def_property_readonly("squares", squares)
      .def_property_readonly("direction", direction)
      .def_property_readonly("normal", normal)
      .def_property_readonly("around", around)
      .def_property_readonly("translation", [](const PairAnswer& found) { return translation(found, false); })
      .def_property_readonly("exact_translation", [](const PairAnswer& found) { return translation(found, true); })
      .def_property_readonly("witness", [](const PairAnswer& found) { return witness_in_python(found, false); })
      .def_property_readonly("exact_witness", [](const PairAnswer& found) { return witness_in_python(found, true); })
      .def_property_readonly("optima", optima)
      .def_property_readonly("optima_count", optima_count)
      .def_property_readonly("method", method)
      .def_property_readonly("flat", flatness)
      .def_property_readonly("contact", contact_in_python)
      .def_property_readonly("apart", apart)
      .def_property_readonly("union_bounds", union_bounds)
      .def_property_readonly("counters", counters_in_python)
      .def_property_readonly("notes", notes)
      .def_readonly("dents", &PairAnswer::dents)
      .def_property_readonly("question", question_of)
      .def("manifold", manifold_told)
      .def("certificate", certificate, arg("id"), arg("patches"));
  module.def(
      "depth",
      [](const py::object& a, const py::object& b, const py::object& pose_a, const py::object& pose_b,
         const std::string& method, const std::optional<std::size_t>& optima, unsigned bits) {
        Asked asked{body_from(a, py::none(), "a"), body_from(b, py::none(), "b")};
        asked.pose_a = pose_from(pose_a, "a", asked.a.dimension);
        asked.pose_b = pose_from(pose_b, "b", asked.b.dimension);
        const Question how = question(method, optima, bits);
        return watched([&](Monitor& monitor) { return answer_to(std::move(asked), how, monitor); });
      },
      arg("a"), arg("b"), arg("pose_a"), arg("pose_b"), arg("method"), arg("optima"), arg("bits"));
  module.def(
      "width",
      [](const py::object& body, const py::object& pose, unsigned bits) {
        const Body one = body_from(body, pose, "body", nullptr, shapes::width_of_union);
        if (one.shape) shapes::require_width(*one.shape);
        return watched([&](Monitor& monitor) { return answer_to({one, one}, {.options = {}, .bits = bits}, monitor); });
      },
      arg("body"), arg("pose"), arg("bits"));
  module.def("union_depth", union_answer, arg("a"), arg("b"), arg("pose_a"), arg("pose_b"), arg("bounds"), arg("stop"));
  module.def("check", checked, arg("text"));
}

}  // namespace fathom::python
