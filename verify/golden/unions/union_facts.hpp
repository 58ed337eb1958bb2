// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a record of unions says, as exact values; and its line. Serialization is canonical: equal facts give equal bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fathom/union.hpp"
#include "verify/golden/unions/union_recipe.hpp"

namespace fathom::golden {

/// How far apart two unions are.
struct UnionGap {
  mpq_class squared;
  std::uint32_t a = 0, b = 0;  ///< pieces that are nearest; others may be as near
  Point translation;           ///< moving A by it, no shorter way, these touch
};

/// What an answer about two unions tells, whoever gives it.
struct UnionStatement {
  Status status = Status::disjoint;
  mpq_class squared;            ///< depth^2, 0 unless they penetrate
  std::vector<Point> optima;    ///< all shortest translations in lexicographic order, none unless they penetrate
  std::optional<UnionGap> gap;  ///< if they are disjoint
};

UnionStatement truth_of(const UnionDepth& answer);

/// The answer that records tell, which is complete. Throws as union_depth does, and Interrupted.
UnionDepth answer_about(const Case& unions, Monitor* monitor);

struct UnionFacts {
  Recipe recipe;
  FormedUnions bodies;
  UnionStatement truth;
  std::string certificate_sha256;
};

/// Returns the record's line, without a line feed.
std::string line_of(const UnionFacts& facts);

}  // namespace fathom::golden
