// SPDX-License-Identifier: GPL-3.0-or-later
// The part of answer_output.hpp that writes text for people, and says what of an answer JSON is to
// show. The rows of each kind of bodies stand together, in the order of the page.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "cli/output/answer_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/number/irrational.hpp"

namespace fathom::cli {
namespace {

using Rows = std::vector<Row>;

/// A length by its square: in decimals, exactly if that is asked for, enclosed if digits are.
void add_squared(Rows& rows, const std::string& what, const mpq_class& squared, const AnswerForm& form,
                 bool enclosed = true) {
  rows.emplace_back(what, root_text(squared));
  if (form.exact) rows.emplace_back(what + "^2", exact_text(squared));
  if (form.digits && enclosed) rows.emplace_back("enclosure", enclosure_text(squared, *form.digits));
}

// ---- polytopes ----

/// A pair of planes is found from both of its sides.
std::size_t ties(const Depth& depth, const AnswerForm& form) {
  return form.width ? depth.optima_count() / 2 : depth.optima_count();
}

std::string ties_text(const Depth& depth, const AnswerForm& form) {
  const std::size_t count = ties(depth, form);
  const std::string_view many = form.width ? "pairs of planes" : "nearest facets";
  return count == 1 ? "none" : fmt::format("{} {}; the first is shown, --json lists all", count, many);
}

void add_answer(Rows& rows, const Depth& depth, const AnswerForm& form) {
  add_squared(rows, quantity(form), depth.squared(), form, !depth.distance());
  if (const Distance* const distance = depth.distance()) {
    add_squared(rows, "distance", distance->squared, form);
    add_points(rows, "nearest", place_text(distance->witness.a, form.exact),
               place_text(distance->witness.b, form.exact));
    rows.emplace_back("A to B", place_text(distance->translation, form.exact));
  }
  rows.emplace_back("direction", way_text(depth.direction(), form.exact));
  if (depth.status() == Status::penetrating && !form.width)
    rows.emplace_back("translation", place_text(depth.translation(), form.exact));
  if (depth.contact()) rows.emplace_back("contact", contact_text(*depth.contact(), form.width));
  if (const std::optional<Witness> witness = depth.witness()) add_witness(rows, *witness, form);
  if (!depth.optima().empty()) rows.emplace_back("ties", ties_text(depth, form));
}

// Which method answered, and why if it is not the one that was tried first.
std::string method_text(const Depth& depth, const AnswerForm& form) {
  const std::string ran(output::method_name(depth));
  if (depth.method == Method::certificate)
    return fmt::format("{}: an inner polytope of {} facets", ran, depth.counters.inner_facets);
  if (form.by_default) return ran + ": the inner polytope took too many points";
  return ran;
}

void add_method(Rows& rows, const Depth& depth, const AnswerForm& form) {
  if (depth.status() == Status::penetrating) rows.emplace_back("method", method_text(depth, form));
}

/// The parts of a line.
void add_parts(std::vector<std::string>& parts, const Depth& depth, const AnswerForm& form) {
  parts.push_back(quantity(form) + " " + root_text(depth.squared()));
  if (depth.status() == Status::penetrating) {
    if (form.exact) parts.push_back(quantity(form) + "^2 " + exact_text(depth.squared()));
    if (form.digits) parts.push_back("in " + enclosure_text(depth.squared(), *form.digits));
  }
  if (depth.distance()) parts.push_back("distance " + root_text(depth.distance()->squared));
  parts.push_back("direction " + way_text(depth.direction(), form.exact));
  if (depth.contact()) parts.emplace_back(name(depth.contact()->kind));
  if (const std::size_t count = ties(depth, form); count > 1) parts.push_back(fmt::format("{} ties", count));
  if (const std::string flat = flat_text(depth, form.width); !flat.empty()) parts.push_back("flat " + flat);
}

// ---- shapes ----

/// The overlapping cores' optima, which are those of the bodies; null in all other cases.
const Penetration* of_cores(const SignedDepth& depth) {
  const Depth* const cores = std::get_if<Depth>(&depth.core);
  return cores ? cores->penetration() : nullptr;
}

/// 0 <= low < high, rounded outward to that many digits.
Enclosure enclosure_of(const Bounds& bounds, unsigned digits) {
  return {enclose(Surd{bounds.low, 0}, digits).low, enclose(Surd{bounds.high, 0}, digits).high};
}

std::string value_text(const SignedDepth& depth, int sign_of_it) {
  if (const Surd* const exactly = depth.exact()) return surd_text(sign_of_it > 0 ? *exactly : negated(*exactly));
  const double low = depth.low_binary64(), high = depth.high_binary64();
  return sign_of_it > 0 ? fmt::format("from {} to {}", low, high) : fmt::format("from {} to {}", -high, -low);
}

std::string cone_text(const OptimalCone& cone, bool exact) {
  std::vector<std::string> parts;
  if (cone.lineality == Lineality::all) parts.emplace_back("every direction");
  if (cone.lineality == Lineality::plane) parts.push_back("the plane orthogonal to " + way_text(cone.axis, exact));
  if (cone.lineality == Lineality::line) parts.push_back("the line of " + way_text(cone.axis, exact));
  for (const Vector& ray : cone.rays) parts.push_back(way_text(ray, exact));
  return fmt::format("the cone of {}", fmt::join(parts, ", "));
}

std::string undecided_text(const SignedDepth& depth) {
  return fmt::format("from {} to {}: deep if positive, apart if negative", depth.low_binary64(), depth.high_binary64());
}

void add_length(std::vector<Row>& rows, const SignedDepth& depth, const AnswerForm& form) {
  const std::optional<Status> status = depth.status();
  if (!status) {
    rows.emplace_back("signed depth", undecided_text(depth));
    return;
  }
  const bool apart = status == Status::disjoint;
  rows.emplace_back(quantity(form), apart || status == Status::touching ? "0" : value_text(depth, 1));
  if (apart) rows.emplace_back("distance", value_text(depth, -1));
  if (const Surd* const exactly = depth.exact()) {
    const Surd length = apart ? negated(*exactly) : *exactly;
    if (form.exact) rows.emplace_back("exactly", kernels::exact_surd_text(length));
    if (form.digits) {
      const Enclosure enclosure = enclose(length, *form.digits);
      rows.emplace_back("enclosure", fmt::format("[{}, {}]", enclosure.low, enclosure.high));
    }
  } else if (form.digits) {
    const Bounds& bounds = *depth.bounds();
    const Enclosure enclosure = enclosure_of(apart ? Bounds{-bounds.high, -bounds.low} : bounds, *form.digits);
    rows.emplace_back("enclosure", fmt::format("[{}, {}]", enclosure.low, enclosure.high));
  }
}

void add_places(std::vector<Row>& rows, const SignedDepth& depth, const AnswerForm& form) {
  const bool same_body = form.width;
  const std::vector<AlongNormal> translations = depth.translations();
  const bool apart = depth.status() == Status::disjoint;
  rows.emplace_back("direction", way_text(depth.direction(), form.exact));
  if (!translations.empty() && depth.status() != Status::touching && !same_body)
    rows.emplace_back(apart ? "A to B" : "translation", place_text(translations.front(), form.exact));
  if (depth.contact()) rows.emplace_back("contact", contact_text(*depth.contact(), same_body));
  if (const std::optional<RoundedWitness> witness = depth.witness())
    add_points(rows, apart ? "nearest" : "witness", place_text(witness->a, form.exact),
               place_text(witness->b, form.exact), same_body);
  if (has_continuum(depth)) rows.emplace_back("ties", cone_text(*depth.cone, form.exact));
  if (const Penetration* const cores = of_cores(depth); cores && cores->optima.size() > (same_body ? 2 : 1))
    rows.emplace_back(
        "ties", fmt::format("{} {}; the first is shown, --json lists all", cores->optima.size() / (same_body ? 2 : 1),
                            same_body ? "pairs of planes" : "nearest facets"));
}

void add_answer(Rows& rows, const SignedDepth& depth, const AnswerForm& form) {
  add_length(rows, depth, form);
  add_places(rows, depth, form);
}

void add_method(Rows& rows, const SignedDepth& depth, const AnswerForm&) {
  rows.emplace_back("method", output::method_name(depth));
}

void add_parts(std::vector<std::string>& parts, const SignedDepth& depth, const AnswerForm& form) {
  Rows rows;
  add_length(rows, depth, form);
  rows.emplace_back("direction", way_text(depth.direction(), form.exact));
  for (const auto& [label, text] : rows) parts.push_back(label + " " + text);
}

// ---- polytopes and shapes ----

template <class Found>
std::string pair_block(const AnsweredCase& answered, const Found& found, const AnswerForm& form) {
  Rows rows;
  add_answer(rows, found, form);
  add_bodies(rows, answered.bodies);
  add_method(rows, found, form);
  const BodyFacts& facts = answered.facts;
  if (const std::string flat = flat_text(facts, form.width); !flat.empty()) rows.emplace_back("flat", flat);
  if (std::is_same_v<Found, Depth> && facts.flat_a && found.status() == Status::penetrating)
    rows.push_back(flat_note());
  if (form.counters) add_counters(rows, output::counters_of(found));
  return aligned(form.width ? "" : std::string(answered.answer.status_name()), rows);
}

template <class Found>
std::string pair_line(const AnsweredCase& answered, const Found& found, const AnswerForm& form) {
  std::vector<std::string> parts;
  if (!form.width) parts.emplace_back(answered.answer.status_name());
  add_parts(parts, found, form);
  Rows rows;
  if (form.counters) add_counters(rows, output::counters_of(found));
  for (const auto& [label, text] : rows) parts.push_back(label + " " + text);
  return case_line(answered.id, parts);
}

// ---- unions ----

constexpr std::size_t most_contacts = 8;  // that text lists

void add_contacts(std::vector<Row>& rows, const std::vector<PieceContact>& contacts) {
  for (std::size_t i = 0; i < contacts.size() && i < most_contacts; ++i) {
    const PieceContact& c = contacts[i];
    rows.emplace_back(i == 0 ? "touching" : "",
                      fmt::format("piece {} of A, piece {} of B; {}", c.a, c.b, contact_text(c.contact)));
  }
  if (contacts.size() > most_contacts)
    rows.emplace_back("", fmt::format("and {} more pairs", contacts.size() - most_contacts));
}

void add_optimum(std::vector<Row>& rows, const UnionDepth& depth, const AnswerForm& form) {
  if (depth.optima.empty()) return;
  const UnionOptimum& first = depth.optima.front();
  if (depth.status == Status::penetrating) rows.emplace_back("translation", place_text(first.translation, form.exact));
  rows.emplace_back("clearance", first.clearance ? "yes" : "none: an exact fit");
  add_contacts(rows, first.contacts);
  const std::size_t count = depth.optima.size();
  if (depth.status == Status::penetrating && depth.complete)
    rows.emplace_back(
        "ties", count == 1 ? "none" : fmt::format("{} translations; the first is shown, --json lists all", count));
}

std::string counted(const UnionCounters& c) {
  return fmt::format("{} cells split, {} nearest points, {} of {} pairs of pieces looked at", c.nodes, c.nearest_points,
                     c.pairs_touched, c.pairs);
}

std::string union_block(const AnsweredCase& answered, const UnionDepth& depth, const AnswerForm& form) {
  std::vector<Row> rows;
  if (depth.complete) {
    add_squared(rows, "depth", depth.low, form);
  } else {
    add_squared(rows, "at least", depth.low, form);
    add_squared(rows, "at most", depth.high, form);
  }
  if (depth.apart) {
    add_squared(rows, "distance", depth.apart->distance.squared, form);
    rows.emplace_back("between", fmt::format("piece {} of A, piece {} of B", depth.apart->a, depth.apart->b));
    rows.emplace_back("A to B", place_text(depth.apart->distance.translation, form.exact));
  }
  add_optimum(rows, depth, form);
  if (depth.bounds && depth.status == Status::penetrating) {
    rows.emplace_back("deepest pair",
                      fmt::format("{}: piece {} of A, piece {} of B", root_text(depth.bounds->deepest_pair),
                                  depth.bounds->a, depth.bounds->b));
    rows.emplace_back("hulls", root_text(depth.bounds->hulls));
  }
  add_hull(rows, answered.bodies.hull);
  if (form.counters) rows.emplace_back("counted", counted(depth.counters));
  return aligned(depth.complete ? std::string(name(depth.status)) : "interrupted", rows);
}

std::string union_line(const AnsweredCase& answered, const UnionDepth& depth, const AnswerForm& form) {
  if (!depth.complete)
    return case_line(answered.id,
                     {"interrupted", "depth at least " + root_text(depth.low), "at most " + root_text(depth.high)});
  std::vector<std::string> parts{std::string(name(depth.status)), "depth " + root_text(depth.squared())};
  if (depth.status == Status::penetrating) {
    if (form.exact) parts.push_back("depth^2 " + exact_text(depth.squared()));
    if (form.digits) parts.push_back("in " + enclosure_text(depth.squared(), *form.digits));
    parts.push_back("translation " + place_text(depth.optima.front().translation, form.exact));
    if (!depth.optima.front().clearance) parts.emplace_back("an exact fit");
    if (depth.optima.size() > 1) parts.push_back(fmt::format("{} ties", depth.optima.size()));
    parts.push_back("deepest pair " + root_text(depth.bounds->deepest_pair));
  }
  if (depth.apart) parts.push_back("distance " + root_text(depth.apart->distance.squared));
  if (form.counters) parts.push_back("counted " + counted(depth.counters));
  return case_line(answered.id, parts);
}

}  // namespace

// Of the stages that ran: what another method would have counted is no 0.
void add_counters(std::vector<Row>& rows, const Counters& counters) {
  std::vector<std::string_view> stages;
  std::vector<Row> counts;
  for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
    if (!stage.ran()) continue;
    stages.push_back(stage.stage);
    for (const kernels::Count& count : stage.counts) counts.emplace_back(count.name, fmt::format("{}", count.value));
  }
  rows.emplace_back("counted", fmt::format("{}", fmt::join(stages, ", ")));
  rows.insert(rows.end(), counts.begin(), counts.end());
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    if (tiers.calls == 0) continue;
    rows.emplace_back(predicate_names[i],
                      fmt::format("{} calls, {} exact, {} zero", tiers.calls, tiers.exact, tiers.zero));
  }
}

bool has_continuum(const SignedDepth& depth) {
  return depth.cone && (depth.cone->lineality != Lineality::none || depth.cone->rays.size() > 1);
}

std::string shape_length_text(const SignedDepth& depth) {
  const std::optional<Status> status = depth.status();
  if (!status) return "undecided: signed depth " + undecided_text(depth);
  if (status == Status::touching) return "touching: depth 0";
  return status == Status::disjoint ? "disjoint: distance " + value_text(depth, -1)
                                    : "penetrating: depth " + value_text(depth, 1);
}

std::string answer_block(const AnsweredCase& answered, const AnswerForm& form) {
  if (const UnionDepth* const unions = std::get_if<UnionDepth>(&answered.answer.found))
    return union_block(answered, *unions, form);
  if (const Depth* const depth = std::get_if<Depth>(&answered.answer.found)) return pair_block(answered, *depth, form);
  return pair_block(answered, std::get<SignedDepth>(answered.answer.found), form);
}

std::string answer_line(const AnsweredCase& answered, const AnswerForm& form) {
  if (const UnionDepth* const unions = std::get_if<UnionDepth>(&answered.answer.found))
    return union_line(answered, *unions, form);
  if (const Depth* const depth = std::get_if<Depth>(&answered.answer.found)) return pair_line(answered, *depth, form);
  return pair_line(answered, std::get<SignedDepth>(answered.answer.found), form);
}

}  // namespace fathom::cli
