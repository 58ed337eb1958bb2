// SPDX-License-Identifier: GPL-3.0-or-later
// The part of export.hpp about texts.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "verify/golden/export/export.hpp"
#include "verify/golden/release/embedded_pages.hpp"

namespace fathom::golden {
namespace {

using Triples = std::vector<std::array<double, 3>>;

constexpr std::size_t longest_c_string = 509;  // that every C89 compiler takes

std::string joined(const std::array<double, 3>& point, std::string_view separator) {
  return fmt::format("{1}{0}{2}{0}{3}", separator, decimal_text(point[0]), decimal_text(point[1]), decimal_text(point[2]));
}

/// Each element as `text` has it, with separators between.
template <class Elements, class Text>
std::string listed(const Elements& elements, std::string_view separator, Text text) {
  std::string result;
  for (const auto& element : elements) {
    if (!result.empty()) result += separator;
    result += text(element);
  }
  return result;
}

std::string bracketed(const Triples& points) {
  return '[' + listed(points, ", ", [](const auto& point) { return '[' + joined(point, ", ") + ']'; }) + ']';
}

std::string quoted(const std::string& plain) { return '"' + plain + '"'; }

std::string quoted_list(const std::vector<std::string>& words) { return '[' + listed(words, ", ", quoted) + ']'; }

/// What stands before the cases, in lines that begin with `margin`.
std::string about(const ExportSource& source, std::size_t count, std::string_view margin) {
  if (!source.file.empty())
    return fmt::format("{0}{1} cases of {2} with their exact answers. Made by\n{0}  {3}\n", margin, count, source.file, source.command);
  return fmt::format(
      "{0}{1} golden cases from {2}, seed {3}, data version {4}. In the public domain (CC0-1.0). Made by\n"
      "{0}  {5}\n",
      margin, count, source.level, source.seed, source.version, source.command);
}

// ---- C ----

std::string c_points(const Triples& points) {
  std::string result;
  for (const std::array<double, 3>& point : points) result += "  " + joined(point, ", ") + ",\n";
  return result;
}

std::string c_text(const ExportSource& source, const std::vector<ExportCase>& cases) {
  std::string numbers, table;
  std::size_t at = 0;
  const auto place = [&](const Triples& points) {
    numbers += c_points(points);
    return fmt::format("fathom_golden_numbers + {}, {}", at, points.size());
  };
  for (const ExportCase& entry : cases) {
    std::string status = "FATHOM_GOLDEN_" + entry.status;
    std::ranges::transform(status, status.begin(), [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    numbers += "  /* " + entry.name + " */\n";
    table += fmt::format("  {{\"{}\", {}, {}, {},\n   \"{}\", {}, {},\n   ", entry.name, status, decimal_text(entry.signed_depth),
                         entry.squared.size() > longest_c_string ? "NULL" : quoted(entry.squared),
                         listed(entry.flags, " ", [](const std::string& flag) { return flag; }), decimal_text(entry.size),
                         decimal_text(entry.largest));
    for (const Triples* points : {&entry.a, &entry.b, &entry.directions}) {
      table += place(*points) + (points == &entry.directions ? "},\n" : ", ");
      at += 3 * points->size();
    }
  }
  return fmt::format(
      "{}\n/*\n{} */\n#ifndef FATHOM_GOLDEN_CASES\n#define FATHOM_GOLDEN_CASES\n\n"
      "/* The points of A, those of B, and the directions of each case. */\n"
      "static const double fathom_golden_numbers[] = {{\n{}}};\n\n"
      "static const fathom_golden_case fathom_golden_cases[] = {{\n{}}};\n\n"
      "enum {{ fathom_golden_count = {} }};\n\n#endif\n",
      kit_in_c(), about(source, cases.size(), " * "), numbers, table, cases.size());
}

// ---- Rust ----

std::string rust_entry(const ExportCase& entry) {
  std::string status = entry.status;
  status[0] = static_cast<char>(status[0] - 'a' + 'A');
  return fmt::format(
      "    Case {{\n        name: \"{}\",\n        status: Status::{},\n        signed_depth: {},\n        squared: \"{}\",\n"
      "        flags: &{},\n        size: {},\n        largest: {},\n        a: &{},\n        b: &{},\n        directions: &{},\n    }},\n",
      entry.name, status, decimal_text(entry.signed_depth), entry.squared, quoted_list(entry.flags), decimal_text(entry.size),
      decimal_text(entry.largest), bracketed(entry.a), bracketed(entry.b), bracketed(entry.directions));
}

std::string rust_text(const ExportSource& source, const std::vector<ExportCase>& cases) {
  std::string text = fmt::format("{}\n{}#[allow(clippy::excessive_precision)]\npub static CASES: [Case; {}] = [\n", kit_in_rust(),
                                 about(source, cases.size(), "// "), cases.size());
  for (const ExportCase& entry : cases) text += rust_entry(entry);
  return text + "];\n";
}

// ---- JSON and CSV ----

std::string json_text(const ExportSource& source, const std::vector<ExportCase>& cases) {
  const auto entry_text = [](const ExportCase& entry) {
    return fmt::format(
        R"({{"name": "{}", "status": "{}", "signed_depth": {}, "squared": "{}", "flags": {}, "size": {}, "largest": {}, "a": {}, "b": {}, )"
        R"("directions": {}, "family": "{}", "formats": {}, "contacts": {}}})",
        entry.name, entry.status, decimal_text(entry.signed_depth), entry.squared, quoted_list(entry.flags), decimal_text(entry.size),
        decimal_text(entry.largest), bracketed(entry.a), bracketed(entry.b), bracketed(entry.directions), entry.group,
        quoted_list(entry.formats), quoted_list(entry.contacts));
  };
  const bool own = !source.file.empty();  // and not ours to license
  const std::string from = own ? fmt::format(R"("file": "{}")", source.file)
                               : fmt::format(R"("level": "{}", "seed": "{}", "version": "{}")", source.level, source.seed, source.version);
  return fmt::format(
      "{{\"schema\": \"fathom/golden-export/1\",{}\n"
      "\"source\": {{{}, \"command\": \"{}\"}},\n\"cases\": [\n{}\n]}}\n",
      own ? "" : R"( "licence": "CC0-1.0",)", from, source.command, listed(cases, ",\n", entry_text));
}

std::string csv_text(const std::vector<ExportCase>& cases) {
  const auto numbers = [](const Triples& points) { return listed(points, " ", [](const auto& point) { return joined(point, " "); }); };
  const auto words = [](const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, " ")); };
  std::string text = "name,status,signed_depth,squared,flags,size,largest,a,b,directions,family,formats,contacts\n";
  for (const ExportCase& entry : cases)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", entry.name, entry.status, decimal_text(entry.signed_depth),
                        entry.squared, words(entry.flags), decimal_text(entry.size), decimal_text(entry.largest), numbers(entry.a),
                        numbers(entry.b), numbers(entry.directions), entry.group, words(entry.formats), words(entry.contacts));
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
