// SPDX-License-Identifier: GPL-3.0-or-later
// The few points that make up the contact are the only ones that become rationals.
#include "reference/solve/narrow_depth.hpp"

#include <algorithm>

#include "reference/depth/contact.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/expanding/workspace.hpp"
#include "reference/solve/methods.hpp"

namespace fathom::solve {
namespace {

using polytope::NarrowInteger;
using polytope::NarrowPoints;

// c / 2^shift.
mpq_class over_power(NarrowInteger c, unsigned shift) {
  mpq_class q;
  if (sgn(c) == 0) return q;
  const unsigned shared = std::min(shift, c.trailing_zeros());
  c.divide_by_power(shared);
  q.get_num() = c.to_mpz();
  q.get_den() <<= shift - shared;
  return q;
}

Point exact(const Point& p) { return p; }
Point exact(const std::array<double, 3>& p) { return polytope::exact_point(p); }

// The contact, as depth::penetration_along finds it on any lattice.
// Points is a view of those of a body.
template <class Points>
class Contacts {
 public:
  Contacts(Points a, Points b, Workspace::Parts& parts)
      : input_a_(a), input_b_(b), pair_(parts.pair), a_(parts.pair.a), b_(parts.pair.b), memory_(parts.scan) {}

  Penetration along(const kernels::NearestPlanes& nearest, std::optional<std::size_t> listed) {
    Penetration result;
    const std::size_t all = nearest.directions().size(), most = std::min(all, listed.value_or(all));
    result.optima.reserve(most);
    result.unlisted = all - most;
    for (const Vector& n : nearest.directions()) {
      if (result.optima.size() == most) break;
      const Vec3<NarrowInteger> u{NarrowInteger(n.x), NarrowInteger(n.y), NarrowInteger(n.z)};
      std::vector<std::uint32_t> a = face(a_, -u), b = face(b_, u);
      const NarrowInteger height = dot(u, b_[b.front()] - a_[a.front()]);
      const ContactKind kind = depth::kind_of(a.size(), b.size());
      result.optima.push_back({n, over_power(height, pair_.shift), {kind, std::move(a), std::move(b)}});
      if (result.optima.size() == 1) result.meeting = meeting(n, result.optima.front().contact);
    }
    return result;
  }

 private:
  // The corners of the face of a body in direction u.
  std::vector<std::uint32_t> face(const NarrowPoints& body, const Vec3<NarrowInteger>& u) {
    polytope::find_extreme_points(body, u, pair_.exponent, memory_);
    const std::vector<std::uint32_t>& ids = memory_.near;
    if (ids.size() == 1 || (ids.size() == 2 && body[ids[0]] != body[ids[1]])) return ids;
    return depth::face_of(ids, points(body, ids)).ids;
  }

  static std::vector<Vector> points(const NarrowPoints& body, const std::vector<std::uint32_t>& ids) {
    std::vector<Vector> points;
    points.reserve(ids.size());
    for (const std::uint32_t i : ids) points.push_back(expanding::to_vector(body[i]));
    return points;
  }

  depth::FaceMeeting meeting(const Vector& n, const Contact& contact) {
    const auto a = [&](std::size_t k) { return input_a_[contact.a[k]]; };
    const auto b = [&](std::size_t k) { return input_b_[contact.b[k]]; };
    std::optional<depth::FaceMeeting> simple = depth::simple_meeting(contact.a.size(), contact.b.size(), a, b);
    if (simple) return std::move(*simple);
    polytope::PlacedPair unit;  // for positions
    unit.denominator <<= pair_.shift;
    unit.origin = exact(input_b_.front());
    return depth::overlap(unit, n, {{points(a_, contact.a), contact.a}, {points(b_, contact.b), contact.b}});
  }

  Points input_a_, input_b_;
  const polytope::NarrowPair& pair_;
  NarrowPoints a_, b_;
  kernels::ScanMemory& memory_;
};

template <class Points>
NarrowResult solve_narrow(kernels::Context& context, Points a, Points b, const Options& options) {
  if (!expands_first(options) || options.validate) return {};
  std::optional<Workspace> own;
  Workspace& workspace = options.workspace != nullptr ? *options.workspace : own.emplace();
  Workspace::Parts& parts = *workspace.parts;
  if (!polytope::place_narrow(a, b, parts.pair)) return {};
  const std::size_t budget = expansion_budget(options, a.size() + b.size());
  expanding::Expansion expansion = expanding::nearest_by_expansion(context, parts.pair, budget, &workspace);
  if (expansion.end != expanding::ExpansionEnd::proved) return {NarrowEnd::failed, std::nullopt};
  Penetration answer = Contacts<Points>(a, b, parts).along(expansion.nearest, options.optima);
  context.counters.expansions = expansion.points;
  context.counters.inner_facets = expansion.inner.facets.size();
  answer.inner = std::move(expansion.inner);
  const auto is_flat = [](const polytope::NarrowCloud& cloud) { return polytope::affine_rank(NarrowPoints(cloud)) < 3; };
  return {NarrowEnd::answered,
          Depth{{is_flat(parts.pair.a), is_flat(parts.pair.b), 0, 0}, std::move(answer), Method::certificate, context.counters}};
}

}  // namespace

NarrowResult depth_on_narrow_lattice(kernels::Context& context, kernels::Positions a, kernels::Positions b, const Options& options) {
  return solve_narrow(context, a, b, options);
}

NarrowResult depth_on_narrow_lattice(kernels::Context& context, std::span<const std::array<double, 3>> a,
                                     std::span<const std::array<double, 3>> b, const Options& options) {
  return solve_narrow(context, a, b, options);
}

}  // namespace fathom::solve
