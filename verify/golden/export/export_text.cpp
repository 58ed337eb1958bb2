// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the fields that exports need from a record; and writes the texts of exports.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/text/json.hpp"
#include "reference/text/json_value.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::golden {
namespace {

using text::Json;
using text::JsonValue;
using Triples = std::vector<std::array<double, 3>>;

/// Returns a text of the given characters, which needs no escaping.
std::string plain_text(const JsonValue& value, std::string_view characters) {
  const std::string text = value.is_string() ? value.string() : "";
  if (text.empty() || text.find_first_not_of(characters) != text.npos)
    throw NotARecord("expected a text as the schema says, found " + kernels::shown(value.written().text()));
  return text;
}

/// Reads a hexadecimal float; from_chars expects it without sign and prefix.
double hexadecimal(const JsonValue& value) {
  const std::string text = plain_text(value, "-+.0123456789abcdefinpx");
  std::string_view digits = text;
  const bool negative = digits.starts_with('-');
  digits.remove_prefix(negative ? 1 : 0);
  if (digits.starts_with("0x")) digits.remove_prefix(2);
  double magnitude = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), magnitude, std::chars_format::hex);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw NotARecord("expected a hexadecimal float, found " + kernels::shown(text));
  return negative ? -magnitude : magnitude;
}

/// Two numbers in the plane, where the third is 0.
std::array<double, 3> triple(const JsonValue& value, unsigned dimension) {
  if (value.items().size() != dimension)
    throw NotARecord(dimension == 3 ? "expected three numbers, found something else"
                                    : "expected two numbers, found something else");
  std::array<double, 3> result{};
  for (unsigned i = 0; i < dimension; ++i) result.at(i) = hexadecimal(value.at(i));
  return result;
}

Triples points(const JsonValue& body, unsigned dimension) {
  Triples result;
  for (const JsonValue& vertex : body.at("vertices").items()) result.push_back(triple(vertex, dimension));
  if (result.empty()) throw NotARecord("expected at least one point, found none");
  return result;
}

/// Returns the unit vector, rounded to nearest.
std::array<double, 3> unit(const JsonValue& holder, unsigned dimension) {
  return triple(holder.at("unit").at("f64").at("rn"), dimension);
}

/// Returns the longest side: a difference of two doubles, so correctly rounded.
double longest_side(const Triples& body) {
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::ranges::minmax_element(body, {}, [axis](const std::array<double, 3>& point) { return point[axis]; });
    longest = std::max(longest, (*high)[axis] - (*low)[axis]);
  }
  return longest;
}

double largest_coordinate(const Triples& body) {
  double largest = 0;
  for (const std::array<double, 3>& point : body)
    for (const double coordinate : point) largest = std::max(largest, std::abs(coordinate));
  return largest;
}

/// Returns "edge-edge", with A's feature first.
std::string contact_in(const JsonValue& holder) {
  return plain_text(holder.at("contact").at("kind"), "abcdefghijklmnopqrstuvwxyz-");
}

void add_optimum(std::array<double, 3> direction, const JsonValue& optimum, ExportCase& result) {
  result.directions.push_back(direction);
  if (std::string kind = contact_in(optimum); std::ranges::find(result.contacts, kind) == result.contacts.end())
    result.contacts.push_back(std::move(kind));
}

constexpr std::string_view digits = "0123456789/";

/// Reads the answer about two polygons: the signed depth is a root without a radius beside it.
void read_plane_answer(const JsonValue& expected, ExportCase& result) {
  const JsonValue& depth = expected.at("signed_depth");
  result.signed_depth = hexadecimal(depth.at("f64").at("rn"));
  result.squared = plain_text(depth.at("exact").at("root"), digits);
  if (result.status != "penetrating") {
    result.directions.push_back(unit(expected, 2));
    return;
  }
  for (const JsonValue& way : expected.at("translations").items()) {
    const JsonValue& normal = way.at("normal");
    const RoundedVector rounded =
        rounded_unit({number_in(normal.at(0)).get_num(), number_in(normal.at(1)).get_num(), 0});
    add_optimum({rounded[0].binary64[0], rounded[1].binary64[0], 0}, way, result);
  }
}

void read_answer(const JsonValue& expected, ExportCase& result) {
  result.status = plain_text(expected.at("status"), "abcdefghijklmnopqrstuvwxyz");
  if (result.dimension == 2) return read_plane_answer(expected, result);
  const bool apart = result.status == "disjoint";
  const JsonValue& length = expected.at(apart ? "distance" : "depth");
  const double value = hexadecimal(length.at("f64").at("rn"));
  result.signed_depth = apart ? -value : value;
  result.squared = plain_text(length.at("squared"), digits);
  for (const JsonValue& optimum : expected.at("optima").items()) add_optimum(unit(optimum, 3), optimum, result);
  if (result.directions.empty()) result.directions.push_back(unit(expected, 3));
}

/// Exact numbers, each rounded to nearest.
std::array<double, 3> rounded_triple(const JsonValue& value) {
  if (value.items().size() != 3) throw NotARecord("expected three numbers, found something else");
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = round_binary64(number_in(value.at(i)));
  return result;
}

/// Reads the contact manifold of a record of contacts.
void read_manifold(const JsonValue& manifold, ExportCase& result) {
  for (const JsonValue& patch : manifold.at("patches").items()) {
    Triples& corners = result.patches.emplace_back();
    for (const JsonValue& corner : patch.at("corners").items()) corners.push_back(rounded_triple(corner.at("a")));
  }
  if (!manifold.at("gradient_f64").is_object()) return;
  const auto numbers = [&](std::string_view name) {
    const JsonValue& of = manifold.at("gradient_f64").at(name);
    return std::array<double, 3>{of.at(0).number(), of.at(1).number(), of.at(2).number()};
  };
  result.gradient = {numbers("v"), numbers("w")};
}

std::vector<std::string> flags_in(const JsonValue& record) {
  const std::vector<std::string_view> known = flag_names();
  std::vector<std::string> flags;
  for (const JsonValue& flag : record.at("flags").items()) {
    flags.push_back(flag.string());
    if (std::ranges::find(known, flags.back()) == known.end())
      throw NotARecord("expected a known flag, found " + kernels::shown(flags.back()));
  }
  return flags;
}

std::string group_of(const JsonValue& source) {
  const std::string kind = source.at("kind").string();
  return kind == "family" || kind == "plane_family" ? source.at("name").string() : kind;
}

bool all_finite(const ExportCase& result) {
  const auto finite = [](const Triples& corners) {
    return std::ranges::all_of(
        corners, [](const auto& p) { return std::ranges::all_of(p, [](double x) { return std::isfinite(x); }); });
  };
  return std::isfinite(result.signed_depth) && std::isfinite(result.size) && std::isfinite(result.largest) &&
         std::ranges::all_of(result.patches, finite);
}

}  // namespace

std::optional<ExportCase> export_case(std::string_view line) {
  try {
    const JsonValue record = text::parsed_json(line);
    const std::vector<JsonValue>& formats = record.at("formats").items();
    const auto is = [](std::string_view name) {
      return [name](const JsonValue& format) { return format.text() == name; };
    };
    if (std::ranges::none_of(formats, is("binary64"))) return std::nullopt;
    ExportCase result;
    result.name = plain_text(record.at("id"), "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-");
    result.group = group_of(record.at("source"));
    if (record.find("dimension")) result.dimension = 2;
    else result.flags = flags_in(record);
    for (const JsonValue& format : formats)
      if (!is("exact")(format)) result.formats.push_back(plain_text(format, "binary3264"));
    result.a = points(record.at("a"), result.dimension);
    result.b = points(record.at("b"), result.dimension);
    result.size = std::max(longest_side(result.a), longest_side(result.b));
    result.largest = std::max(largest_coordinate(result.a), largest_coordinate(result.b));
    read_answer(record.at("expected"), result);
    if (const JsonValue* const manifold = record.at("expected").find("manifold")) read_manifold(*manifold, result);
    return all_finite(result) ? std::optional(std::move(result)) : std::nullopt;
  } catch (const text::JsonFault& fault) {
    throw NotARecord(std::string("expected a record, found a fault: ") + fault.what());
  }
}

// ---- texts ----

namespace {

using Triples = std::vector<std::array<double, 3>>;

constexpr std::size_t longest_c_string = 509;  // the length that every C89 compiler accepts

// `dimension`: 2 in the plane, where the third coordinate, which is 0, is left out.

std::string joined(const std::array<double, 3>& point, std::string_view separator, unsigned dimension = 3) {
  std::string text = fmt::format("{1}{0}{2}", separator, decimal_text(point[0]), decimal_text(point[1]));
  return dimension == 3 ? fmt::format("{1}{0}{2}", separator, text, decimal_text(point[2])) : text;
}

/// Returns text(element) of all elements, with separators between them.
template <class Elements, class Text>
std::string listed(const Elements& elements, std::string_view separator, Text text) {
  std::string result;
  for (const auto& element : elements) {
    if (!result.empty()) result += separator;
    result += text(element);
  }
  return result;
}

std::string bracketed(const Triples& points, unsigned dimension = 3) {
  return '[' + listed(points, ", ", [=](const auto& point) { return '[' + joined(point, ", ", dimension) + ']'; }) +
         ']';
}

Triples gradient_of(const ExportCase& entry) { return {entry.gradient->begin(), entry.gradient->end()}; }

std::string quoted(const std::string& plain) { return '"' + plain + '"'; }

std::string quoted_list(const std::vector<std::string>& words) { return '[' + listed(words, ", ", quoted) + ']'; }

/// Returns the lines above the cases, each of which begins with `margin`.
std::string about(const ExportSource& source, std::size_t count, std::string_view margin) {
  if (!source.file.empty())
    return fmt::format("{0}{1} cases of {2} with their exact answers. Made by\n{0}  {3}\n", margin, count, source.file,
                       source.command);
  return fmt::format(
      "{0}{1} golden cases from {2}, seed {3}, data version {4}. In the public domain (CC0-1.0). Made by\n"
      "{0}  {5}\n",
      margin, count, source.level, source.seed, source.version, source.command);
}

// ---- C ----

std::string c_points(const Triples& points, unsigned dimension = 3) {
  std::string result;
  for (const std::array<double, 3>& point : points) result += "  " + joined(point, ", ", dimension) + ",\n";
  return result;
}

std::string c_text(const ExportSource& source, const std::vector<ExportCase>& cases) {
  std::string numbers, table, sizes;
  std::size_t at = 0, patches = 0;
  const auto place = [&](const Triples& points, unsigned dimension) {
    numbers += c_points(points, dimension);
    return fmt::format("fathom_golden_numbers + {}, {}", at, points.size());
  };
  for (const ExportCase& entry : cases) {
    std::string status = "FATHOM_GOLDEN_" + entry.status;
    std::ranges::transform(status, status.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    numbers += "  /* " + entry.name + " */\n";
    table += fmt::format("  {{\"{}\", {}, {}, {},\n   \"{}\", {}, {},\n   ", entry.name, status,
                         decimal_text(entry.signed_depth),
                         entry.squared.size() > longest_c_string ? "NULL" : quoted(entry.squared),
                         listed(entry.flags, " ", [](const std::string& flag) { return flag; }),
                         decimal_text(entry.size), decimal_text(entry.largest));
    for (const Triples* points : {&entry.a, &entry.b, &entry.directions}) {
      table += place(*points, entry.dimension) + ", ";
      at += entry.dimension * points->size();
    }
    const auto add = [&](const auto& points) {
      numbers += c_points({points.begin(), points.end()});
      at += 3 * points.size();
    };
    table += entry.patches.empty()
                 ? "NULL, NULL, "
                 : fmt::format("fathom_golden_numbers + {}, fathom_golden_corners + {}, ", at, patches);
    for (const Triples& corners : entry.patches) {
      add(corners);
      sizes += fmt::format("  {},\n", corners.size());
    }
    patches += entry.patches.size();
    table += entry.gradient ? fmt::format("fathom_golden_numbers + {}, ", at) : "NULL, ";
    table += fmt::format("{}}},\n", entry.dimension);
    if (entry.gradient) add(*entry.gradient);
  }
  if (!sizes.empty())
    sizes =
        "/* How many corners each patch has. */\nstatic const size_t fathom_golden_corners[] = {\n" + sizes + "};\n\n";
  return fmt::format(
      "{}\n/*\n{} */\n#ifndef FATHOM_GOLDEN_CASES\n#define FATHOM_GOLDEN_CASES\n\n"
      "/* The points of A, those of B, and the directions of each case; corners and the gradient, if it has some. */\n"
      "static const double fathom_golden_numbers[] = {{\n{}}};\n\n{}"
      "static const fathom_golden_case fathom_golden_cases[] = {{\n{}}};\n\n"
      "enum {{ fathom_golden_count = {} }};\n\n#endif\n",
      kit_in_c(), about(source, cases.size(), " * "), numbers, sizes, table, cases.size());
}

// ---- Rust ----

std::string rust_entry(const ExportCase& entry) {
  std::string status = entry.status;
  status[0] = static_cast<char>(status[0] - 'a' + 'A');
  return fmt::format(
      "    Case {{\n        name: \"{}\",\n        status: Status::{},\n        signed_depth: {},\n        squared: "
      "\"{}\",\n"
      "        flags: &{},\n        size: {},\n        largest: {},\n        a: &{},\n        b: &{},\n        "
      "directions: &{},\n        patches: &[{}],\n        gradient: {},\n    }},\n",
      entry.name, status, decimal_text(entry.signed_depth), entry.squared, quoted_list(entry.flags),
      decimal_text(entry.size), decimal_text(entry.largest), bracketed(entry.a, entry.dimension),
      bracketed(entry.b, entry.dimension), bracketed(entry.directions, entry.dimension),
      listed(entry.patches, ", ", [](const Triples& p) { return '&' + bracketed(p); }),
      entry.gradient ? "Some(" + bracketed(gradient_of(entry)) + ")" : "None");
}

std::string rust_text(const ExportSource& source, const std::vector<ExportCase>& cases) {
  std::string text =
      fmt::format("{}\n{}#[allow(clippy::excessive_precision)]\npub static CASES: [Case{}; {}] = [\n", kit_in_rust(),
                  about(source, cases.size(), "// "), cases.front().dimension == 2 ? "<2>" : "", cases.size());
  for (const ExportCase& entry : cases) text += rust_entry(entry);
  return text + "];\n";
}

// ---- JSON and CSV ----

Json triples_json(const Triples& triples, unsigned dimension = 3) {
  return Json::array_of(triples, [dimension](const std::array<double, 3>& triple) {
    return Json::array_of(std::span(triple).first(dimension), [](double x) { return Json(x); });
  });
}
Json words_json(const std::vector<std::string>& words) {
  return Json::array_of(words, [](const std::string& word) { return Json(word); });
}

Json case_json(const ExportCase& entry) {
  Json result{{"name", entry.name},
              {"status", entry.status},
              {"signed_depth", entry.signed_depth},
              {"squared", entry.squared},
              {"flags", words_json(entry.flags)},
              {"size", entry.size},
              {"largest", entry.largest},
              {"a", triples_json(entry.a, entry.dimension)},
              {"b", triples_json(entry.b, entry.dimension)},
              {"directions", triples_json(entry.directions, entry.dimension)},
              {"family", entry.group},
              {"formats", words_json(entry.formats)},
              {"contacts", words_json(entry.contacts)}};
  if (entry.dimension == 2) result["dimension"] = 2;
  if (entry.patches.empty()) return result;
  result["patches"] = Json::array_of(entry.patches, [](const Triples& corners) { return triples_json(corners); });
  result["gradient"] = entry.gradient ? triples_json(gradient_of(entry)) : Json();
  return result;
}

/// A line for each case.
std::string json_text(const ExportSource& source, const std::vector<ExportCase>& cases) {
  const bool own = !source.file.empty();  // and not ours to license
  Json head{{"schema", "fathom/golden-export/1"}};
  if (!own) head["licence"] = "CC0-1.0";
  Json from = own ? Json{{"file", source.file}}
                  : Json{{"level", source.level}, {"seed", source.seed}, {"version", source.version}};
  from["command"] = source.command;
  head["source"] = from;
  std::string text = "{\n" + head.text().substr(1);  // no line is an object with a schema: it is one file
  text.back() = ',';
  text += "\n\"cases\":[";
  for (const ExportCase& entry : cases) text += (&entry == cases.data() ? "\n" : ",\n") + case_json(entry).text();
  return text + "\n]}\n";
}

std::string csv_text(const std::vector<ExportCase>& cases) {
  const unsigned dimension = cases.front().dimension;
  const auto numbers = [dimension](const Triples& points) {
    return listed(points, " ", [dimension](const auto& point) { return joined(point, " ", dimension); });
  };
  const auto words = [](const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, " ")); };
  std::string text =
      "name,status,signed_depth,squared,flags,size,largest,a,b,directions,family,formats,contacts,patches,gradient";
  text += dimension == 2 ? ",dimension\n" : "\n";
  for (const ExportCase& entry : cases)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}\n", entry.name, entry.status,
                        decimal_text(entry.signed_depth), entry.squared, words(entry.flags), decimal_text(entry.size),
                        decimal_text(entry.largest), numbers(entry.a), numbers(entry.b), numbers(entry.directions),
                        entry.group, words(entry.formats), words(entry.contacts), listed(entry.patches, ";", numbers),
                        entry.gradient ? numbers(gradient_of(entry)) : "", dimension == 2 ? ",2" : "");
  return text;
}

}  // namespace

std::string_view name_of(ExportFormat format) {
  switch (format) {
    case ExportFormat::c: return "c";
    case ExportFormat::csv: return "csv";
    case ExportFormat::json: return "json";
    case ExportFormat::rust: break;
  }
  return "rust";
}

std::optional<ExportFormat> find_export_format(std::string_view name) {
  for (const ExportFormat format : export_formats)
    if (name_of(format) == name) return format;
  return std::nullopt;
}

std::string export_text(ExportFormat format, const ExportSource& source, const std::vector<ExportCase>& cases) {
  switch (format) {
    case ExportFormat::c: return c_text(source, cases);
    case ExportFormat::csv: return csv_text(cases);
    case ExportFormat::json: return json_text(source, cases);
    case ExportFormat::rust: break;
  }
  return rust_text(source, cases);
}

std::string decimal_text(double value) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

}  // namespace fathom::golden
