// SPDX-License-Identifier: GPL-3.0-or-later
// All values of a record, exact and rounded; and its texts. Serialization is canonical: equal facts
// give equal bytes.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/depth.hpp"
#include "fathom/patch.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"
#include "kernels/vector.hpp"
#include "reference/output/answer_json.hpp"
#include "reference/text/json.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

// ---- numbers, correctly rounded in every mode  [proofs/number.md] ----

/// A number in both formats and all modes; a binary32 value as its equal double. Modes in the order
/// rn, rd, ru.
struct Rounded {
  std::array<double, 3> binary64, binary32;
};

using RoundedVector = std::array<Rounded, 3>;  ///< x, y, z

Rounded rounded_value(const mpq_class& value);
Rounded rounded_surd(const Surd& value);

/// The root of `squared` >= 0.
Rounded rounded_root(const mpq_class& squared);

/// n / |n|; n is not zero. A component is the root of n_i^2 / <n,n> with the sign of n_i, so rd and
/// ru change places for a negative one.
RoundedVector rounded_unit(const Vector& n);

RoundedVector rounded_point(const Point& p);

/// Returns alpha n + beta n/|n|, each component rounded on its own.
RoundedVector rounded_along(const AlongNormal& vector);

// ---- the truth about two bodies, independent of the method that found it ----

struct HullStatement {
  Depth answer;                  ///< its method and counters are not recorded
  std::optional<mpq_class> gap;  ///< penetrating: squared distance of the second-best facet, unless all tie

  // The results as records print them. Each number is rounded once, in all modes.
  Rounded depth{}, distance{};  ///< the distance of disjoint bodies, else 0
  /// One vector for each optimum; without optima, that of the direction and, of disjoint bodies,
  /// the translation to the contact.
  std::vector<RoundedVector> units, translations;

  std::vector<std::string_view> flags;  ///< in the order of flag_names()
};

struct ShapeStatement {
  std::variant<Surd, Bounds> value;  ///< the signed depth, exact or enclosed
  Vector direction;
  /// Exact values of cores that are polytopes, or of a polytope and a half-space, as in
  /// SignedDepth::translations(). Else empty.
  std::vector<AlongNormal> translations;
  std::optional<OptimalCone> cone;  ///< of such cores if they touch
};

/// The distance of two unions.
struct UnionGap {
  mpq_class squared;
  std::uint32_t a = 0, b = 0;  ///< a pair of nearest pieces; others may be as near
  Point translation;           ///< the shortest translation of A after which these pieces touch
};

struct UnionStatement {
  Status status = Status::disjoint;
  mpq_class squared;            ///< depth^2, 0 unless they penetrate
  std::vector<Point> optima;    ///< all shortest translations in lexicographic order, none unless they penetrate
  std::optional<UnionGap> gap;  ///< if they are disjoint
};

/// Of bodies of the plane: every z is 0.
struct PlaneStatement {
  ShapeStatement shapes;
  std::vector<Contact> contacts;  ///< the faces of the cores along each translation; none if the cores touch
};

/// In the order of RecordBodies.
using RecordStatement = std::variant<HullStatement, ShapeStatement, UnionStatement, PlaneStatement>;

/// Returns the values of a record about these points; `answer` is that of penetration_depth. Throws
/// Interrupted.
HullStatement truth_of(const HullPair& hulls, Depth answer, Monitor* monitor = nullptr, Workspace* workspace = nullptr);
ShapeStatement truth_of(const SignedDepth& answer);
UnionStatement truth_of(const UnionDepth& answer);
/// `answer` is about bodies of the plane, which are shapes.
PlaneStatement truth_of(const Answer& answer);

/// Returns the answer about shapes for records: with bounds as close as signed_depth makes them,
/// and closer ones if these leave the status open. Throws as signed_depth does.
SignedDepth answer_about(const Shape& a, const Shape& b, const Options& options);

/// Returns the answer about unions for records, from a complete search. Throws as union_depth does,
/// and Interrupted.
UnionDepth answer_about(const Pieces& a, const Pieces& b, Monitor* monitor);

/// Returns the answer about bodies of the plane, which are shapes. Throws as exact_answer does.
Answer answer_about(const families::PlanePair& bodies, const Options& options);

// ---- where the bodies touch ----

/// The additional fields of a record of contacts, as `fathom depth --patch` prints them.
struct ContactFacts {
  output::Manifold manifold;
  /// along each of recorded_motions()
  std::vector<std::variant<DirectionalDerivative, LeftOut>> derivatives;
};

/// Returns motions of A, with B at rest, for which these records hold the derivative of the signed
/// depth.
std::span<const Twist> recorded_motions();

/// An answer with the fields of a record of contacts. Of polytopes that touch, the direction is the
/// one of their cone that certificates of patches contain.
struct ContactStatement {
  Answer answer;
  RecordStatement truth;
  ContactFacts contacts;
};

/// Returns the truth about these polytopes, or shapes. Throws as penetration_depth and signed_depth
/// do.
ContactStatement contacts_of(const RecordBodies& bodies, const Options& options);

/// Returns the certificate: format 4, with all patches, and the derivatives that it can prove.
/// Throws as certificate_text does, and std::invalid_argument for curved bodies.
std::string certificate_of(const RecordBodies& bodies, const ContactStatement& found, const std::string& id,
                           Monitor* monitor = nullptr);

// ---- records ----

/// The schemas of records, in the order of RecordStatement.
inline constexpr std::array<std::string_view, 4> record_schemas{"fathom/golden/1", "fathom/golden-shapes/1",
                                                                "fathom/golden-unions/1", "fathom/golden-plane/1"};

struct Facts {
  Recipe recipe;
  FormedCase made;
  bool in_binary64 = false, in_binary32 = false;  ///< whether every number of the bodies is one of that format
  RecordStatement truth;
  std::string certificate_sha256;
  std::optional<ContactFacts> contacts = std::nullopt;  ///< set for records of contacts
};

/// Returns the facts. `truth` must be of the same kind as the bodies.
Facts facts_of(const Recipe& recipe, FormedCase made, RecordStatement truth, std::string certificate_sha256,
               std::optional<ContactFacts> contacts = std::nullopt);

/// Writes what the line of a record of this schema begins with, up to its id.
void open_line(text::JsonStream& out, std::string_view schema);
/// Returns the record's line, without a line feed.
std::string line_of(const Facts& facts);

/// The names of the columns of the CSV, with a line feed. NOTES.md explains them.
std::string csv_header();

/// Returns the record as CSV with hex floats, for programs that read neither JSON nor rationals,
/// with a line feed; empty unless it is of polytopes and all of its points are binary64.
std::string csv_row(const Facts& facts);

// ---- flags ----

// Flags: words for special properties of a record of polytopes. NOTES.md explains each; all are
// decided exactly.

/// Returns all flags, in the order in which a record lists them.
std::vector<std::string_view> flag_names();

// ---- faces of bodies by their definition ----

// Found in exact integers by one pass over all points, without hulls and filters. They prove
// contacts and witnesses of records independently of the answer.

/// All points of both bodies as multiples of 1 / denominator.
struct Integers {
  mpz_class denominator = 1;  ///< positive
  std::vector<Vector> a, b;
};

Integers integers_of(std::span<const Point> a, std::span<const Point> b);

/// The face of a body in a direction.
struct SupportingFace {
  mpz_class height;                    ///< max <n,p>
  std::vector<std::uint32_t> corners;  ///< indices of its extreme points, ascending; of equal points the lowest
  std::vector<Vector> cycle;           ///< their positions: one, two, or a convex polygon in cyclic order
};

/// n is not zero, `points` not empty.
SupportingFace face_in_direction(std::span<const Vector> points, const Vector& n);

/// Whether the point p, whose unit is 1, lies in the face of points whose unit is 1 / denominator.
bool contains(const SupportingFace& face, const Vector& n, const mpz_class& denominator, const Point& p);

}  // namespace fathom::golden
