// SPDX-License-Identifier: GPL-3.0-or-later
// The part of export.hpp about a single record.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernels/messages.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::json;
using Triples = std::vector<std::array<double, 3>>;

/// A text of the given characters: exports quote it as it is.
std::string plain_text(const Json& value, std::string_view characters) {
  const std::string* text = value.get_ptr<const std::string*>();
  if (!text || text->empty() || text->find_first_not_of(characters) != text->npos)
    throw NotARecord("expected a text as the schema says, found " + kernels::shown(value.dump()));
  return *text;
}

/// A hexadecimal float; from_chars wants it without sign and prefix.
double hexadecimal(const Json& value) {
  const std::string text = plain_text(value, "-+.0123456789abcdefinpx");
  std::string_view digits = text;
  const bool negative = digits.starts_with('-');
  digits.remove_prefix(negative ? 1 : 0);
  if (digits.starts_with("0x")) digits.remove_prefix(2);
  double magnitude = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude, std::chars_format::hex);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw NotARecord("expected a hexadecimal float, found " + kernels::shown(text));
  return negative ? -magnitude : magnitude;
}

std::array<double, 3> triple(const Json& value) {
  if (!value.is_array() || value.size() != 3) throw NotARecord("expected three numbers, found something else");
  return {hexadecimal(value[0]), hexadecimal(value[1]), hexadecimal(value[2])};
}

Triples points(const Json& body) {
  Triples result;
  for (const Json& vertex : body.at("vertices")) result.push_back(triple(vertex));
  if (result.empty()) throw NotARecord("expected at least one point, found none");
  return result;
}

/// To nearest.
std::array<double, 3> unit(const Json& holder) { return triple(holder.at("unit").at("f64").at("rn")); }

/// One subtraction, so it is correctly rounded; and so is the longest.
double longest_side(const Triples& body) {
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::ranges::minmax_element(body, {}, [axis](const std::array<double, 3>& point) { return point[axis]; });
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

/// "edge-edge": A's feature first.
std::string contact_in(const Json& holder) { return plain_text(holder.at("contact").at("kind"), "abcdefghijklmnopqrstuvwxyz-"); }

void read_answer(const Json& expected, ExportCase& result) {
  constexpr std::string_view digits = "0123456789/";
  result.status = plain_text(expected.at("status"), "abcdefghijklmnopqrstuvwxyz");
  const bool apart = result.status == "disjoint";
  const Json& length = expected.at(apart ? "distance" : "depth");
  const double value = hexadecimal(length.at("f64").at("rn"));
  result.signed_depth = apart ? -value : value;
  result.squared = plain_text(length.at("squared"), digits);
  for (const Json& optimum : expected.at("optima")) {
    result.directions.push_back(unit(optimum));
    if (std::string kind = contact_in(optimum); std::ranges::find(result.contacts, kind) == result.contacts.end())
      result.contacts.push_back(std::move(kind));
  }
  if (result.directions.empty()) result.directions.push_back(unit(expected));
}

std::vector<std::string> flags_in(const Json& record) {
  const std::vector<std::string_view> known = flag_names();
  std::vector<std::string> flags;
  for (const Json& flag : record.at("flags")) {
    flags.push_back(flag.get<std::string>());
    if (std::ranges::find(known, flags.back()) == known.end())
      throw NotARecord("expected a known flag, found " + kernels::shown(flags.back()));
  }
  return flags;
}

std::string group_of(const Json& source) {
  const std::string kind = source.at("kind").get<std::string>();
  return kind == "family" ? source.at("name").get<std::string>() : kind;
}

bool all_finite(const ExportCase& result) {
  return std::isfinite(result.signed_depth) && std::isfinite(result.size) && std::isfinite(result.largest);
}

}  // namespace

std::optional<ExportCase> export_case(std::string_view line) {
  try {
    const Json record = Json::parse(line);
    const Json& formats = record.at("formats");
    if (std::find(formats.begin(), formats.end(), "binary64") == formats.end()) return std::nullopt;
    ExportCase result;
    result.name = plain_text(record.at("id"), "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-");
    result.group = group_of(record.at("source"));
    result.flags = flags_in(record);
    for (const Json& format : formats)
      if (format != "exact") result.formats.push_back(plain_text(format, "binary3264"));
    result.a = points(record.at("a"));
    result.b = points(record.at("b"));
    result.size = std::max(longest_side(result.a), longest_side(result.b));
    result.largest = std::max(largest_coordinate(result.a), largest_coordinate(result.b));
    read_answer(record.at("expected"), result);
    return all_finite(result) ? std::optional(std::move(result)) : std::nullopt;
  } catch (const Json::exception& error) {
    throw NotARecord(std::string("expected a record, found a fault: ") + error.what());
  }
}

}  // namespace fathom::golden
