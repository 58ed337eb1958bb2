// SPDX-License-Identifier: GPL-3.0-or-later
// What other projects' tests and issues state about two bodies, and whether it is so.
//                                                                         [verify/claims/README.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/signed_depth.hpp"

namespace fathom::claims {

/// A number with the digits that were published: "1.500000" is 3/2, in units of 1e-6.
struct WrittenNumber {
  std::string text;
  mpq_class value;
  mpq_class unit;  ///< of the last decimal place that was written
};

/// A published expectation. What it does not state is not set.
struct PublishedClaim {
  Case bodies;  ///< with the claim's id
  std::string source, kind, note;
  std::optional<Status> status;
  std::optional<WrittenNumber> depth, distance;
  std::optional<WrittenNumber> below;  ///< an upper bound of the depth, or of minus the distance
  std::optional<mpq_class> tolerance;  ///< absolute, of the lengths above and of a direction's price
  std::vector<Point> lines;            ///< directions without a sense; one of them is claimed to be optimal
  std::string line_text;               ///< the claimed direction as it was written
  /// the signed depth that was found in doubles by whoever collected the claim; shown, never used
  std::optional<double> numeric;
};

/// Reads one line of JSON: a case of convex bodies, one half-space at most, with fields source,
/// kind, note and claim. Returns the claim, or what is wrong with the line.
std::variant<PublishedClaim, InputError> parse_claim(const std::string& text, const std::string& name,
                                                     std::size_t line);

/// Whether something is so. open: it is not decided by the bounds of the truth.
enum class Finding { right, wrong, open };

/// One thing that a claim states.
struct Statement {
  std::string text;  ///< "depth 0.1"
  Finding finding;
  std::string truth;  ///< for people: "the depth is 0.0894427, 0.0105573 less"
};

/// `statements` is empty if nothing was stated that can be decided.
struct JudgedClaim {
  SignedDepth truth;
  std::vector<Statement> statements;

  /// wrong if a statement is, else open if one is, else right; nullopt without statements.
  [[nodiscard]] std::optional<Finding> finding() const;
};

/// "right", "wrong", "undecided", "not-judgeable".
std::string_view verdict_name(const std::optional<Finding>& finding);

/// Judges each statement of the claim by exact comparison. A length is right if it is within the
/// claim's tolerance; without one, within half a unit of its last decimal place. A direction is a
/// line: it is right if the cheaper of its two senses costs at most the tolerance more than the
/// depth, or no more than what the rounding of its components explains (proofs/judge.md: 2^-52
/// times the largest coordinate of P). Of a half-space the price of all lines but the normal is
/// infinite; there the way along the line, until the bodies touch, may be longer by the tolerance,
/// or at an angle to the normal that the rounding explains. Throws as signed_depth does.
JudgedClaim judge_claim(const PublishedClaim& claim);

}  // namespace fathom::claims
