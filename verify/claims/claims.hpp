// SPDX-License-Identifier: GPL-3.0-or-later
// Statements of other projects' tests and issues about two bodies, and whether they are right.
//                                                                         [verify/claims/README.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/output/json_values.hpp"
#include "reference/output/result_fields.hpp"

namespace fathom::claims {

/// A number with the digits that were published: "1.500000" is 3/2, in units of 1e-6.
struct WrittenNumber {
  std::string text;
  mpq_class value;
  mpq_class unit;  ///< of the last decimal place that was written
};

/// A published expectation. Fields that it does not state are not set.
struct PublishedClaim {
  Case bodies;  ///< with the claim's id
  std::string source, kind, note;
  std::optional<Status> status;
  std::optional<WrittenNumber> depth, distance;
  std::optional<WrittenNumber> below;  ///< an upper bound of the signed depth
  std::optional<mpq_class> tolerance;  ///< absolute, of the lengths above and of a direction's separating distance
  std::vector<Point> lines;            ///< directions without a sense; one of them is claimed to be optimal
  std::string line_text;               ///< the claimed direction as it was written
  /// the signed depth in doubles, computed by the collector of the claim; shown, never used
  std::optional<double> numeric;
};

/// Reads one line of JSON: a case of convex bodies, one half-space at most, with fields source,
/// kind, note and claim. Returns the claim, or what is wrong with the line.
std::variant<PublishedClaim, InputError> parse_claim(const std::string& text, const std::string& name,
                                                     std::size_t line);

/// Whether a statement is right. open: the bounds of the truth do not decide it.
enum class Finding { right, wrong, open };

/// One statement of a claim.
struct Statement {
  std::string text;  ///< "depth 0.1"
  Finding finding;
  std::string truth;  ///< for people: "the depth is 0.0894427, 0.0105573 less"
};

/// `statements` is empty if the claim states nothing that can be decided.
struct JudgedClaim {
  SignedDepth truth;
  std::vector<Statement> statements;

  /// Returns wrong if a statement is wrong, else open if one is open, else right; nullopt without
  /// statements.
  [[nodiscard]] std::optional<Finding> finding() const;
};

/// Returns "right", "wrong", "undecided" or "not-judgeable".
std::string_view verdict_name(const std::optional<Finding>& finding);

/// Judges each statement of the claim by exact comparison. A length is right if it is within the
/// claim's tolerance; without one, within half a unit of its last decimal place. A direction is a
/// line: it is right if the smaller separating distance of its two senses exceeds the depth by at
/// most the tolerance, or by no more than the rounding of its components explains (proofs/judge.md:
/// 2^-52 times the largest coordinate of P). Of a half-space the separating distance of all lines
/// but the normal is infinite; there the way along the line, until the bodies touch, may be longer
/// by the tolerance, or by what the rounding of an angle explains. Throws as signed_depth does.
JudgedClaim judge_claim(const PublishedClaim& claim);

// ---- as JSON: claim.schema.json ----

inline constexpr std::tuple statement_fields{
    text::field("text", &Statement::text, "", "What is stated."),
    text::Derived<Statement, std::string_view>{"finding", [](const Statement& of) { return verdict_name(of.finding); },
                                               "", "Whether it is so."},
    text::field("truth", &Statement::truth, "", "For people.")};
static_assert(text::stored_fields(statement_fields) + 1 == text::member_count<Statement>(),
              "each member of Statement has its row");
constexpr const auto& fields_of(const Statement*) { return statement_fields; }

/// A claim and what was found about it.
struct ClaimLine {
  const PublishedClaim& claim;
  const JudgedClaim& judged;
};

inline constexpr std::tuple
    claim_fields{
        text::Derived<ClaimLine, std::string>{"id", [](const ClaimLine& of) { return of.claim.bodies.id; }, "",
                                              "Of the claim."},
        text::Derived<ClaimLine, std::string>{"source", [](const ClaimLine& of) { return of.claim.source; }, "",
                                              "Where the claim was published."},
        text::Derived<ClaimLine, std::string>{"kind", [](const ClaimLine& of) { return of.claim.kind; }, "",
                                              "Of the source: test, issue."},
        text::Derived<ClaimLine, std::string>{"note", [](const ClaimLine& of) { return of.claim.note; }, "",
                                              "For people."},
        text::Derived<ClaimLine, std::string_view>{
            "verdict", [](const ClaimLine& of) { return verdict_name(of.judged.finding()); }, "", "On all statements."},
        text::Derived<ClaimLine, text::Json>{
            "signed_depth", [](const ClaimLine& of) { return output::signed_depth_object(of.judged.truth); }, "length",
            "The truth."},
        text::Derived<ClaimLine, std::optional<double>>{
            "numeric", [](const ClaimLine& of) { return of.claim.numeric; }, "length",
            "The signed depth that whoever collected the claim found in doubles: shown, never used."},
        text::Derived<ClaimLine, text::Json>{
            "direction", [](const ClaimLine& of) { return output::exact(of.judged.truth.direction()); },
            "", "One that attains the truth, or its upper bound."},
        text::
            Derived<ClaimLine, text::Json>{
                "statements",
                [](const ClaimLine& of) {
                  return text::Json::array_of(of.judged.statements, [](const Statement& statement) {
                    return output::with_fields(text::Json::object(), statement);
                  });
                },
                "", "What the claim states that can be decided. Of these the verdict is made: wrong if one is wrong."}};
constexpr const auto& fields_of(const ClaimLine*) { return claim_fields; }

}  // namespace fathom::claims
