// SPDX-License-Identifier: GPL-3.0-or-later
// One failure of the page: pictures, the truth, the claim, and exact numbers.
#include <fmt/format.h>

#include <exception>

#include "fathom/numbers.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/judged_bodies.hpp"
#include "verify/harness/report/html_parts.hpp"
#include "verify/harness/report/markup.hpp"
#include "verify/harness/report/picture.hpp"
#include "verify/harness/report/subject_text.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/write_shrunk.hpp"
#include "view/picture/page.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t longest_inline = 60;     // characters of an exact number beside its rounded one
constexpr std::size_t longest_exact = 10'000;  // of one in the list of exact numbers
constexpr std::size_t longest_case = 200'000;  // characters of a case as JSON

std::string exact(const mpq_class& value) {
  const std::string text = exact_text(value);
  return text.size() <= longest_exact ? text : fmt::format("{}... ({} characters)", text.substr(0, longest_exact), text.size());
}

/// A signed square by its root: rounded, and the square exactly where that is short.
std::string length_text(const mpq_class& squared) {
  const std::string text = exact_text(squared);
  const std::string behind = text.size() <= longest_inline ? fmt::format(" (squared: {})", text) : "";
  return fmt::format("{}{}{}", squared < 0 ? "-" : "", root_binary64(mpq_class(abs(squared)), Rounding::rn), behind);
}

std::string rounded_text(const Point& p) {
  return fmt::format("({}, {}, {})", round_binary64(p.x, Rounding::rn), round_binary64(p.y, Rounding::rn),
                     round_binary64(p.z, Rounding::rn));
}

std::string between_text(const Between& x) {
  return x.low == x.high ? fmt::format("{}", x.low) : fmt::format("between {} and {}", x.low, x.high);
}

std::string triple_text(const Triple& t) { return fmt::format("({}, {}, {})", t[0], t[1], t[2]); }

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

std::string truth_list(const Outcome& outcome, const std::optional<Truth>& truth, const std::string& certificate) {
  Facts facts;
  if (outcome.judgement || truth) {
    const std::optional<Status> status = outcome.judgement ? outcome.judgement->status : truth->depth.status();
    facts.add("status", status_text(status));
    if (outcome.judgement && outcome.judgement->signed_depth) facts.add("signed depth", between_text(*outcome.judgement->signed_depth));
    else if (status == Status::penetrating)
      facts.add("depth", length_text(outcome.judgement ? outcome.judgement->depth_squared : truth->depth.squared()));
  }
  if (truth && truth->depth.distance()) facts.add("distance", length_text(truth->depth.distance()->squared));
  if (truth && truth->depth.status() == Status::penetrating) {
    facts.add("translation of A", rounded_text(truth->depth.translation()));
    if (truth->depth.optima().size() > 1) facts.add("ties", fmt::format("{} translations are as short", truth->depth.optima().size()));
  }
  if (!certificate.empty()) facts.add("certificate", certificate);
  return facts.list("Truth");
}

/// The subject's own numbers, each with the convention that it is by.
std::string claim_list(const Reply& reply, const Conventions& conventions) {
  Facts facts;
  facts.add("status", reply.overlap ? "the bodies overlap" : "the bodies do not overlap");
  facts.add(conventions.depth == Conventions::Sign::positive ? "depth" : "depth, negative where they overlap", reply.depth);
  facts.add("distance", reply.distance);
  facts.add(fmt::format("direction in which {} moves", moving_body(conventions)), reply.direction, triple_text);
  facts.add("point of A", reply.witness_a, triple_text);
  facts.add("point of B", reply.witness_b, triple_text);
  for (const ContactPoint& contact : reply.contacts) {
    facts.add("contact", std::optional(contact.position), triple_text);
    facts.add("depth there", contact.depth);
  }
  return facts.list("Claim");
}

std::string residual_list(const Judgement& judgement) {
  Facts facts;
  std::string findings;
  for (const Verdict verdict : judgement.findings) findings += fmt::format("{}{}", findings.empty() ? "" : ", ", name(verdict));
  if (judgement.findings.size() > 1) facts.add("all that is wrong", findings);
  facts.add("depth or distance is off by", judgement.error);
  facts.add("relative", judgement.error_relative);
  facts.add("in ulps", judgement.error_ulps);
  facts.add("in units of uR", judgement.error_u_r);
  facts.add("depth of its direction", judgement.price_squared, length_text);
  facts.add("depth of its direction", judgement.price, between_text);
  facts.add("which is above the true depth, relative to it, by", judgement.dearer);
  facts.add("way until apart along it", judgement.travel_squared, length_text);
  facts.add("claim less depth of its direction", judgement.inconsistency);
  facts.add("overlap left", judgement.overlap_left);
  facts.add("point of A is off by", judgement.witness_a_squared, length_text);
  facts.add("point of B is off by", judgement.witness_b_squared, length_text);
  facts.add("point of A is off by", judgement.witness_a_distance, between_text);
  facts.add("point of B is off by", judgement.witness_b_distance, between_text);
  facts.add("points differ from translation by", judgement.witness_gap);
  facts.add("contacts are away from A by up to", judgement.contact_a_squared, length_text);
  facts.add("contacts are away from B by up to", judgement.contact_b_squared, length_text);
  facts.add("contacts are away from A by up to", judgement.contact_a_distance, between_text);
  facts.add("contacts are away from B by up to", judgement.contact_b_distance, between_text);
  facts.add("deepest contact less claimed depth", judgement.deepest);
  return facts.list("Residuals");
}

std::string hulls_list(const AboutHulls& hulls) {
  Facts facts;
  facts.add("the same answer about them", std::string(name(hulls.query.verdict)) + ": " + hulls.query.sentence);
  facts.add("asked vertices are away from them by", length_text(hulls.lost_squared));
  facts.add("their vertices are away from the bodies by", length_text(hulls.grown_squared));
  return facts.list("Hulls that it used");
}

/// The case as the subject saw it, to be copied into a file; a sentence if it is too long for a page, or cannot be written.
std::string case_text(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor) {
  const Case& seen = failure.seen;
  if (seen.a.points.empty() && !has_words(seen)) return "";
  try {
    const std::string line = case_line(seen, fmt::format("{} of {} {}", name(failure.outcome.verdict), subject.name, subject.version));
    if (line.size() <= longest_case)
      return picture::copied_text(anchor + "-case", "copy this case", "The case, as the subject saw it",
                                  std::string_view(line).substr(0, line.size() - 1));
    return fmt::format("<p class=\"soft\">The case has {} points and is not on this page.</p>\n",
                       seen.a.points.size() + seen.b.points.size());
  } catch (const std::invalid_argument&) {
    return "";
  }
}

/// Lines of the exact numbers that the lists round.
std::string exact_numbers(const Outcome& outcome, const std::optional<Truth>& truth) {
  std::string result;
  const auto add = [&](const char* what, const mpq_class& value) { result += fmt::format("{} = {}\n", what, exact(value)); };
  if (outcome.judgement) {
    const Judgement& judgement = *outcome.judgement;
    if (!judgement.signed_depth) add("depth^2", judgement.depth_squared);
    if (judgement.price_squared) add("(depth of its direction)^2, signed", *judgement.price_squared);
    if (judgement.travel_squared) add("(way until apart along it)^2", *judgement.travel_squared);
    if (judgement.witness_a_squared) add("(distance of the point of A)^2", *judgement.witness_a_squared);
    if (judgement.witness_b_squared) add("(distance of the point of B)^2", *judgement.witness_b_squared);
  } else if (truth) {
    add("depth^2", truth->depth.squared());
  }
  if (!truth) return result;
  if (truth->depth.distance()) add("distance^2", truth->depth.distance()->squared);
  for (const Optimum& optimum : truth->depth.optima()) {
    const Point t = optimum.translation();
    result += fmt::format("translation of A = ({}, {}, {})\n", exact(t.x), exact(t.y), exact(t.z));
  }
  return result;
}

/// Solves the pair again. Returns nullopt if that fails, and for shapes: a page without one picture is better than none.
std::optional<Truth> truth_of(const Case& seen) {
  if (seen.a.shape || seen.b.shape) return std::nullopt;
  try {
    return truth_about(seen.a.points, seen.b.points);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// What the picture of two polytopes shows.
std::string caption(const SubjectInfo& subject, const Truth& truth, bool claimed) {
  std::string result = "<span class=\"key body-a\">A</span> toned, <span class=\"key body-b\">B</span> hatched, hidden edges dashed";
  if (truth.depth.status() == Status::penetrating)
    result += "; <span class=\"key true\">arrow</span>: the true translation of A, and A after it, dashed; thick: the faces in contact";
  if (truth.depth.distance()) result += "; <span class=\"key true\">arrow</span>: the gap from A to B, and A moved across it, dashed";
  if (truth.depth.touch()) result += "; <span class=\"key true\">dot</span>: where they touch";
  if (claimed) {
    result += "; <span class=\"key claimed\">dashed arrow</span>: the translation of A that is claimed";
    if (subject.conventions.moves == Conventions::Body::b) result += ", which is that of B turned round: the subject moves B";
  }
  return result;
}

std::string figure_element(const std::string& svg, const std::string& caption) {
  return fmt::format("<figure><div class=\"pairs\">{}</div><figcaption>{}.</figcaption></figure>\n", svg, caption);
}

std::string figure(const SubjectInfo& subject, const HtmlFailure& failure, const Case& judged, const std::optional<Truth>& truth,
                   const std::string& anchor) {
  const Outcome& outcome = failure.outcome;
  const std::string of = markup(shown_id(outcome.id, outcome.variant));
  if (truth) {
    const std::optional<Point> claimed =
        outcome.reply ? claimed_translation(in_unit(*outcome.reply, -outcome.fit), subject.conventions) : std::nullopt;
    return figure_element(pair_picture(*truth, claimed, anchor, "Hulls of " + of), caption(subject, *truth, claimed.has_value()));
  }
  if (const std::string svg = shapes_picture(judged, anchor, "Shapes of " + of); !svg.empty())
    return figure_element(svg,
                          "<span class=\"key body-a\">A</span> toned, <span class=\"key body-b\">B</span> hatched; "
                          "<span class=\"key true\">arrow</span>: the true way of A, and A after it, dashed");
  return "";
}

}  // namespace

std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor) {
  const Outcome& outcome = failure.outcome;
  const Case judged = judged_bodies(failure.seen, subject, outcome.fit);
  const std::optional<Truth> truth = truth_of(judged);
  std::string result = fmt::format("<article id=\"{0}\" aria-labelledby=\"{0}-h\"><h4 id=\"{0}-h\"><a href=\"#{0}\">{1}</a></h4>\n", anchor,
                                   markup(shown_id(outcome.id, outcome.variant)));
  result += fmt::format("<p><span class=\"verdict\">{}</span>: {}</p>\n", name(outcome.verdict), markup(sentence_of(outcome)));
  std::string said = "<div class=\"facts\">\n";
  if (outcome.reply) said += claim_list(in_unit(*outcome.reply, -outcome.fit), subject.conventions);
  said += truth_list(outcome, truth, failure.certificate_name);
  if (outcome.judgement) said += residual_list(*outcome.judgement);
  if (outcome.hulls) said += hulls_list(*outcome.hulls);
  said += "</div>\n" + case_text(subject, failure, anchor);
  if (const std::string exact = exact_numbers(outcome, truth); !exact.empty())
    said += fmt::format("<details><summary>The exact numbers</summary><pre tabindex=\"0\">{}</pre></details>\n", exact);
  return result + picture::beside(figure(subject, failure, judged, truth, anchor), said) + "</article>\n";
}

}  // namespace fathom::harness
