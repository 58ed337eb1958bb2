// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/args/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "kernels/messages.hpp"
#include "reference/approximate/separation.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/robot.hpp"
#include "reference/solve/depth.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::cli {
namespace {

constexpr unsigned largest_size = 1'000'000, most_threads = 1024;
constexpr std::uint64_t most_parts = 1'000'000;

std::optional<unsigned> typed_size(std::string_view text) {
  const std::optional<std::uint64_t> size = typed_integer(text, 1, largest_size);
  return size ? std::optional(static_cast<unsigned>(*size)) : std::nullopt;
}

std::optional<std::vector<unsigned>> typed_range(std::string_view low_text, std::string_view high_text) {
  const std::optional<unsigned> low = typed_size(low_text), high = typed_size(high_text);
  if (!low || !high || *low > *high) return std::nullopt;
  std::vector<unsigned> sizes{*low};
  for (unsigned decade = 1; decade <= largest_size; decade *= 10)
    for (const unsigned factor : {1U, 2U, 5U})
      if (factor * decade > *low && factor * decade < *high) sizes.push_back(factor * decade);
  if (*high > *low) sizes.push_back(*high);
  return sizes;
}

/// Returns the number that certify accepts: without blanks around it.
std::optional<mpq_class> bare_number(const std::string& text) { return parse_number(text, Decimals::exact).value; }

}  // namespace

std::optional<std::uint64_t> typed_integer(std::string_view text, std::uint64_t low, std::uint64_t high) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc() && end == text.data() + text.size() && value >= low && value <= high;
  return good ? std::optional(value) : std::nullopt;
}

std::optional<mpq_class> typed_number(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  if (begin == text.npos) return std::nullopt;
  return parse_number(text.substr(begin, end - begin + 1), Decimals::exact).value;
}

namespace {

/// Returns `count` numbers with commas between them; empty for other texts.
std::vector<mpq_class> typed_numbers(std::string_view text, std::size_t count) {
  std::vector<mpq_class> numbers;
  while (numbers.size() < count) {
    const std::size_t comma = numbers.size() + 1 == count ? text.npos : text.find(',');
    const auto number = typed_number(text.substr(0, comma));
    if (!number || (comma == text.npos && numbers.size() + 1 < count)) return {};
    numbers.push_back(*number);
    if (comma != text.npos) text.remove_prefix(comma + 1);
  }
  return numbers;
}

}  // namespace

std::optional<Point> typed_point(std::string_view text, unsigned dimension) {
  const std::vector<mpq_class> x = typed_numbers(text, dimension);
  if (x.empty()) return std::nullopt;
  return Point{x[0], x[1], dimension == 2 ? mpq_class(0) : x[2]};
}

std::optional<Point> typed_vector(std::string_view text, unsigned dimension) {
  const std::optional<Point> point = typed_point(text, dimension);
  return point == Point{0, 0, 0} ? std::nullopt : point;
}

std::optional<Twist> typed_twist(std::string_view text, unsigned dimension) {
  const std::vector<mpq_class> x = typed_numbers(text, dimension == 2 ? 3 : 6);
  if (std::ranges::all_of(x, [](const mpq_class& c) { return c == 0; })) return std::nullopt;  // or x is empty
  if (dimension == 2) return Twist{{x[0], x[1], 0}, {0, 0, x[2]}};
  return Twist{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
}

std::optional<Twist> typed_motion(std::string_view text, unsigned dimension) {
  const std::string_view rest = dimension == 2 ? ",0" : ",0,0,0";
  const std::optional<Twist> v = typed_twist(std::string(text).append(rest), dimension);
  return v ? v : typed_twist(text, dimension);
}

std::optional<std::vector<unsigned>> typed_sizes(std::string_view text) {
  if (const std::size_t dots = text.find(".."); dots != text.npos)
    return typed_range(text.substr(0, dots), text.substr(dots + 2));
  std::vector<unsigned> sizes;
  for (const std::string& word : words_of(text)) {
    const std::optional<unsigned> size = typed_size(word);
    if (!size || (!sizes.empty() && *size <= sizes.back())) return std::nullopt;
    sizes.push_back(*size);
  }
  return sizes;
}

std::optional<unsigned> typed_threads(std::string_view text) {
  const std::optional<std::uint64_t> threads = typed_integer(text, 1, most_threads);
  return threads ? std::optional(static_cast<unsigned>(*threads)) : std::nullopt;
}

std::optional<std::pair<std::size_t, std::size_t>> typed_part(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto parts = typed_integer(text.substr(std::min(slash + 1, text.size())), 1, most_parts);
  const auto part = parts ? typed_integer(text.substr(0, slash), 1, *parts) : std::nullopt;
  return part ? std::optional(std::pair<std::size_t, std::size_t>(*part, *parts)) : std::nullopt;
}

std::vector<Method> typed_methods(std::span<const std::string> words) {
  std::vector<Method> methods;
  for (const std::string& word : words) {
    const Method method = solve::second_method(word).value();
    if (std::ranges::find(methods, method) == methods.end()) methods.push_back(method);
  }
  return methods;
}

std::optional<ClosestLines> typed_engine(std::string_view name) {
  const auto found = std::ranges::find(engine_names, name);
  return found == engine_names.end() ? std::nullopt
                                     : std::optional(static_cast<ClosestLines>(found - engine_names.begin()));
}

std::vector<std::string> words_of(std::string_view list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    words.emplace_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

bool is_mesh_name(const std::string& path) {
  const std::string ending = files::extension(path);
  return ending == "xyz" || ending == "pts" || files::is_mesh_name(path) ||
         files::is_mesh_name(path.substr(0, path.find('#')));
}

bool is_cases_name(const std::string& path) {
  constexpr std::string_view cases[] = {"jsonl", "ndjson", "json"};
  return std::ranges::find(cases, files::extension(path)) != std::end(cases);
}

std::string unless(bool good, std::string_view expected, const std::string& text) {
  return good ? "" : fmt::format("expected {}, found {}", expected, kernels::shown(text));
}

std::string wrong_integer(const std::string& text, std::uint64_t low, std::uint64_t high) {
  const std::string highest = high == UINT64_MAX ? "2^64 - 1" : std::to_string(high);
  return unless(typed_integer(text, low, high).has_value(), fmt::format("an integer from {} to {}", low, highest),
                text);
}

std::string wrong_count(const std::string& text) {
  return unless(typed_integer(text).has_value(), "a number of at least 0", text);
}
std::string wrong_optima(const std::string& text) {
  return unless(typed_integer(text, 1).has_value(), "an integer from 1 on", text);
}
std::string wrong_threads(const std::string& text) { return wrong_integer(text, 1, most_threads); }
std::string wrong_digits(const std::string& text) { return wrong_integer(text, 1, most_root_digits); }
std::string wrong_bits(const std::string& text) { return wrong_integer(text, 1, most_bound_bits); }

std::string wrong_delta(const std::string& text) {
  const auto value = typed_number(text);
  return unless(value && *value >= approximate::least_delta, "a positive number such as 1/100, 1e-9 or more", text);
}

std::string wrong_point(const std::string& text) {
  return unless(typed_point(text) || typed_point(text, 2), "three numbers such as 1,0,-1/2, in the plane two", text);
}

std::string wrong_vector(const std::string& text) {
  return unless(typed_vector(text) || typed_vector(text, 2),
                "three numbers such as 1,0,-1/2, in the plane two, not all zero", text);
}

std::string wrong_motion(const std::string& text) {
  return unless(typed_motion(text, 3) || typed_motion(text, 2),
                "three numbers such as 1,0,-1/2, or six, not all zero; in the plane two or three", text);
}

std::string wrong_joints(const std::string& text) {
  return unless(files::parse_joints(text).has_value(),
                "joints with their values, each once, such as shoulder=1/2,elbow=-0.3", text);
}

std::string wrong_twist(const std::string& text) {
  return unless(typed_twist(text, 3) || typed_twist(text, 2),
                "six numbers such as 1,0,0,0,0,-1/2, not all zero; in the plane three", text);
}

std::string wrong_sizes(const std::string& text) {
  const std::string expected =
      fmt::format("a range such as 10..10000, or sizes from small to large such as 10,20,50, of 1 to {}", largest_size);
  return unless(typed_sizes(text).has_value(), expected, text);
}

std::string wrong_time(const std::string& text) {
  const auto time = bare_number(text);
  return unless(time && *time > 0, "a number of seconds above 0", text);
}

std::string wrong_tolerance(const std::string& text) {
  const auto value = bare_number(text);
  return unless(value && *value >= 0, "a number of at least 0, such as 1e-6 or 1/1000", text);
}

std::string wrong_fit(const std::string& text) {
  const auto size = bare_number(text);
  return unless(size && *size > 0, "a number above 0, such as 64", text);
}

std::string wrong_policy(const std::string& text) {
  return unless(judging::policy_of(text).has_value(), "declared, minimum, separating or within=P%, such as within=5%",
                text);
}

std::string wrong_second_method(const std::string& text) {
  return unless(solve::second_method(text).has_value(), "exact or naive", text);
}

namespace {

constexpr std::size_t shortest = 3, longest = 60;  // lengths of words for which a suggestion is sought

/// Returns whether no shell changes the word.
bool is_plain(const std::string& word) {
  constexpr std::string_view others = "-_./,:=+%@";
  const auto plain = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           others.find(c) != std::string_view::npos;
  };
  return !word.empty() && std::ranges::all_of(word, plain);
}

}  // namespace

std::string did_you_mean(const std::string& typed, std::span<const std::string> words) {
  if (words.empty() || typed.size() > longest) return "";
  const auto begins = [&typed](const std::string& word) { return typed.size() >= shortest && word.starts_with(typed); };
  const auto slips = [&typed](const std::string& word) { return kernels::slips(typed, word); };
  const std::string& nearest = *std::ranges::min_element(words, {}, slips);
  const bool only = std::ranges::count_if(words, begins) == 1;
  if (!only && !kernels::is_near(typed, nearest)) return "";
  return "; did you mean '" + (only ? *std::ranges::find_if(words, begins) : nearest) + "'?";
}

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'') result += "'\\''";
    else result += c;
  }
  return result + '\'';
}

std::string shell_line(std::span<const std::string> words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : " ") + (is_plain(word) ? word : quoted(word));
  return result;
}

}  // namespace fathom::cli
