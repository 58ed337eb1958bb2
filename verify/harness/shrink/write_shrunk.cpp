// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/shrink/write_shrunk.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "fathom/numbers.hpp"
#include "verify/harness/shrink/snippet.hpp"

namespace fathom::harness {
namespace {

std::string number(const mpq_class& value) {
  const double nearest = round_binary64(value, Rounding::rn);
  if (std::isfinite(nearest) && exact_value(nearest) == value) return fmt::format("{}", nearest + 0.0);  // 0, never -0
  return '"' + exact_text(value) + '"';
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace); }

std::string body_json(const Body& body) {
  std::string text;
  for (const Point& p : body.points) text += fmt::format("{}[{},{},{}]", text.empty() ? "" : ",", number(p.x), number(p.y), number(p.z));
  return "{\"vertices\":[" + text + "]}";
}

/// Under another name first; a rename replaces the old file at once.
void write_whole(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path draft = path.string() + ".part";
  std::ofstream out(draft, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(draft, path, error);
  if (!out || error) throw InputError(path.string(), 0, "cannot be written" + (error ? ": " + error.message() : ""));
}

void make_folder(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw InputError(directory, 0, "cannot be made a directory: " + error.message());
}

}  // namespace

std::string case_line(const Case& pair, const std::string& comment) {
  std::string text = R"({"schema":"fathom/case/1","id":)" + quoted(pair.id);
  text += ",\"a\":" + body_json(pair.a) + ",\"b\":" + body_json(pair.b);
  if (!comment.empty()) text += ",\"comment\":" + quoted(comment);
  return text + "}\n";
}

std::string write_case(const std::string& directory, const std::string& stem, const Case& pair, const std::string& comment) {
  make_folder(directory);
  const std::string path = (std::filesystem::path(directory) / (stem + ".case.json")).string();
  write_whole(path, case_line(pair, comment));
  return path;
}

std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info) {
  make_folder(directory);
  const Outcome& outcome = shrunk.outcome;
  std::string stem(name(outcome.verdict));
  if (!outcome.variant.empty()) stem += '~' + outcome.variant;
  const std::string comment = fmt::format("{} of {} {}", stem, info.name, info.version);
  const std::filesystem::path base = std::filesystem::path(directory) / stem;
  const std::pair<const char*, std::string> files[] = {{".cert", shrunk.certificate}, {".cpp", snippet(info, shrunk.pair, outcome)}};
  std::vector<std::string> paths = {write_case(directory, stem, shrunk.pair, comment)};
  for (const auto& [ending, text] : files) {
    paths.push_back(base.string() + ending);
    write_whole(paths.back(), text);
  }
  return paths;
}

}  // namespace fathom::harness
