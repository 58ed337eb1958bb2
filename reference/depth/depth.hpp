// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets with rational coordinates; each stands for its convex hull.
// Output  the exact penetration depth of the two hulls, squared, with every optimum.        [AGHRS, PENETRATION-DEPTH, section 2.2]
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fathom/monitor.hpp"
#include "kernels/counters.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "kernels/vector.hpp"
#include "reference/expanding/inner_polytope.hpp"
#include "reference/lines/engines.hpp"

namespace fathom {

struct Polytope;

/// Where O lies with respect to P = B (+) (-A): in its interior; on its boundary, or in a flat P; outside.
enum class Status { penetrating, touching, disjoint };

/// The six kinds of facets of P. A's feature comes first.
enum class ContactKind { facet_vertex, vertex_facet, facet_edge, edge_facet, facet_facet, edge_edge };

/// The faces of the bodies in one direction, as ascending 0-based indices of the input points that span them: extreme points only,
/// of equal points the lowest index.
struct Contact {
  ContactKind kind;
  std::vector<std::uint32_t> a, b;
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// A shortest way out. Moving A by `translation` makes the interiors disjoint, and |translation| is the depth.
struct Optimum {
  Vector direction;   ///< primitive outward normal of a nearest facet of P
  Point translation;  ///< (h(n) / <n,n>) n
  Contact contact;
  friend bool operator==(const Optimum&, const Optimum&) = default;
};

/// Points a of A and b of B with b - a = translation: in the contact's faces where there is a contact.
struct Witness {
  Point a, b;
  friend bool operator==(const Witness&, const Witness&) = default;
};

/// exact: AGHRS section 2. naive: the convex hull of all vertex differences, its independent twin. certificate: a polytope that expands
/// inside P [reference/expanding]; past its budget exact takes over. shallow: the facets of P near O alone, AGHRS section 3.2; see
/// reference/approximate/shallow.hpp.
enum class Method { exact, naive, certificate, shallow };

/// How far disjoint bodies are apart.
struct Distance {
  mpq_class squared;  ///< distance^2, in lowest terms
  Vector direction;   ///< primitive n with h(n) / |n| = -distance: no direction separates the bodies more widely
  Point translation;  ///< (h(n) / <n,n>) n. Moving A by it, no shorter way, the bodies touch
  Witness witness;    ///< nearest points: b - a = translation
};

struct Depth {
  Status status = Status::disjoint;
  mpq_class squared;                           ///< depth^2, in lowest terms; 0 unless penetrating
  std::vector<Optimum> optima;                 ///< one per direction, sorted lexicographically on it; empty unless penetrating
  std::optional<Vector> direction;             ///< of the first optimum; of the distance; touching: a primitive u with h(u) = 0
  Point translation;                           ///< of the first optimum; else 0
  std::optional<Contact> contact;              ///< of the first optimum
  std::optional<Witness> witness;              ///< of the first optimum; a common point when touching
  std::optional<Distance> distance;            ///< of disjoint bodies
  bool flat_a = false, flat_b = false;         ///< whether the body has no interior
  std::uint32_t extreme_a = 0, extreme_b = 0;  ///< number of extreme points of each body; 0 when no hull was needed
  Method method = Method::exact;               ///< the one that ran to the end
  std::optional<InnerPolytope> inner;          ///< method certificate, penetrating: the polytope that proves the depth
  Counters counters;
};

struct Options {
  Method method = Method::exact;
  /// Method certificate: how many points the expanding polytope may take before the exact method is asked instead. Not set: 200 and
  /// twice the number of all points, but at most 20,000; to use them up takes about as long as the exact method takes at least.
  std::optional<std::size_t> expansion_budget;
  ClosestLines closest_lines = ClosestLines::cutting;
  /// Of the closest lines' random order. Results do not depend on it, only counters do.
  std::uint64_t seed = 1;
  /// Called now and then with the stage's name and the share of it that is done, in [0, 1]. Return false to stop.
  std::function<bool(const std::string& stage, double share)> progress;
  /// How coincidences are resolved. Results do not depend on it.
  Perturbation perturbation;
  /// Run `validate` on every stage and throw std::logic_error on any broken law. Slow.
  bool validate = false;
};

/// Throws std::invalid_argument when a body is empty, and for Method::shallow, which shallow_depth offers.
Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options = {});

/// Finds the outward normals of all nearest facets of P, primitive and in lexicographic order, with O in the interior of P.
using FindNearest = std::function<std::vector<Vector>(const Polytope& a, const Polytope& b, Counters& counters)>;

/// The same with another way to find them, for rooms to the right; `options.method` is not read.
Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options, const FindNearest& find_nearest);

/// One exact number along a sweep across contact: depth^2 of penetrating bodies, 0 of touching ones, -distance^2 of disjoint ones. Its
/// signed root is the least h(u) / |u| over all directions u, a continuous function of where the bodies are.
mpq_class signed_square(const Depth& depth);

}  // namespace fathom
