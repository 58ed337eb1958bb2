// SPDX-License-Identifier: GPL-3.0-or-later
// The accessors of an answer, for every kind of bodies: whatever differs between the kinds stands
// here.
#include "fathom/answer.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/solid.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/answer/plane.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/patch/patch.hpp"
#include "reference/rounded/coordinates.hpp"

namespace fathom {
namespace {

using rounded::coordinates;

constexpr std::string_view only_bounds = "only bounds of the signed depth are known: nothing follows from them exactly";
constexpr std::string_view stopped = "the search was stopped: only bounds of the depth are known";
constexpr std::string_view no_one_direction =
    "the unions touch: there is no one direction, but one for each two pieces";
constexpr std::string_view witness_if_disjoint = "unions have a pair of witness points only if they are disjoint";
constexpr std::string_view no_union = "no body is a union of pieces: there is one pair, and the hulls are the bodies";
constexpr std::string_view not_asked = "the bounds beside the depth were not asked for";

template <class... Functions>
struct ByKind : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
ByKind(Functions...) -> ByKind<Functions...>;  // clang 14 asks for it

SurdWitness surds(const rounded::CoordinatePair& pair) { return {pair[0], pair[1]}; }

Surd negated_root(const mpq_class& squared) { return {0, mpq_class(-squared)}; }

/// Names what of the meshes holds the contacts.
void name_features(UnionDepth& depth, const Body& a, const Body& b) {
  if (!depth.complete || (!a.solid && !b.solid)) return;
  const patch::SolidSurfaces surfaces(a, b);
  const Pieces pieces_a = pieces_of(a), pieces_b = pieces_of(b);
  const auto name = [&](auto& met, const Point& t, const Vector& n, const Contact& contact) {
    surfaces.name(patch::shared_after(t, {n, pieces_a[met.a], contact.a, pieces_b[met.b], contact.b}), met);
  };
  for (UnionOptimum& optimum : depth.optima)
    for (PieceContact& met : optimum.contacts) name(met, optimum.translation, met.direction, met.contact);
  if (!depth.apart) return;
  const Distance& distance = depth.apart->distance;
  name(*depth.apart, distance.translation, distance.direction, distance.contact);
}

}  // namespace

std::optional<Status> Answer::status() const {
  return std::visit(ByKind{[](const Depth& depth) { return std::optional(depth.status()); },
                           [](const SignedDepth& shapes) { return shapes.status(); },
                           [](const UnionDepth& unions) { return std::optional(unions.status); }},
                    found);
}

std::string_view Answer::status_name() const { return name(status()); }

bool Answer::complete() const {
  return std::visit(ByKind{[](const Depth&) { return true; }, [](const SignedDepth&) { return true; },
                           [](const UnionDepth& unions) { return unions.complete; }},
                    found);
}

Part<Surd> Answer::exact() const {
  return std::visit(ByKind{[&](const Depth&) -> Part<Surd> { return {low()}; },
                           [&](const SignedDepth& shapes) -> Part<Surd> {
                             if (!shapes.exact()) return {{}, only_bounds};
                             return {low()};
                           },
                           [&](const UnionDepth& unions) -> Part<Surd> {
                             if (!unions.complete) return {{}, stopped};
                             return {low()};
                           }},
                    found);
}

Surd Answer::low() const {
  return std::visit(ByKind{[](const Depth& depth) {
                             return Surd{0, signed_square(depth)};
                           },
                           [](const SignedDepth& shapes) {
                             return shapes.exact() ? *shapes.exact() : Surd{shapes.bounds()->low, 0};
                           },
                           [](const UnionDepth& unions) {
                             return unions.apart ? negated_root(unions.apart->distance.squared) : Surd{0, unions.low};
                           }},
                    found);
}

Surd Answer::high() const {
  return std::visit(ByKind{[&](const Depth&) { return low(); },
                           [&](const SignedDepth& shapes) {
                             return shapes.exact() ? low() : Surd{shapes.bounds()->high, 0};
                           },
                           [&](const UnionDepth& unions) {
                             return unions.complete ? low() : Surd{0, unions.high};
                           }},
                    found);
}

double Answer::low_binary64() const { return round_binary64(low(), Rounding::rd); }

double Answer::high_binary64() const { return round_binary64(high(), Rounding::ru); }

std::optional<double> Answer::nearest_binary64() const {
  const double least = round_binary64(low());
  return least == round_binary64(high()) ? std::optional(least) : std::nullopt;
}

Part<Vector> Answer::direction() const {
  return std::visit(ByKind{[](const Depth& depth) -> Part<Vector> { return {depth.direction()}; },
                           [](const SignedDepth& shapes) -> Part<Vector> { return {shapes.direction()}; },
                           [](const UnionDepth& unions) -> Part<Vector> {
                             if (unions.apart) return {unions.apart->distance.direction};
                             if (!unions.complete) return {{}, stopped};
                             if (unions.status == Status::touching) return {{}, no_one_direction};
                             return {primitive_along(unions.optima.front().translation)};
                           }},
                    found);
}

Part<SurdPoint> Answer::translation() const {
  return std::visit(
      ByKind{[](const Depth& depth) -> Part<SurdPoint> { return {coordinates(depth.contact_translation())}; },
             [](const SignedDepth& shapes) -> Part<SurdPoint> {
               const std::vector<AlongNormal> all = shapes.translations();
               if (all.empty()) return {{}, only_bounds};
               return {coordinates(all.front())};
             },
             [](const UnionDepth& unions) -> Part<SurdPoint> {
               if (unions.apart) return {coordinates(unions.apart->distance.translation)};
               if (!unions.complete) return {{}, stopped};
               return {coordinates(unions.optima.front().translation)};
             }},
      found);
}

Part<SurdWitness> Answer::witness() const {
  return std::visit(
      ByKind{[](const Depth& depth) -> Part<SurdWitness> { return {surds(coordinates(depth.contact_points()))}; },
             [](const SignedDepth& shapes) -> Part<SurdWitness> {
               const std::optional<RoundedWitness> witness = shapes.witness();
               if (!witness) return {{}, only_bounds};
               return {surds(coordinates(*witness))};
             },
             [](const UnionDepth& unions) -> Part<SurdWitness> {
               if (!unions.apart) return {{}, witness_if_disjoint};
               return {surds(coordinates(unions.apart->distance.witness))};
             }},
      found);
}

const Contact* Answer::contact() const {
  return std::visit(
      ByKind{[](const Depth& depth) { return depth.contact(); },
             [](const SignedDepth& shapes) { return shapes.contact(); },
             [](const UnionDepth& unions) { return unions.apart ? &unions.apart->distance.contact : nullptr; }},
      found);
}

std::size_t Answer::ways_out() const {
  if (status() != Status::penetrating || !exact()) return 0;
  return std::visit(ByKind{[](const Depth& depth) { return depth.optima().size(); },
                           [](const SignedDepth& shapes) { return shapes.translations().size(); },
                           [](const UnionDepth& unions) { return unions.optima.size(); }},
                    found);
}

WayOut Answer::way_out(std::size_t index) const {
  return std::visit(ByKind{[&](const Depth& depth) -> WayOut {
                             const Optimum& way = depth.optima()[index];
                             return {way.direction, coordinates(way.translation())};
                           },
                           [&](const SignedDepth& shapes) -> WayOut {
                             const AlongNormal way = shapes.translations()[index];
                             return {way.normal, coordinates(way)};
                           },
                           [&](const UnionDepth& unions) -> WayOut {
                             const Point& way = unions.optima[index].translation;
                             return {primitive_along(way), coordinates(way)};
                           }},
                    found);
}

const Depth* Answer::core() const {
  return std::visit(ByKind{[](const Depth& depth) { return &depth; },
                           [](const SignedDepth& shapes) { return std::get_if<Depth>(&shapes.core); },
                           [](const UnionDepth&) -> const Depth* { return nullptr; }},
                    found);
}

Part<UnionBounds> Answer::union_bounds() const {
  return std::visit(ByKind{[](const Depth&) -> Part<UnionBounds> {
                             return {{}, no_union};
                           },
                           [](const SignedDepth&) -> Part<UnionBounds> {
                             return {{}, no_union};
                           },
                           [](const UnionDepth& unions) -> Part<UnionBounds> {
                             return {unions.bounds, not_asked};
                           }},
                    found);
}

Answer exact_answer(const Body& a, const Body& b, const Question& question) {
  if (a.dimension == 2 || b.dimension == 2) {
    const answer::Prisms prisms = answer::prisms_of(a, b);
    return answer::in_plane(a, b, exact_answer(prisms.a, prisms.b, question));
  }
  if (a.pieces || b.pieces) {
    UnionDepth depth = union_depth(pieces_of(a), pieces_of(b), {question.options.monitor, question.union_bounds});
    name_features(depth, a, b);
    return {std::move(depth)};
  }
  if (!a.shape && !b.shape) return {penetration_depth(a, b, question.options)};
  return {signed_depth(files::shape_of(a), files::shape_of(b),
                       {.cores = question.options, .bits = question.bits, .coaxial = question.coaxial})};
}

BodyFacts facts_of(const Body& a, const Body& b, const Answer& answer) {
  return std::visit(ByKind{[](const Depth& depth) { return BodyFacts(depth); },
                           [&](const SignedDepth&) {
                             return BodyFacts{answer::is_flat_body(a), answer::is_flat_body(b)};
                           },
                           [](const UnionDepth&) { return BodyFacts(); }},
                    answer.found);
}

std::string certificate_text(const Body& a, const Body& b, const Answer& answer, std::string_view id,
                             Monitor* monitor) {
  if (answer.prisms) return answer::certificate_in_plane(a, b, answer, id, ShapeFormat::shortest, monitor);
  return std::visit(
      ByKind{[&](const Depth& depth) { return certificate_text(a, b, depth, id, monitor); },
             [&](const SignedDepth& shapes) {
               return certificate_text(files::shape_of(a), files::shape_of(b), shapes, id, ShapeFormat::shortest,
                                       monitor);
             },
             [&](const UnionDepth& unions) { return certificate::union_text(a, b, unions, id, monitor); }},
      answer.found);
}

}  // namespace fathom
