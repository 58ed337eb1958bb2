// SPDX-License-Identifier: GPL-3.0-or-later
// One failure of the page: pictures, the truth, the claim, and exact numbers.
#include <fmt/format.h>

#include <exception>

#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "reference/files/cases.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/report/reports.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/fields.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/scene.hpp"
#include "view/picture/view.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t longest_inline = 60;     // characters of an exact number to be shown beside its rounded one
constexpr std::size_t longest_exact = 10'000;  // characters of a number in the list of exact numbers
constexpr std::size_t longest_case = 200'000;  // characters of a case as JSON

std::string exact(const mpq_class& value) {
  const std::string text = exact_text(value);
  return text.size() <= longest_exact
             ? text
             : fmt::format("{}... ({} characters)", text.substr(0, longest_exact), text.size());
}

/// Returns the root of a signed square: rounded, with the exact square if that is short.
std::string length_text(const mpq_class& squared) {
  const std::string text = exact_text(squared);
  const std::string behind = text.size() <= longest_inline ? fmt::format(" (squared: {})", text) : "";
  return fmt::format("{}{}{}", squared < 0 ? "-" : "", root_binary64(mpq_class(abs(squared)), Rounding::rn), behind);
}

std::string place_text(const Triple& p, unsigned dimension) {
  return dimension == 2 ? fmt::format("({}, {})", p[0], p[1]) : fmt::format("({}, {}, {})", p[0], p[1], p[2]);
}

std::string rounded_text(const Point& p, unsigned dimension) {
  return place_text(
      {round_binary64(p.x, Rounding::rn), round_binary64(p.y, Rounding::rn), round_binary64(p.z, Rounding::rn)},
      dimension);
}

std::string between_text(const Between& x) {
  return x.low == x.high ? fmt::format("{}", x.low) : fmt::format("between {} and {}", x.low, x.high);
}

/// Rows of a <dl>.
class Facts {
 public:
  void add(const std::string& what, const std::string& text) {
    rows_ += fmt::format("<dt>{}</dt><dd class=\"number\">{}</dd>", what, markup(text));
  }
  template <class T, class Text>
  void add(const std::string& what, const std::optional<T>& value, const Text& text) {
    if (value) add(what, text(*value));
  }
  void add(const std::string& what, const std::optional<double>& value) {
    if (value) add(what, fmt::format("{}", *value));
  }
  [[nodiscard]] std::string list(const std::string& title) const {
    return rows_.empty() ? "" : fmt::format("<div><strong>{}</strong><dl>{}</dl></div>\n", title, rows_);
  }

 private:
  std::string rows_;
};

std::string status_text(const std::optional<Status>& status) {
  return !status                         ? "the bounds leave it open"
         : status == Status::penetrating ? "the bodies overlap"
         : status == Status::touching    ? "the bodies touch"
                                         : "the bodies are apart";
}

/// The exact answer about a pair; nullopt if it was not found.
using Known = std::optional<Answer>;

const Depth* polytopes(const Known& known) { return known ? std::get_if<Depth>(&known->found) : nullptr; }
const UnionDepth* unions(const Known& known) { return known ? std::get_if<UnionDepth>(&known->found) : nullptr; }

std::string truth_of_unions(const UnionDepth& depth, unsigned dimension, const std::string& certificate) {
  Facts facts;
  facts.add("status", status_text(depth.status));
  if (depth.status == Status::penetrating) facts.add("depth", length_text(depth.squared()));
  if (depth.apart) facts.add("distance", length_text(depth.apart->distance.squared));
  if (depth.status == Status::penetrating) {
    facts.add("translation of A", rounded_text(depth.optima.front().translation, dimension));
    if (depth.optima.size() > 1) facts.add("ties", fmt::format("{} translations are as short", depth.optima.size()));
    if (!depth.optima.front().clearance) facts.add("clearance", "none: an exact fit");
    const UnionBounds& bounds = *depth.bounds;
    facts.add("depth of the deepest pair",
              fmt::format("{}: piece {} of A, piece {} of B", length_text(bounds.deepest_pair), bounds.a, bounds.b));
    if (bounds.deepest_pair != depth.squared())
      facts.add("the unions are deeper",
                fmt::format("{} times", root_binary64(depth.squared() / bounds.deepest_pair, Rounding::rn)));
    facts.add("depth of the hulls", length_text(bounds.hulls));
  }
  if (!certificate.empty()) facts.add("certificate", certificate);
  return facts.list("Truth");
}

std::string truth_list(const Outcome& outcome, const Known& known, const std::string& certificate) {
  if (const UnionDepth* const depth = unions(known)) return truth_of_unions(*depth, outcome.dimension, certificate);
  const Depth* const truth = polytopes(known);
  Facts facts;
  if (outcome.judgement || truth) {
    const std::optional<Status> status = outcome.judgement ? outcome.judgement->status : truth->status();
    facts.add("status", status_text(status));
    if (outcome.judgement && outcome.judgement->signed_depth)
      facts.add("signed depth", between_text(*outcome.judgement->signed_depth));
    else if (status == Status::penetrating)
      facts.add("depth", length_text(outcome.judgement ? outcome.judgement->depth_squared : truth->squared()));
  }
  if (truth && truth->distance()) facts.add("distance", length_text(truth->distance()->squared));
  if (truth && truth->status() == Status::penetrating) {
    facts.add("translation of A", rounded_text(truth->translation(), outcome.dimension));
    if (truth->optima().size() > 1)
      facts.add("ties", fmt::format("{} translations are as short", truth->optima().size()));
  }
  if (!certificate.empty()) facts.add("certificate", certificate);
  return facts.list("Truth");
}

/// Returns the subject's own numbers, each with the convention that it follows.
std::string claim_list(const Reply& reply, const Conventions& conventions, unsigned dimension) {
  const auto point_text = [dimension](const Triple& p) { return place_text(p, dimension); };
  Facts facts;
  facts.add("status", reply.overlap ? "the bodies overlap" : "the bodies do not overlap");
  facts.add(conventions.depth == Conventions::Sign::positive ? "depth" : "depth, negative where they overlap",
            reply.depth);
  facts.add("distance", reply.distance);
  facts.add(fmt::format("direction in which {} moves", moving_body(conventions)), reply.direction, point_text);
  facts.add("point of A", reply.witness_a, point_text);
  facts.add("point of B", reply.witness_b, point_text);
  for (const ContactPoint& contact : reply.contacts) {
    facts.add("contact", std::optional(contact.position), point_text);
    facts.add("depth there", contact.depth);
  }
  return facts.list("Claim");
}

/// Returns a ratio, given by its square.
std::string times_text(const mpq_class& squared) {
  const std::string text = exact_text(squared);
  return fmt::format("{} times{}", root_binary64(squared, Rounding::rn),
                     text.size() <= longest_inline ? fmt::format(" (squared: {})", text) : "");
}

// These functions return the text of a field, which must be set.
std::string number_text(const std::optional<double>& value, std::string_view) { return fmt::format("{}", *value); }
std::string number_text(const std::optional<Between>& value, std::string_view) { return between_text(*value); }
std::string number_text(const std::optional<mpq_class>& squared, std::string_view unit) {
  return unit == "ratio^2" ? times_text(*squared) : length_text(*squared);
}

std::string residual_list(const Judgement& judgement) {
  Facts facts;
  std::string findings;
  for (const Verdict verdict : judgement.findings)
    findings += fmt::format("{}{}", findings.empty() ? "" : ", ", name(verdict));
  if (judgement.findings.size() > 1) facts.add("all that is wrong", findings);
  const bool has_separating_distance =
      judgement.separating_distance_squared || judgement.separating_distance;  // the judgement of unions has neither
  text::for_each_field(judging::judgement_fields, [&](const auto& field) {
    if constexpr (requires { field.label, number_text(judgement.*field.member, field.unit); }) {
      if (field.label.empty()) return;
      const bool is_of_unions = field.name == "inconsistency" && !has_separating_distance;
      const std::string label(is_of_unions ? "gap after its translation, or minus the overlap" : field.label);
      if (const auto& value = judgement.*field.member) facts.add(label, number_text(value, field.unit));
    }
  });
  return facts.list("Residuals");
}

std::string hulls_list(const AboutHulls& hulls) {
  Facts facts;
  facts.add("the same answer about them", std::string(name(hulls.query.verdict)) + ": " + hulls.query.sentence);
  facts.add("asked vertices are away from them by", length_text(hulls.lost_squared));
  facts.add("their vertices are away from the bodies by", length_text(hulls.grown_squared));
  return facts.list("Hulls that it used");
}

std::string pieces_list(const AboutPieces& pieces) {
  Facts facts;
  facts.add("asked", fmt::format("{} pairs", pieces.pairs));
  facts.add("the answer is that about",
            fmt::format("piece {} of A, piece {} of B", pieces.answer_of[0], pieces.answer_of[1]));
  facts.add("the same answer about these two", std::string(name(pieces.query.verdict)) + ": " + pieces.query.sentence);
  return facts.list("Pairs of pieces");
}

std::string contacts_list(const std::vector<judging::ContactFault>& faults) {
  Facts facts;
  for (const judging::ContactFault& fault : faults) facts.add(std::string(name(fault.finding)), fault.sentence);
  return facts.list("Contacts");
}

std::string derivative_list(const DerivativeJudgement& derivative) {
  Facts facts;
  facts.add("claimed", derivative.claimed);
  facts.add("true", derivative.squared, length_text);
  if (!derivative.left_out.empty()) facts.add("not judged", derivative.left_out);
  if (!derivative.kinks.empty()) facts.add("no gradient", fmt::format("{}", fmt::join(derivative.kinks, ", ")));
  return facts.list("Derivative of the signed depth");
}

/// Returns the case as it was put to the subject, to be copied into a file; or a sentence if it is
/// too long for a page, or cannot be written.
std::string case_text(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor) {
  const Case& seen = failure.seen;
  if (seen.a.points.empty() && !seen.a.shape && !files::has_union(seen)) return "";
  try {
    const std::string line = files::case_json(
        seen, fmt::format("{} of {} {}", name(failure.outcome.verdict), subject.name, subject.version));
    if (line.size() < longest_case)
      return picture::copied_text(anchor + "-case", "copy this case", "The case, as the subject saw it", line);
    std::size_t points = 0;
    for (const Body* body : {&seen.a, &seen.b})
      for_each_hull(*body, [&](const std::vector<Point>& hull) { points += hull.size(); });
    return fmt::format("<p class=\"soft\">The case has {} points and is not on this page.</p>\n", points);
  } catch (const std::invalid_argument&) {
    return "";
  }
}

/// Returns lines with the exact numbers behind the rounded ones: all of the judgement by their
/// names in the report, "depth^2" for "depth_squared".
std::string exact_numbers(const Outcome& outcome, const Known& known) {
  std::string result;
  const auto add = [&](std::string_view what, const mpq_class& value) {
    const std::string_view squared = "_squared";
    const bool is_square = what.ends_with(squared);
    result += fmt::format("{}{} = {}\n", what.substr(0, what.size() - (is_square ? squared.size() : 0)),
                          is_square ? "^2" : "", exact(value));
  };
  const Depth* const truth = polytopes(known);
  const UnionDepth* const of_unions = unions(known);
  const bool overlapping_unions = of_unions && of_unions->status == Status::penetrating;
  if (outcome.judgement) {
    const Judgement& judgement = *outcome.judgement;
    text::for_each_field(judging::judgement_fields, [&](const auto& field) {
      if (!text::has(field, judgement)) return;
      const auto& value = text::value_of(field, judgement);
      using Value = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, mpq_class>) add(field.name, value);
      if constexpr (std::is_same_v<Value, std::optional<mpq_class>>) add(field.name, *value);
      if constexpr (std::is_same_v<Value, std::optional<UnionBounds>>) add("deepest_pair_squared", value->deepest_pair);
    });
  } else if (truth) {
    add("depth_squared", truth->squared());
    if (truth->distance()) add("distance_squared", truth->distance()->squared);
  } else if (overlapping_unions) {
    add("deepest_pair_squared", of_unions->bounds->deepest_pair);
  }
  const auto add_translation = [&](const Point& t) {
    result += fmt::format("translation of A = ({}, {}{})\n", exact(t.x), exact(t.y),
                          outcome.dimension == 2 ? "" : ", " + exact(t.z));
  };
  if (overlapping_unions)
    for (const UnionOptimum& optimum : of_unions->optima) add_translation(optimum.translation);
  if (truth)
    for (const Optimum& optimum : truth->optima()) add_translation(optimum.translation());
  return result;
}

/// Solves the pair again. Returns nullopt if that fails: a missing picture must not prevent the
/// page.
Known known_of(const Case& seen) {
  try {
    return exact_answer(seen.a, seen.b);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// Returns the words for the claim in a picture.
std::string of_claim(const SubjectInfo& subject) {
  const std::string result = "; <span class=\"key claimed\">dashed arrow</span>: the translation of A that is claimed";
  return subject.conventions.moves == Conventions::Body::b
             ? result + ", which is that of B turned round: the subject moves B"
             : result;
}

/// Returns the caption of a picture.
std::string caption(const SubjectInfo& subject, const picture::PairScene& scene, const Answer& answer) {
  std::string result = "<span class=\"key body-a\">A</span> toned, <span class=\"key body-b\">B</span> hatched";
  const bool of_polytopes = std::holds_alternative<Depth>(answer.found);
  if (of_polytopes && scene.has_edges()) result += ", hidden edges dashed";
  if (scene.of_unions()) result += "; deeper: the pieces in contact";
  if (scene.status == Status::disjoint) {
    result += "; <span class=\"key true\">arrow</span>: the gap from A to B, and A moved across it, dashed";
  } else if (scene.moves()) {
    result += "; <span class=\"key true\">arrow</span>: the true translation of A, and A after it, dashed";
    if (of_polytopes) result += fmt::format("; thick: the {} in contact", scene.plane ? "edges" : "faces");
  } else {
    result += fmt::format("; <span class=\"key true\">dot</span>: {}", scene.dot_text());
  }
  return scene.claimed ? result + of_claim(subject) : result;
}

/// Returns the bodies, the true way and the claimed one, as view/picture paints them.
std::string figure(const SubjectInfo& subject, const HtmlFailure& failure, const Case& judged, const Known& known,
                   const std::string& anchor) {
  if (!known) return "";
  const Outcome& outcome = failure.outcome;
  const std::optional<Point> claimed =
      outcome.reply ? claimed_translation(in_unit(*outcome.reply, -outcome.fit), subject.conventions) : std::nullopt;
  const picture::PairScene scene = picture::scene_of(judged.a, judged.b, *known, claimed);
  const std::string label = fmt::format("{} of {}",
                                        unions(known)      ? "Unions"
                                        : polytopes(known) ? "Hulls"
                                                           : "Shapes",
                                        markup(shown_id(outcome.id, outcome.variant)));
  return fmt::format("<figure><div class=\"pairs\">{}</div><figcaption>{}.</figcaption></figure>\n",
                     picture::scene_panels(scene, anchor, label), caption(subject, scene, *known));
}

}  // namespace

std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions) {
  const judging::Claim claim = judging::exact_claim(reply, conventions);
  if (!claim.overlap || !claim.length || !claim.direction) return std::nullopt;
  const Vec3<double> u = picture::unit_vector(rational(*claim.direction));
  return Point{mpq_class(exact_value(u.x) * *claim.length), mpq_class(exact_value(u.y) * *claim.length),
               mpq_class(exact_value(u.z) * *claim.length)};
}

std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor) {
  const Outcome& outcome = failure.outcome;
  const Case judged = judged_bodies(failure.seen, subject, outcome.fit);
  const Known known = known_of(judged);
  std::string result =
      fmt::format("<article id=\"{0}\" aria-labelledby=\"{0}-h\"><h4 id=\"{0}-h\"><a href=\"#{0}\">{1}</a></h4>\n",
                  anchor, markup(shown_id(outcome.id, outcome.variant)));
  result += fmt::format("<p><span class=\"verdict\">{}</span>: {}</p>\n", name(outcome.verdict),
                        markup(sentence_of(outcome)));
  std::string said = "<div class=\"facts\">\n";
  if (outcome.reply) said += claim_list(in_unit(*outcome.reply, -outcome.fit), subject.conventions, outcome.dimension);
  said += truth_list(outcome, known, picture::without_folders(failure.certificate_name));
  if (outcome.judgement) said += residual_list(*outcome.judgement);
  if (outcome.hulls) said += hulls_list(*outcome.hulls);
  if (outcome.pieces) said += pieces_list(*outcome.pieces);
  if (outcome.judgement && outcome.judgement->derivative) said += derivative_list(*outcome.judgement->derivative);
  if (!outcome.contact_faults.empty()) said += contacts_list(outcome.contact_faults);
  said += "</div>\n" + case_text(subject, failure, anchor);
  if (const std::string exact = exact_numbers(outcome, known); !exact.empty())
    said += fmt::format("<details><summary>The exact numbers</summary><pre tabindex=\"0\">{}</pre></details>\n", exact);
  return result + picture::beside(figure(subject, failure, judged, known, anchor), said) + "</article>\n";
}

}  // namespace fathom::harness
