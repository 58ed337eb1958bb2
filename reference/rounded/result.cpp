// SPDX-License-Identifier: GPL-3.0-or-later
// Accessors of SignedDepth for every kind of cores.
#include "fathom/signed_depth.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"

namespace fathom {
namespace {

std::optional<Status> status_of(int low_sign, int high_sign) {
  if (low_sign != high_sign) return std::nullopt;
  return low_sign > 0 ? Status::penetrating : low_sign < 0 ? Status::disjoint : Status::touching;
}

// h(n) / <n,n>, where (h(n) / <n,n>) n is known.
mpq_class factor(const Point& translation, const Vector& n) { return dot(n, translation) / dot(n, n); }

// Points a and b of cores with b - a = (h(n) / <n,n>) n, n the direction.
Witness witness_of(const Depth& cores) { return cores.distance() ? cores.distance()->witness : *cores.witness(); }

}  // namespace

std::optional<Status> SignedDepth::status() const {
  if (const Surd* known = exact()) return status_of(sign(*known), sign(*known));
  return status_of(sgn(bounds()->low), sgn(bounds()->high));
}

double SignedDepth::low_binary64() const {
  return exact() ? round_binary64(*exact(), Rounding::rd) : round_binary64(bounds()->low, Rounding::rd);
}

double SignedDepth::high_binary64() const {
  return exact() ? round_binary64(*exact(), Rounding::ru) : round_binary64(bounds()->high, Rounding::ru);
}

Vector SignedDepth::direction() const {
  if (cone) return cone->direction();
  if (const Depth* cores = std::get_if<Depth>(&core)) return cores->direction();
  if (const PlaneSupport* plane = std::get_if<PlaneSupport>(&core)) return plane->direction;
  return std::get<Bracket>(core).direction;
}

std::vector<AlongNormal> SignedDepth::translations() const {
  if (!exact()) return {};
  const mpq_class rho = radius_a + radius_b;
  const Depth* const cores = std::get_if<Depth>(&core);
  if (cores != nullptr && cores->penetration()) {
    std::vector<AlongNormal> all;
    for (const Optimum& optimum : cores->optima())
      all.push_back({optimum.direction, optimum.support / dot(optimum.direction, optimum.direction), rho});
    return all;
  }
  const Vector n = direction();
  if (cores != nullptr) return {{n, cores->distance() ? factor(cores->distance()->translation, n) : mpq_class(0), rho}};
  const PlaneSupport* const plane = std::get_if<PlaneSupport>(&core);
  if (plane == nullptr) return {};
  return {{n, plane->support / dot(n, n), rho}};
}

const Contact* SignedDepth::contact() const {
  const Depth* const cores = std::get_if<Depth>(&core);
  if (cores == nullptr) return nullptr;
  return touching ? &*touching : cores->contact();
}

Counters SignedDepth::counters() const {
  if (const Depth* const cores = std::get_if<Depth>(&core)) return cores->counters;
  Counters counters;
  const Bracket* const bracket = std::get_if<Bracket>(&core);
  counters.support_calls = bracket != nullptr ? bracket->support_calls : 1;
  if (bracket == nullptr) return counters;
  counters.expansions = bracket->polytope.vertices.size();
  counters.inner_facets = bracket->polytope.facets.size();
  return counters;
}

std::optional<RoundedWitness> SignedDepth::witness() const {
  if (!exact() || std::holds_alternative<Bracket>(core)) return std::nullopt;
  const Depth* const cores = std::get_if<Depth>(&core);
  const Witness found = cores != nullptr ? witness_of(*cores) : std::get<PlaneSupport>(core).witness;
  const Vector n = direction();
  return RoundedWitness{{found.a, n, -radius_a}, {found.b, n, radius_b}};
}

}  // namespace fathom
