// SPDX-License-Identifier: GPL-3.0-or-later
// Programs for a case, and how they are written to files. Their texts are in templates/, one file
// for each library and call; this file replaces marks such as @value@.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/report/reports.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/shrink.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/fields.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::harness {

/// Defined in templates/embedded.cpp.in.
namespace templates {

extern const std::string_view libccd, fcl_distance, fcl_collide, bullet_epa, bullet_pair, ode, judged, rounded;

}  // namespace templates

namespace {

/// Returns `text` with the map's keys replaced by their values.
std::string filled(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [key, value] : values)
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos; at += value.size())
      text.replace(at, key.size(), value);
  return text;
}

/// Returns the setting if it is a plain number, else `usual`, because a subject may send any text.
std::string setting(const SubjectInfo& info, const std::string& key, const std::string& usual) {
  const auto found = info.settings.find(key);
  if (found == info.settings.end() || found->second.empty()) return usual;
  const std::string& text = found->second;
  return text.find_first_not_of("0123456789.eE+-") == std::string::npos && text.find_first_of("0123456789") == 0
             ? text
             : usual;
}

/// A program that calls a library: how to compile the file "case.cpp", and its text, with marks for
/// the bodies and the calls.
struct AskingProgram {
  std::string command, text;
};

/// Returns the program with the calls of this subject's adapter and the settings of its hello.
/// Returns nullopt for a library without a template.
std::optional<AskingProgram> program_for(const SubjectInfo& info) {
  const auto asks = [&info](const char* mode) { return info.name.find(mode) != std::string::npos; };
  const auto made = [](std::string command, std::string_view text, const std::map<std::string, std::string>& values) {
    return AskingProgram{std::move(command), filled(std::string(text), values)};
  };
  if (info.library == "libccd") {
    const std::string tolerance = asks("mpr") ? "mpr_tolerance" : "epa_tolerance";
    return made("g++ case.cpp -lccd -lm", templates::libccd,
                {{"@tolerance@", tolerance},
                 {"@value@", setting(info, tolerance, "0.0001")},
                 {"@iterations@", setting(info, "max_iterations", "18446744073709551615")},
                 {"@call@", asks("mpr") ? "ccdMPRPenetration" : "ccdGJKPenetration"}});
  }
  if (info.library == "fcl") {
    const std::string command = "g++ case.cpp $(pkg-config --cflags --libs fcl eigen3) -std=c++17";
    if (asks("signed"))
      return made(command, templates::fcl_distance, {{"@value@", setting(info, "distance_tolerance", "1e-6")}});
    return made(command, templates::fcl_collide,
                {{"@value@", setting(info, "gjk_tolerance", "1e-6")},
                 {"@contacts@", setting(info, "num_max_contacts", "1")},
                 {"@solver@", asks("indep") ? "GST_INDEP" : "GST_LIBCCD"}});
  }
  if (info.library == "bullet") {
    const bool wide = info.format.points == Precision::binary64;
    return made(std::string("g++ case.cpp $(pkg-config --cflags --libs bullet") + (wide ? "-float64)" : ")"),
                asks("pair") ? templates::bullet_pair : templates::bullet_epa,
                {{"@value@", setting(info, "margin", "0.04")}});
  }
  if (info.library == "ode")
    return made("g++ case.cpp $(pkg-config --cflags --libs ode)", templates::ode,
                {{"@contacts@", setting(info, "contacts", "32")}});
  return std::nullopt;
}

// ---- bodies as C++: their points in braces, or the functions of fathom/shape.hpp that make them
// ----

/// Returns the shortest text of a binary64 number.
std::string number(const mpq_class& value) { return fmt::format("{}", round_binary64(value)); }

std::string triple(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return fmt::format("{{{}, {}, {}}}", number(x), number(y), number(z));
}
std::string triple(const Point& p) { return triple(p.x, p.y, p.z); }

std::string list(const std::vector<Point>& points, unsigned dimension = 3) {
  std::vector<std::string> texts;
  for (const Point& p : points)
    texts.push_back(dimension == 2 ? fmt::format("{{{}, {}}}", number(p.x), number(p.y)) : triple(p));
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

std::string hull_text(const std::vector<Point>& points) {
  return "fathom::hull(std::vector<fathom::Point>" + list(points) + ")";
}

std::string unmoved(const files::NamedBody& words);

std::string shape_code(const files::NamedBody& words) {
  if (words.matrix) {
    std::vector<std::string> rows;
    for (const auto& row : *words.matrix)
      rows.push_back(fmt::format("{{{}, {}, {}, {}}}", number(row[0]), number(row[1]), number(row[2]), number(row[3])));
    return fmt::format("fathom::moved({}, fathom::Pose{{{{{}}}}})", unmoved(words), fmt::join(rows, ", "));
  }
  const Quaternion& q = words.turn;
  const bool upright = q.x == 0 && q.y == 0 && q.z == 0;
  if (upright && words.place == Point{}) return unmoved(words);
  return fmt::format("fathom::moved({}, fathom::rigid_pose({{{}, {}, {}, {}}}, {}))", unmoved(words), number(q.w),
                     number(q.x), number(q.y), number(q.z), triple(words.place));
}

/// Returns the call of a shape's function, whose arguments are its fields in their order.
std::string core_text(const files::NamedBody& words) {
  const files::ShapeName& shape = *files::named_shape(words.shape).shape;
  if (shape.part == files::ShapePart::vertices && shape.name == "hull") return hull_text(words.fields.vertices);
  if (shape.part == files::ShapePart::terms) {
    std::string sum;
    for (const files::NamedBody& term : words.terms) {
      const std::string text = shape_code(term);
      sum = sum.empty() ? text : fmt::format("fathom::minkowski_sum({}, {})", sum, text);
    }
    return sum;
  }
  std::vector<std::string> arguments;
  for (const Point& p : words.fields.vertices) arguments.push_back(triple(p));
  for (const files::NumberField& field : shape.numbers) {
    const std::vector<mpq_class>& values = words.fields.numbers.find(field.name)->second;
    arguments.push_back(field.count == 1 ? number(values[0]) : triple(values[0], values[1], values[2]));
  }
  if (shape.part == files::ShapePart::axis)
    arguments.push_back(fmt::format("fathom::Axis::{}", "xyz"[static_cast<int>(words.fields.axis)]));
  return fmt::format("fathom::{}({})", shape.name, fmt::join(arguments, ", "));
}

std::string unmoved(const files::NamedBody& words) {
  const auto margin = words.fields.numbers.find("margin");
  const std::string core = core_text(words);
  return margin == words.fields.numbers.end()
             ? core
             : fmt::format("fathom::with_margin({}, {})", core, number(margin->second[0]));
}

// ---- programs ----

constexpr std::size_t longest_comment = 600;

/// Returns the text for a comment after "//": one line, printable, without a backslash at its end.
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
    text +=
        fmt::format("{}{{{}, {}, {}}}", text.empty() ? "" : ",\n        ", literal(p.x), literal(p.y), literal(p.z));
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

std::string claim_text(const Outcome& outcome) {
  if (!outcome.reply) return "none";
  const auto vector_text = [&](const std::array<double, 3>& v) {
    return outcome.dimension == 2 ? fmt::format("({}, {})", v[0], v[1]) : fmt::format("({}, {}, {})", v[0], v[1], v[2]);
  };
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

/// Returns the truth about shapes.
std::string truth_text(const Judgement& judgement) {
  const Between& depth = *judgement.signed_depth;
  const std::string_view word = name(judgement.status);
  return depth.low == depth.high
             ? fmt::format("{}, the signed depth is {}", word, depth.low)
             : fmt::format("{}, the signed depth is between {} and {}", word, depth.low, depth.high);
}

/// Returns the truth by which the outcome was judged; for a variant that about the case.
std::string truth_text(const Case& pair, const Outcome& outcome) {
  if (outcome.radii != 0) return "of the bodies as the subject rounds them: " + truth_text(*outcome.judgement);
  if (pair.a.shape || pair.b.shape) {
    const bool same = outcome.judgement && outcome.variant.empty() && outcome.fit == 0;
    return truth_text(same ? *outcome.judgement
                           : judging::judged(judging::truth_of(pair.a, pair.b), Reply{}, {}, {}, {}));
  }
  Status status = Status::disjoint;
  mpq_class squared, apart;
  if (outcome.judgement && outcome.variant.empty()) {
    status = *outcome.judgement->status;  // of polytopes
    squared = scaled(outcome.judgement->depth_squared, 2 * outcome.fit);
    apart = scaled(outcome.judgement->distance_squared, 2 * outcome.fit);
  } else {
    const Truth truth = std::get<Truth>(judging::truth_of(pair.a, pair.b));
    status = truth.depth.status();
    squared = truth.depth.squared();
    if (truth.depth.distance()) apart = truth.depth.distance()->squared;
  }
  if (status == Status::disjoint)
    return fmt::format("{}, distance^2 = {} exactly, distance = {}", name(status), exact_text(apart),
                       root_binary64(apart, Rounding::rn));
  return fmt::format("{}, depth^2 = {} exactly, depth = {}", name(status), exact_text(squared),
                     root_binary64(squared, Rounding::rn));
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
  if (outcome.fit != 0)
    line(fmt::format("unit:    as the subject saw it, 2^{} of the case's; the verdict is in the case's", -outcome.fit));
  line("compile: " + command);
  return text;
}

/// Returns the variant of the case that the outcome is about.
std::optional<Case> variant_of(const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  const std::string names[] = {outcome.variant};
  std::vector<Variant> found = variants(pair, info.format, names);
  return found.empty() ? std::nullopt : std::optional(found.front().seen);
}

std::string program_text(const SubjectInfo& info, const Case& pair, const Outcome& outcome,
                         const AskingProgram& program) {
  std::string bodies = info.wants_faces ? "// Faces: corners counter-clockwise, seen from outside.\n" : "";
  bodies += "struct Body {\n  std::vector<std::vector<double>> points;\n";
  bodies += info.wants_faces ? "  std::vector<std::vector<int>> faces;\n};\n\n" : "};\n\n";
  bodies += body_text("a", pair.a, info.wants_faces) + body_text("b", pair.b, info.wants_faces);
  std::string calls = "  answer(\"A and B\", a, b);\n";
  if (const std::optional<Case> variant = variant_of(info, pair, outcome)) {
    bodies += "// The same after a symmetry.\n" + body_text("other_a", variant->a, info.wants_faces) +
              body_text("other_b", variant->b, info.wants_faces);
    calls += fmt::format("  answer(\"the variant {}\", other_a, other_b);\n", outcome.variant);
  }
  return heading(info, pair, outcome, program.command) +
         filled(program.text, {{"@bodies@", bodies}, {"@calls@", calls}});
}

std::string reply_text(const Outcome& outcome) {
  if (!outcome.reply)
    return "  // No answer was recorded: put the one of your own call here.\n  fathom::Reply reply;\n";
  const auto triple = [](const char* field, const std::optional<Triple>& v) {
    return v ? fmt::format("  reply.{} = {{{{{}, {}, {}}}}};\n", field, literal((*v)[0]), literal((*v)[1]),
                           literal((*v)[2]))
             : "";
  };
  const Reply& reply = *outcome.reply;
  std::string text = "  // The answer that was recorded; put your own call here.\n  fathom::Reply reply;\n";
  text += fmt::format("  reply.overlap = {};\n", reply.overlap);
  if (reply.depth) text += fmt::format("  reply.depth = {};\n", literal(*reply.depth));
  if (reply.distance) text += fmt::format("  reply.distance = {};\n", literal(*reply.distance));
  text += triple("direction", reply.direction) + triple("witness_a", reply.witness_a) +
          triple("witness_b", reply.witness_b);
  for (const auto& [p, depth] : reply.contacts)
    text += fmt::format("  reply.contacts.push_back({{{{{}, {}, {}}}, {}}});\n", literal(p[0]), literal(p[1]),
                        literal(p[2]), depth ? literal(*depth) : "std::nullopt");
  if (reply.derivative) text += fmt::format("  reply.derivative = {};\n", literal(*reply.derivative));
  return text;
}

/// Returns the same with points as fathom::hull(...).
std::string as_shape_code(const Body& body) {
  if (body.words) return shape_code(*body.words);
  if (!body.shape) return hull_text(body.points);
  return fmt::format("fathom::with_margin({}, {})", hull_text(core_of(body)), number(body.shape->radius));
}

std::string manifold_text(const std::optional<ContactLimits>& manifold) {
  if (!manifold) return "";
  return fmt::format("  conventions.manifold = fathom::ContactLimits{{{}, {}}};\n",
                     manifold->most ? fmt::format("{}", *manifold->most) : "{}", literal(manifold->margin));
}

/// Returns the motion of the bodies, exactly.
std::string motion_text(const Motion& motion) {
  const auto point = [](const Point& p) {
    return fmt::format("{{mpq_class(\"{}\"), mpq_class(\"{}\"), mpq_class(\"{}\")}}", exact_text(p.x), exact_text(p.y),
                       exact_text(p.z));
  };
  return fmt::format("  const fathom::Motion motion{{{{{}, {}}},\n        {{{}, {}}}}};\n", point(motion.of_a.v),
                     point(motion.of_a.w), point(motion.of_b.v), point(motion.of_b.w));
}

/// Returns the bodies, of the plane what stands for them in space, with the radii that the subject
/// adds.
Case in_space(const SubjectInfo& info, const Case& pair) {
  if (pair.a.dimension == 3) return pair;
  const Case judged = judged_bodies(pair, info, 0);
  answer::Prisms prisms = answer::prisms_of(judged.a, judged.b);
  return {pair.id, std::move(prisms.a), std::move(prisms.b), pair.motion};
}

/// Returns a test for a library without a template, for bodies by name, and for a derivative.
std::string test_text(const SubjectInfo& info, const Case& given, const Outcome& outcome) {
  const bool in_plane = given.a.dimension == 2;
  const Case pair = in_space(info, given);
  const bool shapes = has_words(pair) || pair.a.shape || pair.b.shape;
  std::string bodies = in_plane ? "  // Of bodies of the plane this is what stands for them in space.\n" : "";
  for (const auto& [name, body] : {std::pair{"a", &pair.a}, {"b", &pair.b}})
    bodies +=
        shapes ? fmt::format("  const fathom::Shape {} = {};\n", name, as_shape_code(*body))
               : fmt::format("  const std::vector<fathom::Triple> {} = {{\n        {}}};\n", name, points_text(*body));
  // If the subject rounds bodies, the truth is that about the rounded bodies.
  const mpq_class radius_a = rounding_radius(given.a, info), radius_b = rounding_radius(given.b, info);
  std::string rounded, judged = shapes ? "fathom::truth_about(a, b)" : "a, b";
  if (in_plane) {
    rounded = fmt::format("  fathom::{} truth = fathom::truth_about({});\n  truth.dimension = 2;\n",
                          shapes ? "ShapeTruth" : "Truth",
                          shapes ? "a, b" : "fathom::GivenPoints(a), fathom::GivenPoints(b)");
    if (shapes)
      rounded += fmt::format("  truth.added_a = mpq_class(\"{}\");\n  truth.added_b = mpq_class(\"{}\");\n",
                             exact_text(radius_a), exact_text(radius_b));
    judged = "truth";
  } else if (radius_a != 0 || radius_b != 0) {
    if (!shapes) rounded += templates::rounded;
    rounded += fmt::format("  const mpq_class radius_a(\"{}\"), radius_b(\"{}\");\n", exact_text(radius_a),
                           exact_text(radius_b));
    rounded += fmt::format("  fathom::ShapeTruth truth = fathom::truth_about({0}(a, radius_a), {0}(b, radius_b));\n",
                           shapes ? "fathom::with_margin" : "rounded");
    rounded += "  truth.added_a = radius_a;\n  truth.added_b = radius_b;\n";
    judged = "truth";
  }
  const bool moves = pair.motion && outcome.reply && outcome.reply->derivative;
  const Conventions& conventions = info.conventions;
  const auto precision = [](Precision of) { return fmt::format("fathom::Precision::{}", name(of)); };
  const std::string points = precision(info.format.points), answers = precision(info.format.answers);
  const std::map<std::string, std::string> values = {
      {"@bodies@", bodies},
      {"@reply@", reply_text(outcome)},
      {"@touching@", std::string(judging::word_of(conventions.touching))},
      {"@depth@", std::string(judging::word_of(conventions.depth))},
      {"@moves@", std::string(judging::word_of(conventions.moves))},
      {"@unit@", fmt::format("{}", conventions.unit)},
      {"@claims@", conventions.claims == Conventions::Claims::minimum
                       ? ""
                       : "  conventions.claims = fathom::Conventions::Claims::separating;\n"},
      {"@manifold@", manifold_text(conventions.manifold)},
      {"@rounded@", rounded},
      {"@judged@", judged},
      {"@motion@", moves ? motion_text(*pair.motion) : ""},
      {"@moves too@", moves ? ", {}, motion" : ""},
      {"@format@", points == answers ? points : "{" + points + ", " + answers + "}"}};
  return "// To ask your own engine, put your call where the recorded answer stands in the test below; or give certify "
         "--harness.\n" +
         heading(info, pair, outcome, "link fathom::judge and GoogleTest's main") +
         filled(std::string(templates::judged), values);
}

// ---- files ----

void write_whole(const std::string& path, const std::string& text) try {
  files::WholeFile file(path);
  file.write(text);
  file.put_in_place();
} catch (const files::FileError& error) {
  throw InputError(path, 0, "cannot be written: " + error.code.message());
}

void make_folder(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw InputError(directory, 0, "cannot be made a directory: " + error.message());
}

/// Returns the body in C++: its points as {{x, y, z}, ...}, or the calls of fathom/shape.hpp that
/// make it, as fathom::moved(fathom::sphere(0.5), ...). Numbers are the shortest decimals that read
/// back as the same binary64 number.
/// Of a body of the plane {{x, y}, ...}, and {points, radius} if it has a radius.
std::string body_code(const Body& body) {
  if (body.words) return shape_code(*body.words);
  if (!body.shape) return list(body.points, body.dimension);
  return fmt::format("{{{}, {}}}", list(core_of(body), body.dimension), number(body.shape->radius));
}

/// Returns the user's own program: `text` with each @A@ and @B@ replaced by body_code, and each
/// @A_JSON@ and @B_JSON@ by the body as it is sent to the subject. For a variant it is about the
/// original case. The rest of the text is unchanged.
std::string filled_harness(std::string text, const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  const Case there = in_unit(pair, outcome.fit);
  for (const auto& [name, body] : {std::pair{"A", &there.a}, {"B", &there.b}})
    for (const auto& [mark, value] :
         {std::pair{fmt::format("@{}@", name), body_code(*body)},
          {fmt::format("@{}_JSON@", name), body_message(*body, info.format.points, info.wants_faces)}})
      for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + value.size()))
        text.replace(at, mark.size(), value);
  return text;
}

}  // namespace

std::string snippet(const SubjectInfo& info, const Case& pair, const Outcome& outcome) {
  const bool asks = !has_words(pair) && pair.a.dimension == 3 && outcome.verdict != Verdict::wrong_derivative;
  const std::optional<AskingProgram> program = asks ? program_for(info) : std::nullopt;
  const Case there = in_unit(pair, outcome.fit);
  return program ? program_text(info, there, outcome, *program) : test_text(info, there, outcome);
}

std::string write_case(const std::string& directory, const std::string& stem, const Case& pair,
                       const std::string& comment) {
  make_folder(directory);
  const std::string path = (std::filesystem::path(directory) / (stem + ".case.json")).string();
  write_whole(path, files::case_json(pair, comment) + '\n');
  return path;
}

HarnessTemplate read_harness(const std::string& path) {
  HarnessTemplate own{files::read_file(path), std::filesystem::path(path).extension().string()};
  for (const std::string body : {"A", "B"})
    if (own.text.find("@" + body + "@") == own.text.npos && own.text.find("@" + body + "_JSON@") == own.text.npos)
      throw InputError(path, 0, "expected @" + body + "@ or @" + body + "_JSON@ where the body goes, found neither");
  return own;
}

std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info,
                                      const std::optional<HarnessTemplate>& own) {
  make_folder(directory);
  const Outcome& outcome = shrunk.outcome;
  std::string stem(name(outcome.verdict));
  if (!outcome.variant.empty()) stem += '~' + outcome.variant;
  const std::string comment = fmt::format("{} of {} {}", stem, info.name, info.version);
  const std::filesystem::path base = std::filesystem::path(directory) / stem;
  std::vector<std::pair<std::string, std::string>> files = {{".cert", shrunk.certificate}};
  if (own) files.emplace_back(own->ending, filled_harness(own->text, info, shrunk.pair, outcome));
  else files.emplace_back(".cpp", snippet(info, shrunk.pair, outcome));
  std::vector<std::string> paths = {write_case(directory, stem, shrunk.pair, comment)};
  for (const auto& [ending, text] : files) {
    paths.push_back(base.string() + ending);
    write_whole(paths.back(), text);
  }
  return paths;
}

}  // namespace fathom::harness
