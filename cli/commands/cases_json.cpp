// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/cases_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t plain_digits = 15;  // integers with at most this many digits are binary64 numbers

std::string number(const mpq_class& value) {
  if (value.get_den() == 1 && mpz_sizeinbase(value.get_num_mpz_t(), 10) <= plain_digits) return value.get_str();
  const double nearest = round_binary64(value, Rounding::rn);
  if (std::isfinite(nearest) && exact_value(nearest) == value) return fmt::format("{}", nearest);
  return '"' + exact_text(value) + '"';
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace); }

template <class List, class Text>
std::string array(const List& list, Text text) {
  std::string result = "[";
  for (const auto& item : list) {
    if (result.size() > 1) result += ',';
    result += text(item);
  }
  return result + ']';
}

std::string body(const Body& body, const std::optional<files::Pose>& pose) {
  const auto vertex = [](const Point& p) { return fmt::format("[{},{},{}]", number(p.x), number(p.y), number(p.z)); };
  std::string result = "{\"vertices\":" + array(body.points, vertex);
  if (pose) result += ",\"pose\":" + array(*pose, [](const auto& row) { return array(row, number); });
  return result + '}';
}

}  // namespace

std::string case_json(const CaseText& text) {
  std::string result = R"({"schema":"fathom/case/1","id":)" + quoted(text.id);
  result += ",\"a\":" + body(text.a, text.pose_a) + ",\"b\":" + body(text.b, text.pose_b);
  if (text.pose_rounding) result += R"(,"pose_rounding":"binary64")";
  if (!text.flags.empty()) result += ",\"flags\":" + array(text.flags, quoted);
  if (!text.source.empty()) {
    std::string source;
    for (const auto& [key, value] : text.source) source += (source.empty() ? "" : ",") + quoted(key) + ':' + quoted(value);
    result += ",\"source\":{" + source + '}';
  }
  if (!text.comment.empty()) result += ",\"comment\":" + quoted(text.comment);
  return result + '}';
}

}  // namespace fathom::cli
