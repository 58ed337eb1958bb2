// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/report/text.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/reproducer.hpp"
#include "verify/harness/shrink/snippet_programs.hpp"
#include "verify/harness/variants.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t longest_comment = 600;

/// Safe behind "//": one line, printable, and not joined to the next.
std::string comment_text(const std::string& text) {
  std::string shown = kernels::printable(text, longest_comment);
  while (shown.ends_with('\\')) shown.pop_back();
  return shown;
}

std::string literal(double value) {
  if (std::isnan(value)) return "NAN";
  if (std::isinf(value)) return value < 0 ? "-HUGE_VAL" : "HUGE_VAL";
  return hex_text(value);
}

std::string literal(const mpq_class& value) { return literal(round_binary64(value, Rounding::rn)); }

std::string points_text(const Body& body) {
  std::string text;
  for (const Point& p : body.points)
    text += fmt::format("{}{{{}, {}, {}}}", text.empty() ? "" : ",\n        ", literal(p.x), literal(p.y), literal(p.z));
  return text;
}

std::string faces_text(const Body& body) {
  std::string text;
  for (const std::vector<std::uint32_t>& face : faces_of(body.points)) {
    std::string corners;
    for (const std::uint32_t corner : face) corners += fmt::format("{}{}", corners.empty() ? "" : ", ", corner);
    text += fmt::format("{}{{{}}}", text.empty() ? "" : ", ", corners);
  }
  return text;
}

std::string body_text(const std::string& name, const Body& body, bool with_faces) {
  const std::string faces = with_faces ? ",\n    {" + faces_text(body) + "}" : "";
  return fmt::format("const Body {} = {{\n    {{  // points\n        {}}}{}}};\n", name, points_text(body), faces);
}

std::string vector_text(const std::array<double, 3>& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

std::string claim_text(const Outcome& outcome) {
  if (!outcome.reply) return "none";
  const Reply& reply = *outcome.reply;
  std::string text = reply.overlap ? "overlap" : "no overlap";
  if (!reply.overlap && !reply.distance) return text;
  if (!reply.overlap) text += fmt::format(", distance {}", *reply.distance);
  else if (reply.depth) text += fmt::format(", depth {}", *reply.depth);
  if (reply.direction) text += ", direction " + vector_text(*reply.direction);
  if (reply.witness_a) text += ", witness of A " + vector_text(*reply.witness_a);
  if (reply.witness_b) text += ", witness of B " + vector_text(*reply.witness_b);
  for (const ContactPoint& contact : reply.contacts) {
    text += ", contact " + vector_text(contact.position);
    if (contact.depth) text += fmt::format(" of depth {}", *contact.depth);
  }
  return text;
}

/// Of shapes.
std::string truth_text(const Judgement& judgement) {
  const Between& depth = *judgement.signed_depth;
  const std::string_view word = judgement.status ? name(*judgement.status) : "undecided";
  return depth.low == depth.high ? fmt::format("{}, the signed depth is {}", word, depth.low)
                                 : fmt::format("{}, the signed depth is between {} and {}", word, depth.low, depth.high);
}

/// The truth that the outcome was judged by; of a variant that about the case.
std::string truth_text(const Case& pair, const Outcome& outcome) {
  if (outcome.radii != 0) return "of the bodies as the subject rounds them: " + truth_text(*outcome.judgement);
  if (pair.a.shape || pair.b.shape) {
    const bool same = outcome.judgement && outcome.variant.empty() && outcome.fit == 0;
    return truth_text(same ? *outcome.judgement : judge(truth_about(files::shape_of(pair.a), files::shape_of(pair.b)), Reply{}));
  }
  Status status = Status::disjoint;
  mpq_class squared, apart;
  if (outcome.judgement && outcome.variant.empty()) {
    status = *outcome.judgement->status;  // of polytopes
    squared = scaled(outcome.judgement->depth_squared, 2 * outcome.fit);
    apart = scaled(outcome.judgement->distance_squared, 2 * outcome.fit);
  } else {
    const Truth truth = truth_about(pair.a.points, pair.b.points);
    status = truth.depth.status();
    squared = truth.depth.squared();
    if (truth.depth.distance()) apart = truth.depth.distance()->squared;
  }
  if (status == Status::disjoint)
    return fmt::format("{}, distance^2 = {} exactly, distance = {}", name(status), exact_text(apart), root_binary64(apart, Rounding::rn));
  return fmt::format("{}, depth^2 = {} exactly, depth = {}", name(status), exact_text(squared), root_binary64(squared, Rounding::rn));
}

std::string heading(const SubjectInfo& info, const Case& pair, const Outcome& outcome, const std::string& command) {
  std::string settings;
  for (const auto& [key, value] : info.settings) settings += (settings.empty() ? "; " : ", ") + key + " = " + value;
  const std::string sentence = outcome.judgement ? outcome.judgement->sentence : outcome.detail;
  const std::string behind = outcome.variant.empty() ? "" : fmt::format(" (variant \"{}\")", outcome.variant);
  std::string text;
  const auto line = [&text](const std::string& words) { text += "// " + comment_text(words) + '\n'; };
  line(fmt::format("{}: {} {} ({}{})", pair.id, info.name, info.version, precision_text(info.format), settings));
  line("truth:   " + truth_text(pair, outcome));
  line("claim:   " + claim_text(outcome) + behind);
  const std::string verdict(name(outcome.verdict));
  const bool said = sentence.empty() || sentence.starts_with(verdict);
  line("verdict: " + (sentence.empty() ? verdict : said ? sentence : verdict + ": " + sentence));
  if (outcome.fit != 0) line(fmt::format("unit:    as the subject saw it, 2^{} of the case's; the verdict is in the case's", -outcome.fit));
  line("compile: " + command);
  return text;
}

/// The case as the variant that the outcome is about.
std::optional<Case> variant_of(const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  const std::string names[] = {outcome.variant};
  std::vector<Variant> found = variants(pair, info.format, names);
  return found.empty() ? std::nullopt : std::optional(found.front().seen);
}

std::string program_text(const SubjectInfo& info, const Case& pair, const Outcome& outcome, const Program& program) {
  std::string text = heading(info, pair, outcome, program.command) + program.includes;
  text += "#include <cstdio>\n#include <vector>\n\nnamespace {\n\n";
  text += info.wants_faces ? "// Faces: corners counter-clockwise, seen from outside.\n" : "";
  text += "struct Body {\n  std::vector<std::vector<double>> points;\n";
  text += info.wants_faces ? "  std::vector<std::vector<int>> faces;\n};\n\n" : "};\n\n";
  text += body_text("a", pair.a, info.wants_faces) + body_text("b", pair.b, info.wants_faces);
  const std::optional<Case> variant = variant_of(info, pair, outcome);
  if (variant)
    text += "// The same after a symmetry.\n" + body_text("other_a", variant->a, info.wants_faces) +
            body_text("other_b", variant->b, info.wants_faces);
  text += '\n' + program.body + "\n}  // namespace\n\nint main() {\n" + program.opening + "  answer(\"A and B\", a, b);\n";
  if (variant) text += fmt::format("  answer(\"the variant {}\", other_a, other_b);\n", outcome.variant);
  return text + program.closing + "}\n";
}

std::string reply_text(const Outcome& outcome) {
  if (!outcome.reply) return "  // No answer was recorded: put the one of your own call here.\n  fathom::Reply reply;\n";
  const auto triple = [](const char* field, const std::optional<Triple>& v) {
    return v ? fmt::format("  reply.{} = {{{{{}, {}, {}}}}};\n", field, literal((*v)[0]), literal((*v)[1]), literal((*v)[2])) : "";
  };
  const Reply& reply = *outcome.reply;
  std::string text = "  // The answer that was recorded; put your own call here.\n  fathom::Reply reply;\n";
  text += fmt::format("  reply.overlap = {};\n", reply.overlap);
  if (reply.depth) text += fmt::format("  reply.depth = {};\n", literal(*reply.depth));
  if (reply.distance) text += fmt::format("  reply.distance = {};\n", literal(*reply.distance));
  text += triple("direction", reply.direction) + triple("witness_a", reply.witness_a) + triple("witness_b", reply.witness_b);
  for (const auto& [p, depth] : reply.contacts)
    text += fmt::format("  reply.contacts.push_back({{{{{}, {}, {}}}, {}}});\n", literal(p[0]), literal(p[1]), literal(p[2]),
                        depth ? literal(*depth) : "std::nullopt");
  return text;
}

std::string conventions_text(const Conventions& conventions) {
  using Touching = Conventions::Touching;
  const char* touching = conventions.touching == Touching::overlap    ? "overlap"
                         : conventions.touching == Touching::separate ? "separate"
                                                                      : "either";
  return fmt::format(
      "  fathom::Conventions conventions;\n  conventions.touching = fathom::Conventions::Touching::{};\n"
      "  conventions.depth = fathom::Conventions::Sign::{};\n  conventions.moves = fathom::Conventions::Body::{};\n"
      "  conventions.unit = {};\n{}",
      touching, conventions.depth == Conventions::Sign::positive ? "positive" : "negative",
      conventions.moves == Conventions::Body::a ? "a" : "b", conventions.unit,
      conventions.claims == Conventions::Claims::minimum ? "" : "  conventions.claims = fathom::Conventions::Claims::separating;\n");
}

/// Of bodies that the subject rounds: the truth about the rounded ones.
constexpr std::string_view rounded_truth = R"(  const auto rounded = [](const std::vector<fathom::Triple>& body, const mpq_class& radius) {
    std::vector<fathom::Point> points;
    for (const auto& [x, y, z] : body) points.push_back({fathom::exact_value(x), fathom::exact_value(y), fathom::exact_value(z)});
    return fathom::with_margin(fathom::hull(points), radius);
  };
)";

/// For a library without a program here, and for bodies by name.
std::string test_text(const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  std::string text =
      "// To ask your own engine, put your call where the recorded answer stands in the test below; or give certify --harness.\n";
  text += heading(info, pair, outcome, "link fathom::judge and GoogleTest's main");
  text +=
      "#include <gtest/gtest.h>\n\n#include <cmath>\n#include <vector>\n\n#include <fathom/judge.hpp>\n#include "
      "<fathom/numbers.hpp>\n#include <fathom/shape.hpp>\n\n";
  text += "TEST(Depth, IsRight) {\n";
  const bool shapes = has_words(pair);
  for (const auto& [name, body] : {std::pair{"a", &pair.a}, {"b", &pair.b}})
    text += shapes ? fmt::format("  const fathom::Shape {} = {};\n", name, as_shape_code(*body))
                   : fmt::format("  const std::vector<fathom::Triple> {} = {{\n        {}}};\n", name, points_text(*body));
  text += reply_text(outcome) + conventions_text(info.conventions);
  const std::string of_answers =
      info.format.points == info.format.answers ? "" : fmt::format(", fathom::Precision::{}}}", name(info.format.answers));
  const mpq_class radius_a = rounding_radius(pair.a, info), radius_b = rounding_radius(pair.b, info);
  std::string bodies = shapes ? "fathom::truth_about(a, b)" : "a, b";
  if (radius_a != 0 || radius_b != 0) {
    if (!shapes) text += rounded_truth;
    const std::string of_a = exact_text(radius_a), of_b = exact_text(radius_b), function = shapes ? "fathom::with_margin" : "rounded";
    text += fmt::format("  const mpq_class radius_a(\"{}\"), radius_b(\"{}\");\n", of_a, of_b);
    text += fmt::format("  fathom::ShapeTruth truth = fathom::truth_about({0}(a, radius_a), {0}(b, radius_b));\n", function);
    text += "  truth.added_a = radius_a;\n  truth.added_b = radius_b;\n";
    bodies = "truth";
  }
  text += fmt::format("  const fathom::Judgement judgement = fathom::judge({}, reply, conventions, {}fathom::Precision::{}{});\n", bodies,
                      of_answers.empty() ? "" : "{", name(info.format.points), of_answers);
  return text + "  EXPECT_TRUE(fathom::passes(judgement.verdict)) << judgement.sentence;\n}\n";
}

}  // namespace

std::string filled_harness(std::string text, const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  const Case there = in_unit(pair, outcome.fit);
  for (const auto& [name, body] : {std::pair{"A", &there.a}, {"B", &there.b}})
    for (const auto& [mark, value] : {std::pair{fmt::format("@{}@", name), body_code(*body)},
                                      {fmt::format("@{}_JSON@", name), body_message(*body, info.format.points, info.wants_faces)}})
      for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + value.size())) text.replace(at, mark.size(), value);
  return text;
}

std::string snippet(const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  const std::optional<Program> program = has_words(pair) ? std::nullopt : program_for(info);
  const Case there = in_unit(pair, outcome.fit);
  return program ? program_text(info, there, outcome, *program) : test_text(info, there, outcome);
}

}  // namespace fathom::harness
