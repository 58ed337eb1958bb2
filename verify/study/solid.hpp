// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of square roots of rationals, and vectors of such numbers: is it zero? Roots of numbers
// whose ratio is the square of a rational are multiples of one another, and others are linearly
// independent over the rationals: so a sum is zero if and only if the factors of each class add up
// to zero.                                                              [proofs/shapes.md, "Study"]
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "kernels/vector.hpp"

namespace fathom::studies {

class RootSum {
 public:
  /// Adds factor * sqrt(square), square >= 0.
  void add(const mpq_class& factor, const mpq_class& square = 1);
  /// Adds times * the sum.
  void add(const RootSum& sum, const mpq_class& times = 1);
  [[nodiscard]] bool is_zero() const;

 private:
  struct Part {
    mpq_class square, factor;  ///< square > 0; the ratio of no two is a square
  };
  std::vector<Part> parts_;
};

using RationalVector = Vec3<mpq_class>;

inline RationalVector rational_vector(const Point& p) { return {p.x, p.y, p.z}; }
inline RationalVector rational_vector(const Vector& v) { return {v.x, v.y, v.z}; }
inline RationalVector scaled(const mpq_class& s, const RationalVector& v) { return {s * v.x, s * v.y, s * v.z}; }

/// Returns the primitive integer vector along a vector other than 0.
Vector primitive_along(const RationalVector& v);

/// rational + sqrt(square) irrational.
struct RootVector {
  RationalVector rational, irrational;
  mpq_class square;
};

/// Returns whether one of them is a multiple of the other; 0 is.
bool parallel(const RootVector& u, const RootVector& v);

// ---- faces ----

// Input   a sum of terms, and a direction.
// Output  the face of the sum in that direction, which is the set of its farthest points: its
//         dimension, and its kind.

/// The kind of a face of dimension 0. In a sum the later kind prevails.
enum class Corner { vertex, apex, rim, smooth };

struct SupportFace {
  RootSum height;  ///< the support: the greatest <n,x>
  /// Independent vectors of differences of its points: as many as its dimension, at most two.
  std::vector<RootVector> spanning;
  Corner corner = Corner::vertex;  ///< for dimension 0
  bool of_points = true;           ///< whether only atoms that are points attain the support
};

/// Returns the face. `direction` must not be 0; every term must have an atom.
SupportFace support_face(std::span<const Term> terms, const Vector& direction);

// ---- solids ----

// Input   a shape.
// Output  its parts that can coincide with parts of another shape: centre, axis, radii, flat faces,
//         generators. All are rationals or square roots of rationals.

struct Line {
  RationalVector point;
  Vector direction;  ///< primitive
};

/// A flat face. Its plane is <normal,x> = height, on the body.
struct FlatFace {
  Vector normal;  ///< outward, primitive
  RootSum height;
};

/// The parallel generators of a cylinder, circular or elliptic, or of a capsule.
struct Generators {
  Line axis;
  std::optional<Surd> radius;  ///< if it is a circular cylinder about the axis
};

struct ShapeSolid {
  Shape shape;                           ///< simplified: a polytope as one term of its extreme points
  bool is_polytope = false;              ///< the core
  std::optional<RationalVector> centre;  ///< of symmetry
  std::optional<Line> axis;              ///< of revolution, if it is the only one
  std::vector<Surd> radii;               ///< different ones
  std::vector<FlatFace> faces;           ///< sorted by normal, which differ
  std::vector<Generators> sides;
  std::vector<RationalVector> apexes;  ///< of cones and of frusta, where the apex was cut off

  [[nodiscard]] const HalfSpace* half_space() const { return std::get_if<HalfSpace>(&shape.core); }
  [[nodiscard]] std::span<const Term> terms() const { return std::get<std::vector<Term>>(shape.core); }
};

/// The limit on line directions of the terms of a sum: with more of them, facets that two of them
/// span are not found.
inline constexpr std::size_t most_line_directions = 500;

/// Returns these parts. The shape must satisfy the requirements of signed_depth.
ShapeSolid solid_of(const Shape& shape);

/// Returns the name of the kind of the body's face: "vertex", "apex", "rim point", "smooth point",
/// "edge", "generator", "face".
std::string_view word_of(const ShapeSolid& solid, const SupportFace& face);

// ---- revolution ----

// Input   a sum of terms.
// Output  the line about which it is a body of revolution.

/// Returns the squared radius of a circular disc or a round ball. Returns nullopt for other atoms,
/// including points.
std::optional<mpq_class> round_square(const Atom& atom);

/// Returns the axis of revolution. Returns nullopt if there is none, or if there are several, as
/// for a ball. Finds every axis of a sum whose terms are bodies of revolution themselves.
std::optional<Line> axis_of(std::span<const Term> terms);

}  // namespace fathom::studies
