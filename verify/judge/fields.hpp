// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the fields of a judgement: name, meaning, unit, since. The JSON of reports, written
// and read, the struct of C, the dict of Python and the pages of failures are made from it.
// tests/harness/fields_test.cpp compares with it what is not made from it: schema, header of C,
// class of Python, pages of text.     [reference/text/fields.hpp; VERDICTS.md; verdict.schema.json]
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "reference/text/fields.hpp"
#include "verify/judge/manifold.hpp"

namespace fathom::judging {

using text::Derived;
using text::field;
using text::member_count;
using text::stored_fields;

// ---- the claim: declarations and answers of an implementation ----

/// Writes a value of an enumeration as its word.
template <class Value>
struct Word {
  std::string_view word;
  Value value;
};
template <class Value>
Word(const char*, Value) -> Word<Value>;  // required by clang 14
inline constexpr std::array words_of_touching{Word{"overlap", Conventions::Touching::overlap},
                                              Word{"separate", Conventions::Touching::separate},
                                              Word{"either", Conventions::Touching::either}};
inline constexpr std::array words_of_sign{Word{"positive", Conventions::Sign::positive},
                                          Word{"negative", Conventions::Sign::negative}};
inline constexpr std::array words_of_body{Word{"a", Conventions::Body::a}, Word{"b", Conventions::Body::b}};
inline constexpr std::array words_of_claims{Word{"minimum", Conventions::Claims::minimum},
                                            Word{"separating", Conventions::Claims::separating}};
inline constexpr std::array words_of_precision{Word{"binary64", Precision::binary64},
                                               Word{"binary32", Precision::binary32}};
constexpr const auto& words_of(Conventions::Touching) { return words_of_touching; }
constexpr const auto& words_of(Conventions::Sign) { return words_of_sign; }
constexpr const auto& words_of(Conventions::Body) { return words_of_body; }
constexpr const auto& words_of(Conventions::Claims) { return words_of_claims; }
constexpr const auto& words_of(Precision) { return words_of_precision; }

template <class Value>
constexpr std::string_view word_of(Value value) {
  for (const auto& [word, of] : words_of(value))
    if (of == value) return word;
  return "";
}

inline constexpr std::tuple conventions_fields{
    field("touching", &Conventions::touching, "", "What bodies that touch count as."),
    field("depth", &Conventions::depth, "", "The sign of the depth of bodies that overlap."),
    field("moves", &Conventions::moves, "", "The body that |depth| * direction moves apart."),
    field("unit", &Conventions::unit, "", "Whether directions are promised to have length 1."),
    field("claims", &Conventions::claims, "", "What a depth with a direction means; minimum if it is not there.", "",
          [](const Conventions& of) { return of.claims != Conventions::Claims::minimum; })};
static_assert(stored_fields(conventions_fields) + 1 == member_count<Conventions>(),
              "each member of Conventions has its row, but for the manifold, which a hello has beside them");
constexpr const auto& fields_of(const Conventions*) { return conventions_fields; }

inline constexpr std::tuple contact_limits_fields{
    field("most", &ContactLimits::most, "", "How many contacts it answers at most."),
    field("margin", &ContactLimits::margin, "length",
          "How much less deep than the reply contacts without a depth may be.", "",
          [](const ContactLimits& of) { return of.margin != 0; })};
static_assert(stored_fields(contact_limits_fields) == member_count<ContactLimits>(),
              "each member of ContactLimits has its row");
constexpr const auto& fields_of(const ContactLimits*) { return contact_limits_fields; }

/// In the order of JSON; "witness.a" is a field of "witness".
inline constexpr std::tuple reply_fields{
    field("overlap", &Reply::overlap, "", "Whether the bodies overlap."),
    field("depth", &Reply::depth, "length", "The depth of the overlap."),
    field("distance", &Reply::distance, "length", "The distance of bodies that are said to be apart."),
    field("direction", &Reply::direction, "ratio", "The direction in which a body moves apart, or farther apart."),
    field("witness.a", &Reply::witness_a, "length", "A point of A."),
    field("witness.b", &Reply::witness_b, "length", "A point of B."),
    field("contacts", &Reply::contacts, "",
          "The points of a contact manifold; the largest of their depths is the depth.", "",
          [](const Reply& reply) { return !reply.contacts.empty(); }),
    field("derivative", &Reply::derivative, "length/time", "How fast the signed depth grows along the twists.")};
static_assert(stored_fields(reply_fields) == member_count<Reply>(), "each member of Reply has its row");

inline constexpr std::tuple contact_fields{
    field("position", &ContactPoint::position, "length", "A point of both bodies."),
    field("depth", &ContactPoint::depth, "length", "The depth there.")};
static_assert(stored_fields(contact_fields) == member_count<ContactPoint>(), "each member of ContactPoint has its row");

constexpr const auto& fields_of(const Reply*) { return reply_fields; }
constexpr const auto& fields_of(const ContactPoint*) { return contact_fields; }

// ---- the judgement ----

/// The fields of a derivative, in the order of JSON.
inline constexpr std::tuple derivative_fields{
    field("claimed", &DerivativeJudgement::claimed, "length/time", "As it was understood."),
    field("squared", &DerivativeJudgement::squared, "length^2/time^2",
          "The square of the true rate, negative if that is; not there if it is left out."),
    field("left_out", &DerivativeJudgement::left_out, "", "Why it is not judged.", "",
          [](const DerivativeJudgement& of) { return !of.left_out.empty(); }),
    field("kinks", &DerivativeJudgement::kinks, "",
          "Why the depth has no gradient by the poses; not there if it has one, and of unions.", "",
          [](const DerivativeJudgement& of) { return !of.kinks.empty(); }),
    field("error", &DerivativeJudgement::error, "length/time", "The claimed rate less the true one."),
    field("sentence", &DerivativeJudgement::sentence, "", "What is wrong, for people.", "",
          [](const DerivativeJudgement& of) { return !of.sentence.empty(); })};
static_assert(stored_fields(derivative_fields) == member_count<DerivativeJudgement>(),
              "each member of DerivativeJudgement has its row");
constexpr const auto& fields_of(const DerivativeJudgement*) { return derivative_fields; }

inline bool always(const Judgement&) { return true; }
inline bool has_squares(const Judgement& j) { return !j.signed_depth; }
inline std::optional<double> rounded_root(const std::optional<mpq_class>& squared) {
  return squared ? std::optional(root_binary64(*squared, Rounding::rn)) : std::nullopt;
}

/// In the order of JSON.
inline constexpr std::tuple judgement_fields{
    field("verdict", &Judgement::verdict, "", "The first of the findings, or a pass: on this answer alone."),
    field("status", &Judgement::status, "", "The truth; undecided of shapes only.", "", always),
    field("signed_depth", &Judgement::signed_depth, "length", "The truth about shapes."),
    field("depth_squared", &Judgement::depth_squared, "length^2",
          "The truth about polytopes and unions; 0 unless they penetrate.", "", has_squares),
    field("distance_squared", &Judgement::distance_squared, "length^2",
          "The truth about polytopes and unions; 0 unless they are disjoint.", "", has_squares),
    field("findings", &Judgement::findings, "", "Everything that is wrong, in order of rank."),
    field("accuracy", &Judgement::accuracy, "", "The best class of a pass with a depth or a distance."),
    field("error", &Judgement::error, "length", "The claimed depth or distance less the true one.",
          "depth or distance is off by"),
    field("error_ulps", &Judgement::error_ulps, "ulp", "The error in ulps of the true length.", "in ulps"),
    field("error_relative", &Judgement::error_relative, "ratio", "The error relative to the true length.", "relative"),
    field("error_u_r", &Judgement::error_u_r, "uR", "The error in units of roundoff times the largest coordinate.",
          "in units of uR"),
    field("separating_distance_squared", &Judgement::separating_distance_squared, "length^2",
          "Of polytopes: the squared way along the claimed direction to a plane across it; negative if the bodies are "
          "apart.",
          "depth of its direction"),
    field("exit_distance_squared", &Judgement::exit_distance_squared, "length^2",
          "Of polytopes: the squared shortest way along the claimed direction after which the interiors are disjoint.",
          "way until apart along it"),
    field("separating_distance", &Judgement::separating_distance, "length",
          "Of shapes: the way along the claimed direction to a plane across it.", "depth of its direction"),
    field("inconsistency", &Judgement::inconsistency, "length",
          "The claimed depth, or minus the claimed distance, less the separating distance; of unions, minus the "
          "overlap that is "
          "left, or the gap.",
          "claim less depth of its direction"),
    field("overlap_left", &Judgement::overlap_left, "length",
          "The overlap after the claimed translation, if there is any.", "overlap left"),
    field("witness_a_squared", &Judgement::witness_a_squared, "length^2",
          "Of polytopes and unions: the squared distance of the point of A from A.", "point of A is off by"),
    field("witness_b_squared", &Judgement::witness_b_squared, "length^2",
          "Of polytopes and unions: the squared distance of the point of B from B.", "point of B is off by"),
    field("witness_a_distance", &Judgement::witness_a_distance, "length",
          "Of shapes: the distance of the point of A from A.", "point of A is off by"),
    field("witness_b_distance", &Judgement::witness_b_distance, "length",
          "Of shapes: the distance of the point of B from B.", "point of B is off by"),
    field("witness_gap", &Judgement::witness_gap, "length",
          "The length of the points' difference less the translation; without a direction, the difference of their "
          "lengths.",
          "points differ from translation by"),
    field("contact_a_squared", &Judgement::contact_a_squared, "length^2",
          "Of polytopes and unions: the squared distance from A of the contact that is farthest from A.",
          "contacts are away from A by up to"),
    field("contact_b_squared", &Judgement::contact_b_squared, "length^2",
          "Of polytopes and unions: the squared distance from B of the contact that is farthest from B.",
          "contacts are away from B by up to"),
    field("contact_a_distance", &Judgement::contact_a_distance, "length",
          "Of shapes: the distance from A of the contact that is farthest from A.",
          "contacts are away from A by up to"),
    field("contact_b_distance", &Judgement::contact_b_distance, "length",
          "Of shapes: the distance from B of the contact that is farthest from B.",
          "contacts are away from B by up to"),
    field("deepest", &Judgement::deepest, "length", "The largest depth of a contact less the claimed depth.",
          "deepest contact less claimed depth"),
    Derived<Judgement, std::optional<double>>{
        "extent_missed", [](const Judgement& j) { return rounded_root(j.extent_missed_squared); }, "length",
        "With a slack of the patch: how far a corner of the patch with it is from "
        "the hull of the contacts, at most."},
    field("extent_missed_squared", &Judgement::extent_missed_squared, "length^2", "The square of that, exact.",
          "contacts miss the patch with slack by up to"),
    Derived<Judgement, std::optional<double>>{
        "extent_covered", [](const Judgement& j) { return rounded_root(j.extent_covered_squared); }, "ratio",
        "The share of its area, or of its length, that is in that hull; not of a "
        "point."},
    field("extent_covered_squared", &Judgement::extent_covered_squared, "ratio^2", "The square of that, exact.",
          "their hull has of it"),
    field("relative_excess", &Judgement::relative_excess, "ratio",
          "The separating distance of its direction over the depth, less 1.",
          "depth of its direction above the true depth, relative to that"),
    field("excess_allowed", &Judgement::excess_allowed, "", "It is too deep, and passes so far by the policy.", "",
          [](const Judgement& j) { return j.excess_allowed; }),
    field("deepest_pair", &Judgement::bounds, "length^2",
          "Of unions that overlap: the largest squared depth of a piece of A and a piece of B, and the first two that "
          "have it, from 0."),
    Derived<Judgement, std::optional<mpq_class>>{
        "hulls_squared", [](const Judgement& j) { return j.bounds ? std::optional(j.bounds->hulls) : std::nullopt; },
        "length^2", "The squared depth of the hulls of these unions."},
    Derived<Judgement, std::optional<double>>{
        "deeper_than_pair",
        [](const Judgement& j) {
          return j.bounds ? std::optional(root_binary64(j.depth_squared / j.bounds->deepest_pair, Rounding::rn))
                          : std::nullopt;
        },
        "ratio", "Their depth over that of the deepest pair, correctly rounded; at least 1."},
    Derived<Judgement, std::optional<double>>{
        "deeper", [](const Judgement& j) { return rounded_root(j.deeper_squared); }, "ratio",
        "Their depth over the claimed one, if that is above 0, correctly rounded."},
    field("deeper_squared", &Judgement::deeper_squared, "ratio^2", "The square of that, exact.",
          "the true depth over the claimed one"),
    field("derivative", &Judgement::derivative, "", "The claimed derivative beside the true one."),
    field("sentence", &Judgement::sentence, "", "What is wrong, for people.")};

static_assert(stored_fields(judgement_fields) == member_count<Judgement>(), "each member of Judgement has its row");
constexpr const auto& fields_of(const Judgement*) { return judgement_fields; }

// ---- contacts ----

inline constexpr std::tuple two_planes_fields{field("u", &patch::TwoPlanes::u, "", "A linear function, for B."),
                                              field("w", &patch::TwoPlanes::w, "", "A linear function, for A.")};
inline constexpr std::tuple line_overlap_fields{
    field("a", &patch::LineOverlap::a, "length", "Where A begins."),
    field("b", &patch::LineOverlap::b, "length", "Where B ends."),
    field("factor", &patch::LineOverlap::factor, "", "b - a is so many times the direction.")};
inline constexpr std::tuple missed_point_fields{
    field("direction", &MissedPoint::direction, "", "That of the patch."),
    field("point", &MissedPoint::point, "length", "A corner of it, or its centroid."),
    field("away", &MissedPoint::away, "", "A direction across it, in which no contact is so far.")};

/// In the order of JSON.
inline constexpr std::tuple contact_fault_fields{
    field("finding", &ContactFault::finding, "", "What is wrong."),
    field("contact", &ContactFault::contact, "", "Which of the reply's contacts it is about, from 0; absent of all."),
    field("planes", &ContactFault::planes, "", "The proof of a contact that is outside, or too deep."),
    field("lines", &ContactFault::lines, "", "The proof of one that is too shallow: the corners of all lines near it.",
          "", [](const ContactFault& of) { return !of.lines.empty(); }),
    field("missed", &ContactFault::missed, "", "The proof of what is wrong with all: a point of each patch.", "",
          [](const ContactFault& of) { return !of.missed.empty(); }),
    field("sentence", &ContactFault::sentence, "", "What is wrong, for people.")};
static_assert(stored_fields(contact_fault_fields) == member_count<ContactFault>(),
              "each member of ContactFault has its row");
constexpr const auto& fields_of(const patch::TwoPlanes*) { return two_planes_fields; }
constexpr const auto& fields_of(const patch::LineOverlap*) { return line_overlap_fields; }
constexpr const auto& fields_of(const MissedPoint*) { return missed_point_fields; }
constexpr const auto& fields_of(const ContactFault*) { return contact_fault_fields; }

}  // namespace fathom::judging
