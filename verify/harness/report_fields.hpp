// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the fields of a report's lines: name, meaning, unit, since. The lines are written
// and read by it (report_lines.cpp).
//                                            [verify/judge/fields.hpp; verdict.schema.json]
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "fathom/numbers.hpp"
#include "verify/harness/journal.hpp"
#include "verify/judge/fields.hpp"

namespace fathom::harness {

using text::Derived;
using text::field;

// ---- a subject: its hello ----

/// In the order of JSON, after type and protocol.
inline constexpr std::tuple hello_fields{
    field("name", &SubjectInfo::name, "", "Of the subject."),
    field("version", &SubjectInfo::version, "", "Of the subject."),
    field("dimension", &SubjectInfo::dimension, "", "2: it takes bodies of the plane alone. 3 if it is not there.", "",
          [](const SubjectInfo& it) { return it.dimension != 3; }),
    field("library", &SubjectInfo::library, "", "Whose calls a snippet makes.", "",
          [](const SubjectInfo& it) { return !it.library.empty(); }),
    field("precision", &SubjectInfo::format, "", "Of points and of answers."),
    field("conventions", &SubjectInfo::conventions, "", "What the numbers of its answers mean."),
    field("capabilities.faces", &SubjectInfo::wants_faces, "", "Whether cases come with the facets of hulls."),
    field("capabilities.shapes", &SubjectInfo::shapes, "", "The names that it takes bodies by.", "",
          [](const SubjectInfo& it) { return !it.shapes.empty(); }),
    field("capabilities.twist", &SubjectInfo::wants_twist, "", "Whether cases come with how the bodies begin to move.",
          "", [](const SubjectInfo& it) { return it.wants_twist; }),
    field("promises", &SubjectInfo::promises, "", "Fields that each reply holds.", "",
          [](const SubjectInfo& it) { return !it.promises.empty(); }),
    field("rounding", &SubjectInfo::rounding, "length",
          "Its own bodies are the asked ones grown by a ball of this radius.", "",
          [](const SubjectInfo& it) { return !it.rounding.empty(); }),
    Derived<SubjectInfo, const ContactLimits*>{
        "manifold", [](const SubjectInfo& it) { return it.conventions.manifold ? &*it.conventions.manifold : nullptr; },
        "", "That its contacts reach as far as the bodies touch, and their limits."},
    field("settings", &SubjectInfo::settings, "", "Shown in reports only.", "",
          [](const SubjectInfo& it) { return !it.settings.empty(); })};
static_assert(text::stored_fields(hello_fields) == text::member_count<SubjectInfo>(),
              "each member of SubjectInfo has its row");
constexpr const auto& fields_of(const SubjectInfo*) { return hello_fields; }

// ---- an outcome ----

inline double root(const mpq_class& squared) { return root_binary64(squared, Rounding::rn); }

inline constexpr std::tuple hulls_fields{
    field("query", &AboutHulls::query, "", "The reply as one about the used hulls."),
    Derived<AboutHulls, double>{"lost", [](const AboutHulls& hulls) { return root(hulls.lost_squared); }, "length",
                                "The largest distance of an asked vertex from the used hull, correctly rounded."},
    field("lost_squared", &AboutHulls::lost_squared, "length^2", "Its square."),
    Derived<AboutHulls, double>{"grown", [](const AboutHulls& hulls) { return root(hulls.grown_squared); }, "length",
                                "The largest distance of a used vertex from the asked body, correctly rounded."},
    field("grown_squared", &AboutHulls::grown_squared, "length^2", "Its square.")};
static_assert(text::stored_fields(hulls_fields) == text::member_count<AboutHulls>(),
              "each member of AboutHulls has its row");

inline constexpr std::tuple pieces_fields{field("pairs", &AboutPieces::pairs, "", "How many were put."),
                                          field("answer_of", &AboutPieces::answer_of, "", "A piece of A and one of B."),
                                          field("query", &AboutPieces::query, "", "The reply as one about these two.")};
// Not member_count, which would count both elements of answer_of.
static_assert(text::stored_fields(pieces_fields) == 3, "each member of AboutPieces has its row");

/// In the order of JSON. `dwarfed` is not written, because it follows from the radii.
inline constexpr std::tuple outcome_fields{
    field("id", &Outcome::id, "", "Of the case."),
    field("variant", &Outcome::variant, "", "The symmetry that the case was put through.", "",
          [](const Outcome& outcome) { return !outcome.variant.empty(); }),
    field("digest", &Outcome::digest, "", "Of the bodies as the subject saw them."),
    field("dimension", &Outcome::dimension, "", "2: points and directions have two coordinates. 3 if it is not there.",
          "", [](const Outcome& outcome) { return outcome.dimension != 3; }),
    field("solid", &Outcome::solid, "", "Whether both bodies have a volume; in the plane an area."),
    field("metre_sized", &Outcome::metre_sized, "",
          "Whether the longest side of each body's box is from 1/100 to 100."),
    field("verdict", &Outcome::verdict, "", "On the case."),
    field("detail", &Outcome::detail, "", "What the harness saw.", "",
          [](const Outcome& outcome) { return !outcome.detail.empty(); }),
    field("seconds", &Outcome::seconds, "s", "Until the answer."),
    field("microseconds", &Outcome::microseconds, "us", "The same as the subject measured it."),
    field("fit", &Outcome::fit, "",
          "The subject saw all lengths times 2 to this power; 0 if it is not there. All lengths here are those of the "
          "case.",
          "", [](const Outcome& outcome) { return outcome.fit != 0; }),
    field("radii", &Outcome::radii, "length",
          "The radii by which the subject rounds both bodies, in sum; not there if it rounds neither. Tolerance, class "
          "and error_relative "
          "are relative to the depth less these.",
          "", [](const Outcome& outcome) { return outcome.radii != 0; }),
    field("reply", &Outcome::reply, "",
          "The answer as it was understood, in the subject's precision; lengths in the unit of the case."),
    field("judgement", &Outcome::judgement, "", "The truth, and how far the answer is from it."),
    field("hulls", &Outcome::hulls, "",
          "The same answer by the hulls that the subject says it used; how far they are from the asked bodies."),
    field("pieces", &Outcome::pieces, "",
          "Of unions whose pairs of pieces were put to the subject: the reply is that about one of them."),
    field("contact_faults", &Outcome::contact_faults, "",
          "What is wrong with the contacts of a reply about polytopes, each with its proof.", "",
          [](const Outcome& outcome) { return !outcome.contact_faults.empty(); })};
static_assert(text::stored_fields(outcome_fields) + 1 == text::member_count<Outcome>(),
              "each member of Outcome has its row");

constexpr const auto& fields_of(const AboutHulls*) { return hulls_fields; }
constexpr const auto& fields_of(const AboutPieces*) { return pieces_fields; }
constexpr const auto& fields_of(const Outcome*) { return outcome_fields; }

inline constexpr std::tuple unattributed_fields{
    field("after", &Unattributed::after, "", "The id of the last case that the process had answered; absent if none."),
    field("detail", &Unattributed::detail, "", "What it did.")};
static_assert(text::stored_fields(unattributed_fields) == text::member_count<Unattributed>());
constexpr const auto& fields_of(const Unattributed*) { return unattributed_fields; }

// ---- the summary ----

/// The fields of Coverage, except for those that no line has: the number of cases, and answers
/// without a depth.
inline constexpr std::tuple coverage_fields{
    field("overlap", &Coverage::overlap, "", "Cases with an answer."),
    field("overlapping", &Coverage::overlapping, "", "Answers that say that the bodies overlap."),
    field("depth", &Coverage::depth, "", "Of these, those with a depth."),
    field("direction", &Coverage::direction, "", "Beside a depth."),
    field("witness", &Coverage::witness, "", "Beside a depth."),
    field("contacts", &Coverage::contacts, "", "Beside a depth."),
    field("distance", &Coverage::distance, "", "Of answers that say that the bodies are apart."),
    field("derivative", &Coverage::derivative, "", "Of all answers; not there if none was judged.", "",
          [](const Coverage& of) { return of.derivative > 0; })};
static_assert(text::stored_fields(coverage_fields) + 2 == text::member_count<Coverage>());

inline constexpr std::tuple times_fields{
    Derived<Times, std::size_t>{"answers", [](const Times& times) { return times.count(); }, "",
                                "Answers with a time."},
    Derived<Times, double>{"median", [](const Times& times) { return times.median(); }, "us",
                           "Of an even number the lower of the middle two."},
    Derived<Times, double>{"worst", [](const Times& times) { return times.worst().amount; }, "us", "The longest."},
    Derived<Times, std::string>{"worst_case", [](const Times& times) { return times.worst().id; }, "",
                                "With ~ and the name of a variant."}};

/// A maximum of lengths; Most itself has no unit.
struct Longest {
  double length;
  std::string id;
};
inline constexpr std::tuple most_fields{field("amount", &Most::amount, "", "The largest of several."),
                                        field("case", &Most::id, "", "The case where it is.")};
inline constexpr std::tuple longest_fields{field("length", &Longest::length, "length", "The largest of several."),
                                           field("case", &Longest::id, "", "The case where it is.")};

inline constexpr std::tuple hull_count_fields{
    field("answers", &HullCount::count, "", "That told the hulls that they are about."),
    field("query_passed", &HullCount::passed, "", "By these hulls."),
    Derived<HullCount, Longest>{"lost",
                                [](const HullCount& hulls) {
                                  return Longest{hulls.lost.amount, hulls.lost.id};
                                },
                                "", "See that of a case."},
    Derived<HullCount, Longest>{"grown",
                                [](const HullCount& hulls) {
                                  return Longest{hulls.grown.amount, hulls.grown.id};
                                },
                                "", "See that of a case."}};

inline constexpr std::tuple union_count_fields{
    field("overlapping", &UnionCount::count, "", "Judged answers about unions that overlap."),
    field("pair_enough", &UnionCount::enough, "", "The deepest pair of pieces is exactly as deep."),
    field("answers", &UnionCount::answers, "", "That have a depth above 0."),
    field("deeper", &UnionCount::deeper, "", "Of these: the unions are deeper by more than is allowed."),
    field("times", &UnionCount::times, "ratio", "Of those: the depth over the answer.", "",
          [](const UnionCount& unions) { return !unions.times.id.empty(); }),
    field("by", &UnionCount::by, "length", "Of those: the depth less the answer.", "",
          [](const UnionCount& unions) { return !unions.by.id.empty(); })};
static_assert(text::stored_fields(union_count_fields) == text::member_count<UnionCount>());

/// The relative excess of the separating distances of a row over the depths.
struct RelativeExcess {
  const TallyRow* row;
};
inline constexpr std::tuple relative_excess_fields{
    Derived<RelativeExcess, std::size_t>{"answers",
                                         [](const RelativeExcess& it) { return it.row->relative_excess.size(); }, "",
                                         "With a direction that has a separating distance."},
    Derived<RelativeExcess, double>{"median", [](const RelativeExcess& it) { return it.row->relative_excess.median(); },
                                    "ratio", "Of the excesses."},
    Derived<RelativeExcess, double>{"worst", [](const RelativeExcess& it) { return it.row->relative_excess.worst(); },
                                    "ratio", "The largest of them."},
    Derived<RelativeExcess, std::size_t>{"excess_allowed",
                                         [](const RelativeExcess& it) { return it.row->excess_allowed; }, "",
                                         "Translations that are too deep, and pass by the policy."}};

inline constexpr std::tuple part_fields{
    field("cases", &TallyRow::total, "", "That belong to it."),
    Derived<TallyRow, std::size_t>{"passed", [](const TallyRow& row) { return row.passes(); }, "", "Of them."},
    Derived<TallyRow, std::size_t>{"failed", [](const TallyRow& row) { return row.failures(); }, "", "Of them."},
    Derived<TallyRow, std::size_t>{"unsupported", [](const TallyRow& row) { return row[Verdict::unsupported]; }, "",
                                   "Of them."},
    field("verdicts", &TallyRow::verdicts, "", "How many have each verdict that occurs.")};

inline constexpr std::tuple totals_fields{
    field("cases", &Totals::cases, "", "That were met."),
    field("passed", &Totals::passed, "", "Of the cases."),
    field("failed", &Totals::failed, "", "Of the cases."),
    field("unsupported", &Totals::unsupported, "", "Cases that the subject declined."),
    field("unattributed", &Totals::unattributed, "", "What was no case's fault."),
    field("judged", &Totals::judged, "", "How many answers held each field and were judged by it."),
    Derived<Totals, const Times*>{"microseconds",
                                  [](const Totals& it) { return it.times && !it.times->empty() ? it.times : nullptr; },
                                  "us", "What the subject measured, if it did."},
    Derived<Totals, const HullCount*>{
        "hulls", [](const Totals& it) { return it.hulls && it.hulls->count > 0 ? it.hulls : nullptr; }, "",
        "Of answers that told the hulls that they are about."},
    Derived<Totals, const UnionCount*>{
        "unions", [](const Totals& it) { return it.unions && it.unions->count > 0 ? it.unions : nullptr; }, "",
        "Of judged answers about unions that overlap."},
    Derived<Totals, std::optional<RelativeExcess>>{
        "relative_excess",
        [](const Totals& it) {
          return it.all && !it.all->relative_excess.empty() ? std::optional(RelativeExcess{it.all}) : std::nullopt;
        },
        "", "The excess of directions' separating distances over the depths, relative to these."},
    field("parts", &Totals::parts, "", "Of the cases that belong to each.", "",
          [](const Totals& it) { return !it.parts.empty(); })};
// Members that are pointers yield the values that they point to.
static_assert(std::tuple_size_v<decltype(totals_fields)> == text::member_count<Totals>(),
              "each member of Totals has its row");

constexpr const auto& fields_of(const Coverage*) { return coverage_fields; }
constexpr const auto& fields_of(const Times*) { return times_fields; }
constexpr const auto& fields_of(const Most*) { return most_fields; }
constexpr const auto& fields_of(const Longest*) { return longest_fields; }
constexpr const auto& fields_of(const HullCount*) { return hull_count_fields; }
constexpr const auto& fields_of(const UnionCount*) { return union_count_fields; }
constexpr const auto& fields_of(const RelativeExcess*) { return relative_excess_fields; }
constexpr const auto& fields_of(const TallyRow*) { return part_fields; }
constexpr const auto& fields_of(const Totals*) { return totals_fields; }

}  // namespace fathom::harness
