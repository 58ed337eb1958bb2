// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/seen_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/numbers.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/core.hpp"
#include "reference/solve/depth.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/two_ways.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::harness {
namespace {

Body grown(const Body& body, const mpq_class& radius) {
  if (radius == 0) return body;
  Body result;
  result.dimension = body.dimension;
  result.shape = with_margin(files::shape_of(body), radius);
  return result;
}

Body used(const Body& body, const std::optional<std::vector<Triple>>& hull, long exponent) {
  if (!hull) return body;
  Body result{scaled(GivenPoints(*hull), -exponent)};
  result.dimension = body.dimension;
  return result;
}

mpq_class squared_way(const Body& from, const Body& to) {
  const auto coordinates = [](const Point& p) { return std::tie(p.x, p.y, p.z); };
  const auto less = [&](const Point& p, const Point& q) { return coordinates(p) < coordinates(q); };
  const std::set<Point, decltype(less)> there(to.points.begin(), to.points.end(), less);
  mpq_class result = 0;
  for (const Point& p : from.points)
    if (!there.contains(p)) result = std::max(result, judging::squared_distance(p, to.points.exact()));
  return result;
}

}  // namespace

bool is_flat_piece(const Body& body, std::size_t piece) {
  Body alone{pieces_of(body)[piece]};
  alone.dimension = body.dimension;
  return answer::is_flat_body(alone);
}

namespace {

class Fnv1a {
 public:
  void take(std::string_view text) {
    for (const char c : text) {
      state_ ^= static_cast<unsigned char>(c);
      state_ *= 0x100000001b3U;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Converts bodies to the form in which they are put to a subject: by name, or rounded to its
/// precision.
struct SubjectView {
  const NumberFormat& format;
  const std::set<std::string>& shapes;
  std::string& why;  ///< the reason, if a body has no such form

  /// Converts a union piece by piece; a polytope is a union of one piece.
  [[nodiscard]] std::optional<Body> see_pieces(const Body& body, const char* name) const {
    Pieces pieces = pieces_of(body);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      std::optional<Body> rounded = see(Body{GivenPoints(std::move(pieces[i]))});
      if (!rounded) return std::nullopt;
      pieces[i] = rounded->points.exact();
      rounded->dimension = body.dimension;
      if (answer::is_flat_body(*rounded))
        return nothing(fmt::format("piece {} of {} has no interior in {}, the precision of the subject", i, name,
                                   fathom::name(format.points)));
    }
    Body result{.points = {}, .pieces = std::make_shared<const Pieces>(std::move(pieces))};
    result.dimension = body.dimension;
    return result;
  }

  [[nodiscard]] std::optional<Body> see(const Body& body) const {
    if (body.shape && body.dimension == 2) return see_rounded(body);
    if (body.words) {
      const std::string word = lacking(*body.words);
      if (word.empty()) return see(*body.words);
      if (body.shape) return nothing(fmt::format("the subject does not declare \"{}\" among its shapes", word));
    }
    if (body.shape) return nothing("the subject does not take shapes without a name");
    std::optional<GivenPoints> points = seen(body.points, format);
    if (!points)
      return nothing(fmt::format("a coordinate overflows {}, the precision of the subject", name(format.points)));
    Body result{*std::move(points)};
    result.dimension = body.dimension;
    return result;
  }

 private:
  /// Of a circle, a capsule, or a polygon with a margin.
  [[nodiscard]] std::optional<Body> see_rounded(const Body& body) const {
    const std::vector<Point> core = core_of(body);
    if (core.empty()) return nothing("half-planes are not put to subjects");
    const std::string_view word = core.size() == 1 ? circle_word : core.size() == 2 ? capsule_word : margin_word;
    if (!shapes.contains(std::string(word)))
      return nothing(fmt::format("the subject does not declare \"{}\" among its shapes", word));
    const std::optional<GivenPoints> points = seen(GivenPoints(core), format);
    const std::optional<mpq_class> radius = harness::rounded(body.shape->radius, format);
    if (!points || !radius || *radius == 0)
      return nothing(fmt::format("{} is beyond {}, the precision of the subject",
                                 points ? "the radius" : "a coordinate", name(format.points)));
    Body result;
    result.dimension = 2;
    result.shape = with_margin(hull(points->exact()), *radius);
    return result;
  }

  [[nodiscard]] std::optional<Body> nothing(std::string reason) const {
    why = std::move(reason);
    return std::nullopt;
  }

  /// Returns the first name in the body's description that the subject does not declare, or "".
  [[nodiscard]] std::string lacking(const files::NamedBody& body) const {
    const std::string plain(files::named_shape(body.shape).shape->name);
    if (!shapes.contains(plain)) return plain;
    const auto margin = body.fields.numbers.find("margin");
    if (margin != body.fields.numbers.end() && margin->second.front() > 0 && !shapes.contains(margin_word))
      return margin_word;
    for (const files::NamedBody& term : body.terms)
      if (std::string word = lacking(term); !word.empty()) return word;
    return "";
  }

  [[nodiscard]] std::optional<Body> see(const files::NamedBody& words) const {
    const std::optional<files::NamedBody> rounded = harness::rounded(words, format);
    if (!rounded)
      return nothing(
          fmt::format("a number of a shape overflows {}, the precision of the subject", name(format.points)));
    try {
      return files::body_of(*rounded);
    } catch (const std::invalid_argument& error) {
      return nothing(fmt::format("rounding to {} leaves no shape: {}", name(format.points), error.what()));
    }
  }
};

/// Returns the promised fields that the answer lacks; a witness must have both points. `moves`: a
/// derivative was asked for.
std::vector<std::string> missing(const SubjectAnswer& answer, bool moves, const std::set<std::string>& promises) {
  std::vector<std::string> result;
  const auto check = [&](const char* name, bool is_there) {
    if (!is_there && promises.contains(name)) result.emplace_back(name);
  };
  const Reply& reply = std::get<Reply>(answer.said);
  if (moves) check("derivative", reply.derivative.has_value());
  if (!reply.overlap) {
    check("distance", reply.distance.has_value());
    return result;
  }
  check("depth", reply.depth.has_value());
  check("direction", reply.direction.has_value());
  check("witness", reply.witness_a && reply.witness_b);
  check("contacts", !reply.contacts.empty());
  return result;
}

/// Stops a computation if `stop`, which may be empty, returns true.
class StopWhen final : public Monitor {
 public:
  explicit StopWhen(const std::function<bool()>& stop) : stop_(stop) {}
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override { return stop_ && stop_(); }

 private:
  const std::function<bool()>& stop_;
};

/// Judges the reply by the truth about the bodies. `faults`: receives the faults of contacts; null
/// for bodies other than the given ones, whose motion is not judged either.
Judgement judged_by_truth(const Case& bodies, long exponent, const Reply& reply, const SubjectInfo& info,
                          const NumberFormat& format, const Judging& judging,
                          std::vector<judging::ContactFault>* faults) {
  StopWhen stopping(judging.stop);
  const judging::AnyTruth truth = truth_to_judge_by(bodies, info, exponent, judging, &stopping);
  const Case seen = judged_bodies(bodies, info, exponent);
  const std::optional<Motion> motion = faults ? seen.motion : std::nullopt;
  const Truth* const points = std::get_if<Truth>(&truth);
  if (!points) {
    const auto* const shapes = std::get_if<ShapeTruth>(&truth);
    if (!judging.second.empty())
      static_cast<void>(shapes ? accepted_certificate(seen.id, *shapes, &stopping)
                               : accepted_certificate(seen.id, std::get<UnionTruth>(truth), &stopping));
    return judging::judged(truth, reply, info.conventions, format, judging.tolerance, motion, &stopping);
  }
  const auto judged = [&](const Truth& by, std::vector<judging::ContactFault>* of_contacts) {
    return judging::judged(by, reply, info.conventions, format, judging.tolerance, motion, &stopping, of_contacts);
  };
  Judgement judgement = judged(*points, faults);
  for (const Solver& solver : judging.second) {
    const Case by_points{seen.id, Body{points->a}, Body{points->b}, seen.motion};  // in the plane what stands for it
    const Truth again{points->a, points->b, solver.depth(by_points, &stopping), points->dimension};
    const auto refuse = [&](const std::string& where) {
      throw Disagreement(seen, solver,
                         fmt::format("{} and {} differ: {}", name(Method::automatic), solver.name, where));
    };
    if (const auto where = solve::disagreement(points->depth, again.depth)) refuse(*where);
    if (const auto where = difference(judgement, judged(again, nullptr))) refuse(*where);
  }
  return judgement;
}

/// The reply about a pair of pieces.
struct Told {
  std::uint32_t a, b;
  SubjectAnswer answer;
  Case pair;

  [[nodiscard]] const Reply& reply() const { return std::get<Reply>(answer.said); }
};

/// Returns the depth of a reply, or minus its distance, to be compared with other replies; infinity
/// for one that is not finite, nullopt without a number.
std::optional<double> weight(const Reply& reply, const Conventions& conventions) {
  const double* const length = judging::length_of(reply);
  if (!length) return std::nullopt;
  if (!std::isfinite(*length)) return std::numeric_limits<double>::infinity();
  const bool negative = !reply.overlap || conventions.depth == Conventions::Sign::negative;
  return negative ? -*length : *length;
}

/// Returns the reply with the greatest weight, the first of several: among those that claim an
/// overlap, or among all if none does.
const Told& deepest(const std::vector<Told>& all, const Conventions& conventions) {
  const bool overlap = std::ranges::any_of(all, [](const Told& told) { return told.reply().overlap; });
  const Told* best = nullptr;
  std::optional<double> most;
  for (const Told& told : all) {
    if (told.reply().overlap != overlap) continue;
    const std::optional<double> other = weight(told.reply(), conventions);
    if (best && (!other || (most && *other <= *most))) continue;
    best = &told;
    most = other;
  }
  return *best;
}

/// Returns the derivative for the unions: the largest one in replies of the same weight as the
/// chosen reply. Returns nullopt if one of these has no derivative, or the chosen one no weight.
std::optional<double> derivative_of(const std::vector<Told>& all, const Told& chosen, const Conventions& conventions) {
  const std::optional<double> most = weight(chosen.reply(), conventions);
  std::optional<double> largest = chosen.reply().derivative;
  for (const Told& told : all) {
    if (&told == &chosen || told.reply().overlap != chosen.reply().overlap) continue;
    if (most && weight(told.reply(), conventions) != most) continue;
    const std::optional<double>& other = told.reply().derivative;
    if (!most || !other || !largest) return std::nullopt;
    if (std::isfinite(*largest) && (!std::isfinite(*other) || *other > *largest)) largest = other;
  }
  return largest;
}

bool all_have_distances(const std::vector<Told>& all) {
  return std::ranges::all_of(all, [](const Told& told) { return told.reply().distance.has_value(); });
}

std::string of_pair(std::uint32_t a, std::uint32_t b, const std::string& detail) {
  return fmt::format("piece {} of A, piece {} of B: {}", a, b, detail);
}

/// Returns the sum of the times, if each answer has one.
std::optional<double> microseconds_of(const std::vector<Told>& all) {
  double sum = 0;
  for (const Told& told : all) {
    if (!told.answer.microseconds) return std::nullopt;
    sum += *told.answer.microseconds;
  }
  return sum;
}

/// Adds a finding to the judgement if the reply lacks a field that the hello promises.
void hold_to_promises(Judgement& judgement, const SubjectAnswer& answer, bool moves,
                      const std::set<std::string>& promises) {
  const std::vector<std::string> lacking = missing(answer, moves, promises);
  if (lacking.empty()) return;
  judging::add_finding(
      judgement, Verdict::inconsistent,
      fmt::format("inconsistent: the hello promises {}, and the reply has none", fmt::join(lacking, ", ")));
}

void judge_pairs(Outcome& outcome, const Case& seen, const std::vector<Told>& all, const SubjectInfo& info,
                 const Judging& judging) {
  const Told& chosen = deepest(all, info.conventions);
  SubjectAnswer whole{{}, chosen.reply(), microseconds_of(all)};
  for (const Told& told : all)
    if (whole.remark.empty()) whole.remark = told.answer.remark;
  Reply& reply = std::get<Reply>(whole.said);
  reply.derivative = derivative_of(all, chosen, info.conventions);
  const bool bare = !reply.overlap && !all_have_distances(all);
  if (bare) reply = Reply{};
  SubjectInfo lenient = info;  // the promises are checked for each reply below
  lenient.promises.clear();
  judge_answer(outcome, seen, whole, lenient, judging);
  Outcome query = outcome_for(chosen.pair, outcome.fit);
  judge_answer(query, chosen.pair, {{}, chosen.reply()}, info, judging);
  outcome.pieces = {all.size(), {chosen.a, chosen.b}, std::move(*query.judgement)};
  for (const Told& told : all) {
    const bool is_held =
        std::ranges::find(outcome.judgement->findings, Verdict::inconsistent) != outcome.judgement->findings.end();
    if (!is_held) hold_to_promises(*outcome.judgement, told.answer, seen.motion.has_value(), info.promises);
  }
  outcome.verdict = outcome.judgement->verdict;
}

/// Returns "key[0,2]" for piece 0 of A and piece 2 of B.
std::string pair_id(const std::string& id, std::uint32_t a, std::uint32_t b) {
  return fmt::format("{}[{},{}]", id, a, b);
}

/// Returns the radii by which the subject rounds A and B, in the unit of the case. The subject gets
/// lengths times 2^exponent.
std::pair<mpq_class, mpq_class> rounding_radii(const Case& seen, const SubjectInfo& info, long exponent) {
  return {scaled(rounding_radius(seen.a, info), -exponent), scaled(rounding_radius(seen.b, info), -exponent)};
}

/// Returns whether the subject rounds pieces by a radius; then the truth about its bodies is not
/// known.
bool rounds_pieces(const SubjectInfo& info) { return rounding_radius(Body{}, info) != 0; }

/// Returns the case with the hulls that the answer reports in the place of the bodies, in the unit
/// of the case.
Case used_hulls(const Case& seen, const SubjectAnswer& answer, long exponent) {
  return {seen.id, used(seen.a, answer.hull_a, exponent), used(seen.b, answer.hull_b, exponent)};
}

}  // namespace

mpq_class rounding_radius(const Body& body, const SubjectInfo& info) {
  const std::string word = body.words ? std::string(files::named_shape(body.words->shape).shape->name) : vertices_word;
  for (const std::string& name : {word, std::string()})
    if (const auto found = info.rounding.find(name); found != info.rounding.end()) return found->second;
  return 0;
}

Case judged_bodies(const Case& seen, const SubjectInfo& info, long exponent) {
  if (info.rounding.empty() || seen.a.pieces) return seen;
  const auto [of_a, of_b] = rounding_radii(seen, info, exponent);
  return {seen.id, grown(seen.a, of_a), grown(seen.b, of_b), seen.motion};
}

judging::AnyTruth truth_to_judge_by(const Case& seen, const SubjectInfo& info, long exponent, const Judging& judging,
                                    Monitor* monitor) {
  const Case bodies = judged_bodies(seen, info, exponent);
  Options options;
  options.monitor = monitor;
  options.workspace = judging.workspace;
  judging::AnyTruth truth = judging::truth_of(bodies.a, bodies.b, options);
  if (auto* const shapes = std::get_if<ShapeTruth>(&truth))
    std::tie(shapes->added_a, shapes->added_b) = rounding_radii(seen, info, exponent);
  return truth;
}

void demand_sent_as_vertices(const Case& seen, const SubjectAnswer& answer) {
  const auto demand = [](const Body& body, bool told, const char* name) {
    if (told && body.words)
      throw ProtocolError(fmt::format("expected no \"hull.{}\": the body was sent as a shape", name));
    if (told && body.pieces)
      throw ProtocolError(fmt::format("expected no \"hull.{}\": the body was sent in pieces", name));
  };
  demand(seen.a, answer.hull_a.has_value(), "a");
  demand(seen.b, answer.hull_b.has_value(), "b");
}

mpq_class squared_way(const Case& from, const Case& to, const SubjectAnswer& answer) {
  mpq_class result = 0;
  if (answer.hull_a) result = squared_way(from.a, to.a);
  if (answer.hull_b) result = std::max(result, squared_way(from.b, to.b));
  return result;
}

std::optional<Case> as_seen(const Case& pair, const NumberFormat& format, const std::set<std::string>& shapes,
                            std::string* why, std::optional<unsigned> dimension) {
  std::string reason;
  const SubjectView view{format, shapes, why ? *why : reason};
  if (dimension && (pair.a.dimension != *dimension || pair.b.dimension != *dimension)) {
    view.why = *dimension == 2 ? "the bodies are of space, and the subject takes those of the plane alone"
                               : "the bodies are of the plane, and the subject takes those of space alone";
    return std::nullopt;
  }
  const bool of_unions = files::has_union(pair);
  std::optional<Body> a = of_unions ? view.see_pieces(pair.a, "A") : view.see(pair.a);
  if (!a) return std::nullopt;
  std::optional<Body> b = of_unions ? view.see_pieces(pair.b, "B") : view.see(pair.b);
  if (!b) return std::nullopt;
  if (shapes::is_halfspace(*a) && shapes::is_halfspace(*b)) {
    view.why = "both bodies are half-spaces, which have no depth";
    return std::nullopt;
  }
  Case seen{pair.id, *std::move(a), *std::move(b), pair.motion};
  if (seen.motion && !(seen.motion = rounded(*seen.motion, format))) {
    view.why = fmt::format("a velocity overflows {}, the precision of the subject", name(format.points));
    return std::nullopt;
  }
  return seen;
}

std::string digest_of(const Case& pair) {
  Fnv1a hash;
  for (const Body* body : {&pair.a, &pair.b}) {
    const bool in_plane = body->dimension == 2;
    if (in_plane) hash.take("plane\n");
    if (body->words) hash.take(files::body_json(*body->words, files::Defaults::written).text());
    else
      for_each_hull(*body, [&](const std::vector<Point>& points) {
        if (body->pieces) hash.take("piece\n");
        if (in_plane && body->shape) hash.take("radius " + exact_text(body->shape->radius) + '\n');
        for (const Point& p : points)
          hash.take(exact_text(p.x) + ' ' + exact_text(p.y) + (in_plane ? "" : ' ' + exact_text(p.z)) + '\n');
      });
    hash.take("\n");
  }
  if (pair.motion) hash.take(files::motion_json(*pair.motion).text());
  return fmt::format("{:016x}", hash.value());
}

long exponent_to_fit(const Case& pair, const std::optional<mpq_class>& size) {
  const auto has_no_words = [](const Body& body) { return body.shape && !body.words && body.dimension == 3; };
  if (!size || has_no_words(pair.a) || has_no_words(pair.b)) return 0;
  const mpq_class extent = sizes_of(pair).extent;
  if (extent == 0) return 0;
  const mpq_class factor = *size / extent;
  const long exponent = exponent_of(factor);
  return scaled(1, exponent) == factor ? exponent - 1 : exponent;
}

judging::Sizes sizes_of(const Case& pair) {
  if (files::has_union(pair)) return judging::sizes_of(pieces_of(pair.a), pieces_of(pair.b));
  if (!pair.a.shape && !pair.b.shape) return judging::sizes_of(pair.a.points, pair.b.points);
  return judging::sizes_of(files::shape_of(pair.a), files::shape_of(pair.b), judging::usual_bits, pair.a.dimension);
}

Outcome outcome_for(const Case& seen, long exponent) {
  Outcome outcome;
  outcome.id = seen.id;
  outcome.dimension = seen.a.dimension;
  outcome.fit = exponent;
  outcome.digest = digest_of(seen);
  return outcome;
}

Outcome declined(const Case& pair, const std::string& why) {
  Outcome outcome = outcome_for(pair);
  outcome.verdict = Verdict::unsupported;
  outcome.detail = why;
  return outcome;
}

void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info,
                  const Judging& judging) {
  if (const auto* unsupported = std::get_if<Unsupported>(&answer.said)) {
    outcome.verdict = Verdict::unsupported;
    outcome.detail = unsupported->why;
    return;
  }
  if (const auto* failed = std::get_if<Failed>(&answer.said)) {
    outcome.verdict = Verdict::failed;
    outcome.detail = failed->why;
    return;
  }
  outcome.reply = std::get<Reply>(answer.said);
  outcome.microseconds = answer.microseconds;
  const NumberFormat format = in_unit(info.format, outcome.fit);
  const auto [of_a, of_b] = rounding_radii(seen, info, outcome.fit);
  if (!files::has_union(seen)) outcome.radii = of_a + of_b;
  const auto judged = [&](const Case& asked, std::vector<judging::ContactFault>* faults = nullptr) {
    return judged_by_truth(asked, outcome.fit, *outcome.reply, info, format, judging, faults);
  };
  outcome.judgement = judged(seen, &outcome.contact_faults);
  if (answer.hull_a || answer.hull_b) {
    const Case used = used_hulls(seen, answer, outcome.fit);
    outcome.hulls = {judged(used), squared_way(seen, used, answer), squared_way(used, seen, answer)};
  }
  hold_to_promises(*outcome.judgement, answer, seen.motion.has_value(), info.promises);
  outcome.verdict = outcome.judgement->verdict;
  outcome.detail = answer.remark;
}

std::string obstacle_to(const Case& seen, const SubjectInfo& info, long exponent) {
  constexpr unsigned long fewest_numbers = 1000;  // of the format, over the length of the bodies
  if (files::has_union(seen))
    return rounds_pieces(info)
               ? "the subject rounds bodies by a radius, and the depth of unions with radii is not known"
               : "";
  const auto [of_a, of_b] = rounding_radii(seen, info, exponent);
  const mpq_class radii = of_a + of_b;
  if (radii == 0) return "";
  const mpq_class extent = sizes_of(seen).extent,
                  step = judging::ulp_at_root(radii * radii, in_unit(info.format, exponent));
  if (extent == 0 || fewest_numbers * step <= extent) return "";
  return fmt::format(
      "the subject rounds bodies by radii of {:.3g}, beside which numbers of {} do not tell bodies as long as {:.3g}",
      round_binary64(radii), name(info.format.answers), round_binary64(extent));
}

bool is_asked_in_pairs(const Case& seen, const SubjectInfo& info) {
  return files::has_union(seen) && !info.shapes.contains(pieces_word);
}

bool is_pair_of(std::string_view text, const Case& pair) {
  if (!files::has_union(pair) || !text.starts_with(pair.id + '[')) return false;
  const auto count = [](const Body& body) { return body.pieces ? body.pieces->size() : 1; };
  const char* const end = text.data() + text.size();
  std::uint32_t a = 0, b = 0;
  const auto [comma, fault] = std::from_chars(text.data() + pair.id.size() + 1, end, a);
  if (fault != std::errc() || comma == end) return false;
  if (std::from_chars(comma + 1, end, b).ec != std::errc()) return false;
  return a < count(pair.a) && b < count(pair.b) && text == pair_id(pair.id, a, b);
}

Outcome examine_pairs(const Case& seen, long exponent, const SubjectInfo& info, const Judging& judging,
                      const AskPair& ask) {
  const Pieces a = pieces_of(seen.a), b = pieces_of(seen.b);
  Outcome outcome = outcome_for(seen, exponent);
  std::vector<Told> all;
  std::string declined_why;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      Case pair{pair_id(seen.id, i, j), Body{a[i]}, Body{b[j]}, seen.motion};
      pair.a.dimension = pair.b.dimension = seen.a.dimension;
      std::optional<SubjectAnswer> answer;
      const Outcome asked = ask(pair, answer);
      outcome.seconds += asked.seconds;
      if (!answer || std::holds_alternative<Failed>(answer->said)) {
        outcome.verdict = answer ? Verdict::failed : asked.verdict;
        outcome.detail = of_pair(i, j, answer ? std::get<Failed>(answer->said).why : asked.detail);
        return outcome;
      }
      if (const auto* unsupported = std::get_if<Unsupported>(&answer->said)) {
        if (declined_why.empty()) declined_why = of_pair(i, j, unsupported->why);
        continue;
      }
      all.push_back({i, j, *std::move(answer), pair});
    }
  }
  if (!declined_why.empty()) {
    outcome.verdict = Verdict::unsupported;
    outcome.detail = declined_why;
    return outcome;
  }
  judge_pairs(outcome, seen, all, info, judging);
  return outcome;
}

}  // namespace fathom::harness
