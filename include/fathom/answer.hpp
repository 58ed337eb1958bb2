// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies of any kinds: polytopes, shapes, unions of convex pieces.
// Output  the exact answer about them, in the same words for every kind; what a kind lacks, it says
//         why.
//
// A polytope beside a shape counts as a shape, and beside a union as a union of one piece.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"

namespace fathom {

/// How an answer is found. What it says does not depend on it, but for the width of bounds and the
/// number of optima that are listed.
struct Question {
  Options options;  ///< of polytopes, and of cores that are; its monitor and workspace serve every kind
  unsigned bits = SignedDepthOptions{}.bits;    ///< of the bounds of shapes, as in SignedDepthOptions
  bool coaxial = SignedDepthOptions{}.coaxial;  ///< of shapes about one axis, as in SignedDepthOptions
  bool union_bounds = UnionOptions{}.bounds;    ///< of unions, as in UnionOptions
};

/// A part of an answer, or why there is none.
template <class T>
struct Part {
  std::optional<T> value;         ///< the part
  std::string_view why_not = {};  ///< a clause, unless there is a value

  explicit operator bool() const { return value.has_value(); }  ///< whether there is a value
  const T& operator*() const { return *value; }                 ///< the value, which must be there
  const T* operator->() const { return &*value; }               ///< the same
};

/// A point or a vector whose coordinates are rational but for one root each.
using SurdPoint = std::array<Surd, 3>;

/// A shortest way out.
struct WayOut {
  Vector direction;       ///< primitive
  SurdPoint translation;  ///< moving A by it, the interiors are disjoint
};

/// A point of each body.
struct SurdWitness {
  SurdPoint a, b;  ///< b - a is the answer's translation
};

/// The answer about two bodies, by what was found.
struct Answer {
  std::variant<Depth, SignedDepth, UnionDepth> found;  ///< of two polytopes; if one is another shape; if one is a union
  /// Of bodies of the plane: the answer about the prisms that stand for them (fathom/plane.hpp), of
  /// which `found` is what the plane has. Null else.
  std::shared_ptr<const Answer> prisms = nullptr;

  /// 2 of bodies of the plane: then every z is 0.
  [[nodiscard]] unsigned dimension() const { return prisms ? 2 : 3; }

  /// nullopt if bounds leave it open.
  [[nodiscard]] std::optional<Status> status() const;
  /// Its name, or "undecided".
  [[nodiscard]] std::string_view status_name() const;
  /// False if the monitor stopped the search for the depth of unions: then only bounds are known.
  [[nodiscard]] bool complete() const;

  /// The signed depth: the depth, 0 if the bodies touch, minus the distance if they are apart.
  /// low() <= it <= high(), equal if it is known exactly.
  [[nodiscard]] Part<Surd> exact() const;
  [[nodiscard]] Surd low() const;
  [[nodiscard]] Surd high() const;
  /// The same in binary64: rounded outward, and to nearest if both bounds round to one number.
  /// Infinite beyond binary64.
  [[nodiscard]] double low_binary64() const;
  [[nodiscard]] double high_binary64() const;
  [[nodiscard]] std::optional<double> nearest_binary64() const;

  /// Primitive: of the first shortest way out, or of the distance. Unions that touch have none.
  [[nodiscard]] Part<Vector> direction() const;
  /// Moving A by it, no shorter way, bodies that penetrate or are apart touch; 0 if they touch.
  [[nodiscard]] Part<SurdPoint> translation() const;
  /// In the faces in the direction. Unions have a pair only if they are apart.
  [[nodiscard]] Part<SurdWitness> witness() const;
  /// The faces in the direction, by the indices of points: of polytopes, of cores that are, of the
  /// nearest pieces. Null if there are none.
  [[nodiscard]] const Contact* contact() const;

  /// How many shortest ways out are listed; 0 unless the bodies penetrate and the depth is known
  /// exactly.
  [[nodiscard]] std::size_t ways_out() const;
  /// Of these the one at `index`, which must be below ways_out().
  [[nodiscard]] WayOut way_out(std::size_t index) const;

  /// The depth of the polytopes, or of cores that are; null for all else.
  [[nodiscard]] const Depth* core() const;
  /// The bounds beside the depth of unions: absent for all else, and if they were not asked for.
  [[nodiscard]] Part<UnionBounds> union_bounds() const;
};

/// Returns the answer about two bodies, as penetration_depth, signed_depth and union_depth do.
/// Throws what they throw.
Answer exact_answer(const Body& a, const Body& b, const Question& question = {});

/// Returns which of these two bodies are flat; of polytopes also how many extreme points the answer
/// counted. Unions are not flat, as their pieces have interiors. Exact. Of shapes it is found anew
/// with each call, by elimination in rationals.
BodyFacts facts_of(const Body& a, const Body& b, const Answer& answer);

/// Returns the certificate of an answer about these two bodies, in the first format that holds it;
/// where a body is the solid of a mesh, it is about the mesh. Throws as the functions of
/// fathom/certificate.hpp do.
std::string certificate_text(const Body& a, const Body& b, const Answer& answer, std::string_view id = {},
                             Monitor* monitor = nullptr);

}  // namespace fathom
