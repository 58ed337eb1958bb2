// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/cases_json.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"

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

std::string three(const Point& p) { return fmt::format("[{},{},{}]", number(p.x), number(p.y), number(p.z)); }

}  // namespace

std::string body_json(const Body& polytope, const std::optional<files::Pose>& pose) {
  std::string result = "{\"vertices\":" + array(polytope.points, three);
  if (pose) result += ",\"pose\":" + array(*pose, [](const auto& row) { return array(row, number); });
  return result + '}';
}

std::string body_json(const families::NamedBody& body) {
  std::string result = "{\"shape\":" + quoted(body.shape);
  const auto field = [&](std::string_view name, const std::string& text) { result += fmt::format(",\"{}\":{}", name, text); };
  const auto numbers = [&](std::string_view name) {
    const auto found = body.fields.numbers.find(name);
    if (found == body.fields.numbers.end()) return;
    field(name, found->second.size() == 1 ? number(found->second.front()) : array(found->second, number));
  };
  for (const files::NumberField& known : files::named_shape(body.shape).shape->numbers) numbers(known.name);
  if (body.fields.axis != Axis::z) field("axis", body.fields.axis == Axis::x ? R"("x")" : R"("y")");
  if (!body.fields.vertices.empty()) field("vertices", array(body.fields.vertices, three));
  if (!body.terms.empty()) field("terms", array(body.terms, [](const families::NamedBody& term) { return body_json(term); }));
  numbers("margin");
  const Quaternion& turn = body.turn;
  const Point& place = body.place;
  if (turn != Quaternion{1, 0, 0, 0} || place != Point{})
    field("pose",
          fmt::format(R"({{"quaternion":{},"translation":{}}})", array(std::array{turn.w, turn.x, turn.y, turn.z}, number), three(place)));
  return result + '}';
}

std::string case_json(const CaseText& text) {
  std::string result = R"({"schema":"fathom/case/1","id":)" + quoted(text.id);
  result += ",\"a\":" + text.a + ",\"b\":" + text.b;
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
