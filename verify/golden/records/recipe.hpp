// SPDX-License-Identifier: GPL-3.0-or-later
// The recipe of a base case of the golden data: a name, and for families a size and a seed; and the
// bodies of its records, which are the same on every machine.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "verify/families/families.hpp"

namespace fathom::golden {

/// The source of a base case.
enum class Source {
  family,           ///< a family of verify/families
  catalogue,        ///< an entry of the catalogue of degenerate pairs
  real,             ///< a pair from the issue tracker or the test suite of a library [tests/data/real_cases.jsonl]
  shape_family,     ///< a family of shapes
  shape_catalogue,  ///< an entry of the catalogue of shapes
  union_family,     ///< a family of unions of convex pieces
  union_catalogue,  ///< an entry of the catalogue of these
  plane_family      ///< a family of bodies of the plane
};

using families::Kind;  ///< which alternative of RecordBodies the bodies are

constexpr Kind kind_of(Source source) {
  switch (source) {
    case Source::family:
    case Source::catalogue:
    case Source::real: break;
    case Source::shape_family:
    case Source::shape_catalogue: return Kind::shapes;
    case Source::union_family:
    case Source::union_catalogue: return Kind::unions;
    case Source::plane_family: return Kind::plane;
  }
  return Kind::polytopes;
}

/// Returns whether a case of this source has a size and a seed.
constexpr bool from_family(Source source) {
  return source == Source::family || source == Source::shape_family || source == Source::union_family ||
         source == Source::plane_family;
}

struct Recipe {
  Source source = Source::family;
  std::string name;
  unsigned size = 0;       ///< of families
  std::uint64_t seed = 0;  ///< of families
  bool contacts = false;   ///< whether its records hold contacts too
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

/// The relation of a record's numbers to those of the base case.
enum class Form {
  given,     ///< unchanged
  binary64,  ///< each is rounded to the nearest binary64, ties to even
  binary32   ///< likewise to binary32, from the exact number
};

/// "family", "catalogue", "real", "shape_family", "shape_catalogue", "union_family",
/// "union_catalogue" or "plane_family".
std::string_view name_of(Source source);

constexpr std::string_view name_of(Form form) {
  return form == Form::given ? "given" : form == Form::binary64 ? "binary64" : "binary32";
}

/// Returns "<name>-n<size>-s<seed>", or "<kind of source>-<name>" without a family: no two recipes
/// share one, and an id never changes its bodies. Begins with "contacts-" for records of contacts;
/// ends in ".b64" or ".b32" for rounded ones.
std::string id_of(const Recipe& recipe, Form form = Form::given);

/// Two polytopes, the hulls of points.
struct HullPair {
  Body a, b;  ///< in binary64 if all of the body's coordinates are
};

/// The answer about unions that is known by construction.
struct KnownUnion {
  Status status = Status::disjoint;
  mpq_class squared;       ///< depth^2, or the squared distance if they are disjoint
  std::size_t optima = 0;  ///< 0 unless they penetrate
};

/// Two unions of convex pieces.
struct Unions {
  Pieces a, b;
  /// Set for the original bodies only. An entry of the catalogue states it; of convex bodies that
  /// were cut it is the answer about the hulls.
  std::optional<KnownUnion> known = std::nullopt;
};

/// Two bodies, in the order of Kind. The known answer about shapes, too, is set for the original
/// bodies only. Bodies of the plane are all shapes: polygons, segments and points, with radii or 0.
using RecordBodies = std::variant<HullPair, families::NamedPair, Unions, families::PlanePair>;

/// Returns two bodies of the plane as records have them.
families::PlanePair plane_of(const Case& bodies);

/// The bodies of one record.
struct FormedCase {
  Form form = Form::given;
  std::string id;  ///< the record's
  RecordBodies bodies;
  bool contacts = false;  ///< as in the recipe
};

/// Returns the bodies of the base case. Throws std::invalid_argument if nothing has that name.
RecordBodies base_bodies(const Recipe& recipe);

/// Returns the bodies with each number rounded to the nearest: coordinates, lengths, margins, the
/// parts of quaternions and places. Returns nullopt if a number overflows; if distinct points of a
/// body all become equal, or a piece becomes flat; or if no shape results, because a length or a
/// quaternion becomes 0. Pieces that abutted may overlap then, or leave a gap.
std::optional<RecordBodies> rounded(const RecordBodies& base, Form form);

/// Returns whether every number of the bodies is one of that format.
bool in_format(const RecordBodies& bodies, Form format);

/// Returns the same points, in binary64 if all coordinates are.
GivenPoints in_simplest_form(const GivenPoints& points);

/// Returns the bodies of all records of a recipe, in their order: the exact ones, then those
/// rounded to binary64 if that moves a number, then those rounded to binary32 if that yields yet
/// other ones. Omits rounded ones if rounded() returns nullopt. Throws as base_bodies.
std::vector<FormedCase> cases_of(const Recipe& recipe);

// ---- the pairs of tests/data/real_cases.jsonl, compiled into the program ----

/// Pairs that made libraries fail, from their issue trackers and test suites, as binary64. Ids
/// without their common prefix "real::".
std::span<const Case> real_cases();

/// The text of the file.
std::string_view real_cases_text();

}  // namespace fathom::golden
