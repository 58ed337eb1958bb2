// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets with rational coordinates; each stands for its convex hull.
// Output  the exact penetration depth of the two hulls, squared, with every optimum.
//                                                           [AGHRS, PENETRATION-DEPTH, section 2.2]
//
// P = B (+) (-A) is the set of all differences b - a, and O the origin. h(u) = max_b <u,b> - min_a
// <u,a> is the support function of P. <u,v> is the scalar product. Lengths are in the unit of the
// coordinates, and given as their squares, which are rational.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/counters.hpp"
#include "fathom/monitor.hpp"
#include "fathom/point.hpp"

namespace fathom {

/// Where O lies with respect to P: in its interior; on its boundary, or in a flat P; outside.
enum class Status { penetrating, touching, disjoint };

/// What two faces are. A's comes first. The first six kinds are those of facets of P; the last
/// three occur where bodies do not overlap.
enum class ContactKind {
  facet_vertex,
  vertex_facet,
  facet_edge,
  edge_facet,
  facet_facet,
  edge_edge,  ///< the edges may be parallel if the bodies do not overlap
  vertex_vertex,
  vertex_edge,
  edge_vertex
};

/// The faces of the bodies in one direction n, that of A in direction -n and that of B in direction
/// n, as ascending 0-based indices of the input points that span them: extreme points only, of
/// equal points the lowest index.
struct Contact {
  ContactKind kind;                 ///< of which kind the two faces are
  std::vector<std::uint32_t> a, b;  ///< the input points that span the face of A, that of B
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// A shortest way out. Moving A by `translation` makes the interiors disjoint, and |translation| is
/// the depth.
struct Optimum {
  Vector direction;   ///< primitive outward normal n of a nearest facet of P
  mpq_class support;  ///< h(n) > 0, in lowest terms
  Contact contact;    ///< the faces in that direction

  /// (h(n) / <n,n>) n, computed when asked for.
  [[nodiscard]] Point translation() const;
  friend bool operator==(const Optimum&, const Optimum&) = default;
};

/// A point of A and a point of B.
struct Witness {
  Point a, b;  ///< of A, of B
  friend bool operator==(const Witness&, const Witness&) = default;
};

/// A point, and the pose that moves it.
struct MovedPoint {
  std::array<double, 3> point;  ///< before it is moved
  PoseBinary64 pose;            ///< that moves it
};

/// A point in the form in which it was given.
struct GivenPoint {
  std::variant<std::array<double, 3>, Point, MovedPoint> coordinates;  ///< as they were given
  [[nodiscard]] Point exact() const;                                   ///< the same point
};

/// A corner of one body, which a face of the other is to touch.
struct CornerOfA {
  GivenPoint point;  ///< of A
};
struct CornerOfB {
  GivenPoint point;  ///< of B
};

/// Edges that cross, seen along the direction of the contact.
struct CrossingEdges {
  std::array<GivenPoint, 2> a, b;  ///< the ends of the edge of A, and of that of B
};

/// Faces that overlap, seen along the direction of the contact: a facet and a facet or an edge.
struct OverlappingFaces {
  std::vector<GivenPoint> a, b;  ///< the corners of the face of A, and of that of B
  GivenPoint origin;             ///< the first point of B
  mpz_class units;               ///< > 0: times it, all differences from the origin are integral
};

/// A convex polytope inside P with O in its interior, which proves how far O is from the boundary
/// of P. Each corner is a corner of at least three facets, and no two facets lie in one plane.
struct InnerPolytope {
  /// indices of a point a of A and a point b of B, for the difference b - a
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertices;
  /// corners, counter-clockwise seen from outside, none on a line with its neighbours
  std::vector<std::vector<std::uint32_t>> facets;
};

/// What is known of bodies that penetrate.
struct Penetration {
  /// one per direction, sorted lexicographically on it; at least one, at most Options::optima
  std::vector<Optimum> optima;
  std::size_t unlisted = 0;  ///< further optima, whose directions follow those of `optima`
  /// What the witness follows from: the faces of the first optimum's contact; or the witness
  /// itself, where it was read.
  std::variant<CornerOfA, CornerOfB, CrossingEdges, OverlappingFaces, Witness> meeting;
  std::optional<InnerPolytope> inner;  ///< proves the depth; only after Method::certificate

  // Computed when asked for.

  /// depth^2 > 0, in lowest terms.
  [[nodiscard]] mpq_class squared() const;
  /// In the faces of the first optimum's contact, with b - a = its translation.
  [[nodiscard]] Witness witness() const;
};

/// What is known of bodies that touch.
struct Touch {
  Vector direction;  ///< primitive n with h(n) = 0: a plane orthogonal to it has the bodies on its two sides
  Point point;       ///< a common point
};

/// What is known of disjoint bodies.
struct Distance {
  mpq_class squared;  ///< distance^2, in lowest terms
  Vector direction;   ///< primitive n with h(n) / |n| = -distance: no direction separates the bodies more widely
  Point translation;  ///< (h(n) / <n,n>) n. Moving A by it, no shorter way, the bodies touch
  Witness witness;    ///< nearest points: b - a = translation
  Contact contact{};  ///< the faces in that direction, which hold all nearest points
};

/// A plane between bodies that do not penetrate: rays and approximations return nothing else about
/// them.
struct Separation {
  Vector normal;          ///< primitive n with h(n) = 0 if the bodies touch, h(n) < 0 if they are disjoint
  bool touching = false;  ///< whether the bodies touch; else they are disjoint
  [[nodiscard]] Status status() const { return touching ? Status::touching : Status::disjoint; }  ///< never penetrating
};

/// How a depth is found. All methods give the same answer; only Penetration::inner, Depth::method,
/// the numbers of extreme points and the counters depend on the method.
enum class Method {
  automatic,    ///< certificate within Options::expansion_budget, past it exact
  exact,        ///< AGHRS, section 2: Gaussian diagrams, canonical subsets, closest lines
  naive,        ///< the convex hull of all vertex differences: an independent twin, O(mn log mn)
  certificate,  ///< a polytope that expands inside P, which proves the depth; near ties can make it long
};

/// How the closest lines of a canonical pair are found. All three give the same answer.
enum class ClosestLines : std::uint8_t {
  cutting,  ///< cells along the grid's order, conflict lists, block tests
  sampled,  ///< a random sample guides the cells, as in AGHRS
  naive,    ///< every pair, through a double filter
};

/// Memory that calls use one after another: with it a depth of small bodies hardly allocates. One
/// for each thread; it may outlive any call.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;             ///< the other one may only be assigned to, or destroyed
  Workspace& operator=(Workspace&&) noexcept;  ///< in the same way

  struct Parts;
  std::unique_ptr<Parts> parts;  ///< not for users
};

/// How to compute a depth. The answer does not depend on it.
struct Options {
  Method method = Method::automatic;  ///< how the depth is found
  /// Method automatic: how many points the expanding polytope may take before the exact method is
  /// asked instead. Not set: 200 and twice the number of all points, but at most 20,000. Exhausting
  /// this budget costs about one exact run.
  std::optional<std::size_t> expansion_budget = std::nullopt;
  /// The engine of the exact method, cutting if not set. If set, automatic is exact.
  std::optional<ClosestLines> closest_lines = std::nullopt;
  /// How many optima are listed at most, the first in lexicographic order; all are counted. At
  /// least 1; not set: all.
  std::optional<std::size_t> optima = std::nullopt;
  /// Of the random order in which closest lines are searched. Results do not depend on it, only
  /// counters do.
  std::uint64_t seed = 1;
  /// Is called with the progress and may stop the work; may be null.
  Monitor* monitor = nullptr;
  /// Used by the call that gets it, and free for others when that returns; may be null.
  Workspace* workspace = nullptr;
  /// Run `validate` on every stage and throw std::logic_error on any broken law. Slow.
  bool validate = false;
};

/// What every answer says about the bodies themselves.
struct BodyFacts {
  bool flat_a = false, flat_b = false;         ///< whether the body has no interior
  std::uint32_t extreme_a = 0, extreme_b = 0;  ///< number of extreme points of each body; 0 if no hull was needed
};

/// An answer about two bodies: if they do not penetrate, it is a plane between them.
template <class Penetrating>
struct SeparationOr : BodyFacts {
  std::variant<Penetrating, Separation> outcome;  ///< what is known, by status

  [[nodiscard]] const Penetrating* penetration() const {
    return std::get_if<Penetrating>(&outcome);
  }  ///< null unless penetrating
  [[nodiscard]] const Separation* separation() const {
    return std::get_if<Separation>(&outcome);
  }  ///< null if penetrating
  [[nodiscard]] Status status() const {
    return separation() ? separation()->status() : Status::penetrating;
  }  ///< of the bodies
};

/// The answer about two bodies: `outcome` holds what the status has.
struct Depth : BodyFacts {
  std::variant<Penetration, Touch, Distance> outcome;  ///< in the order of Status
  /// The method that gave the answer, never automatic. The certificate method cannot decide bodies
  /// that do not penetrate: this is exact then. nullopt of answers by shallow_depth, and about
  /// prepared bodies.
  std::optional<Method> method;
  Counters counters;  ///< what the run did

  [[nodiscard]] Status status() const { return static_cast<Status>(outcome.index()); }  ///< of the bodies
  [[nodiscard]] const Penetration* penetration() const {
    return std::get_if<Penetration>(&outcome);
  }                                                                                  ///< null unless penetrating
  [[nodiscard]] const Touch* touch() const { return std::get_if<Touch>(&outcome); }  ///< null unless touching
  [[nodiscard]] const Distance* distance() const { return std::get_if<Distance>(&outcome); }  ///< null unless disjoint

  // The same for every status.

  /// depth^2: 0 unless penetrating.
  [[nodiscard]] mpq_class squared() const;
  /// Empty unless penetrating. Those that are listed.
  [[nodiscard]] const std::vector<Optimum>& optima() const;
  /// How many there are, listed or not: 0 unless penetrating.
  [[nodiscard]] std::size_t optima_count() const;
  /// The least h(u) / |u| is reached at u = direction: that of the first optimum, of the touch, of
  /// the distance.
  [[nodiscard]] const Vector& direction() const;
  /// The shortest translation of A that makes the interiors disjoint: that of the first optimum, 0
  /// unless penetrating.
  [[nodiscard]] Point translation() const;
  /// Of the first optimum, or of the distance; null if touching.
  [[nodiscard]] const Contact* contact() const;
  /// Points with b - a = translation(): in the faces of the optimum's contact, or a common point
  /// twice. nullopt if disjoint: see distance()->witness.
  [[nodiscard]] std::optional<Witness> witness() const;

  /// The shortest translation of A by which the bodies touch: translation(), or that of the
  /// distance.
  [[nodiscard]] Point contact_translation() const;
  /// Points with b - a = contact_translation(): witness(), or that of the distance.
  [[nodiscard]] Witness contact_points() const;
};

/// Returns whether two bodies penetrate, touch or are disjoint, and how deep or how far apart they
/// are. Exact, for bodies of every rank: degenerate input needs no special care. Time is
/// near-linear in the size of the bodies, except where very many edges of A and B cross at nearly
/// the same distance. Throws std::invalid_argument if a body is empty, a coordinate is not in
/// lowest terms or options.optima is 0, and Interrupted.
Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options = {});

/// The same for coordinates in binary64, which stand for their exact values. The fast way for small
/// bodies: no rational is made before one is asked for. Throws std::invalid_argument if a body is
/// empty or a coordinate is not finite, and Interrupted.
Depth penetration_depth(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b,
                        const Options& options = {});

/// The same for bodies in the form in which they were given: in binary64 if both are, else as exact
/// points.
Depth penetration_depth(const Body& a, const Body& b, const Options& options = {});

/// Returns the exact width of a body, the least distance of two parallel planes that hold it
/// between them: the depth of the body against itself [AGHRS, Proposition 2.1; Corollary 2.6].
/// squared() is the squared width, each optimum's direction is normal to a pair of nearest
/// supporting planes (and occurs with both signs), contact.a spans one of the two faces and
/// contact.b the other. A flat body has width 0 and status touching. Throws as penetration_depth
/// does.
Depth width(std::span<const Point> points, const Options& options = {});

/// One exact number along a sweep across contact: depth^2 of penetrating bodies, 0 of touching
/// ones, -distance^2 of disjoint ones. Its signed root is the least h(u) / |u| over all directions
/// u, a continuous function of where the bodies are.
mpq_class signed_square(const Depth& depth);

/// How clear an answer is: the least squared distance from O of a facet plane of P that is larger
/// than depth^2. Returns nullopt if all facets of P tie. Exact, for bodies of any rank.
/// `penetration` is that of the two bodies, found by any method. Throws std::invalid_argument if it
/// leaves optima unlisted.
std::optional<mpq_class> second_nearest_squared(std::span<const Point> a, std::span<const Point> b,
                                                const Penetration& penetration, Monitor* monitor = nullptr,
                                                Workspace* workspace = nullptr);
/// The same for bodies in the form in which they were given.
std::optional<mpq_class> second_nearest_squared(const Body& a, const Body& b, const Penetration& penetration,
                                                Monitor* monitor = nullptr, Workspace* workspace = nullptr);

// The words for the values of an answer, the same in every format.

std::string_view name(Status status);  ///< "penetrating", "touching", "disjoint"
/// The same; "undecided" of none, where bounds leave it open.
std::string_view name(const std::optional<Status>& status);
std::string_view name(ContactKind kind);  ///< "facet-vertex": A's feature first
std::string_view name(Method method);     ///< "automatic", "exact", "naive", "certificate"

/// The inverse of `name`; nullopt for other words.
std::optional<Status> status_named(std::string_view text);

}  // namespace fathom
