// SPDX-License-Identifier: GPL-3.0-or-later
// What a base case of the golden data is made from: a name, and for families a size and a seed. The same points on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"

namespace fathom::golden {

/// Where base cases come from.
enum class Source {
  family,           ///< a family of verify/families
  catalogue,        ///< an entry of the catalogue of degenerate pairs
  real,             ///< a pair from the issue tracker or the test suite of a library [tests/data/real_cases.jsonl]
  shape_family,     ///< a family of shapes
  shape_catalogue,  ///< an entry of the catalogue of shapes
  union_family,     ///< a family of unions of convex pieces
  union_catalogue   ///< an entry of the catalogue of these
};

/// What the bodies are.
enum class Kind {
  polytopes,  ///< hulls of points, which the functions below make
  shapes,     ///< shape_recipe.hpp makes these, and all functions below that tell of points throw for them
  unions      ///< likewise union_recipe.hpp
};

constexpr Kind kind_of(Source source) {
  switch (source) {
    case Source::family:
    case Source::catalogue:
    case Source::real: break;
    case Source::shape_family:
    case Source::shape_catalogue: return Kind::shapes;
    case Source::union_family:
    case Source::union_catalogue: return Kind::unions;
  }
  return Kind::polytopes;
}

/// Whether a case has a size and a seed.
constexpr bool from_family(Source source) {
  return source == Source::family || source == Source::shape_family || source == Source::union_family;
}

struct Recipe {
  Source source = Source::family;
  std::string name;
  unsigned size = 0;       ///< of families
  std::uint64_t seed = 0;  ///< of families
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

/// How the points of a record come from those of the base case.
enum class Form {
  given,     ///< they are those
  binary64,  ///< each coordinate rounded to the nearest binary64, ties to even
  binary32   ///< likewise to binary32, from the exact coordinate
};

/// "family", "catalogue", "real", "shape_family", "shape_catalogue", "union_family" or "union_catalogue".
std::string_view name_of(Source source);

/// "<name>-n<size>-s<seed>", or "<kind of source>-<name>" without a family: no two recipes share one, and no id is ever given to other
/// bodies. With ".b64" or ".b32" after it for rounded ones.
std::string id_of(const Recipe& recipe, Form form = Form::given);

/// Returns the points, with the recipe's id; a body's are in binary64 if all of its coordinates are. Throws std::invalid_argument if
/// nothing has that name.
Case base_case(const Recipe& recipe);

/// Returns the points rounded, with the id for that form. Returns nullopt if a coordinate overflows, or if the points of a body all become
/// equal that were not.
std::optional<Case> rounded_case(const Case& base, Form form);

/// The same points, of a body in binary64 if all of its coordinates are.
GivenPoints in_simplest_form(const GivenPoints& points);

/// Returns whether every coordinate is a number of that format.
bool in_format(const Case& points, Form format);

/// The points of one record.
struct FormedCase {
  Form form = Form::given;
  Case points;  ///< its id is the record's
};

/// Returns the points of all records of a recipe, in their order: the exact ones, then those rounded to binary64 if that moves a point,
/// then those rounded to binary32 if that yields yet other points. Omits rounded ones if rounded_case returns nullopt. Throws as base_case
/// does.
std::vector<FormedCase> cases_of(const Recipe& recipe);

}  // namespace fathom::golden
