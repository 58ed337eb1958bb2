// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/export_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/parser_words.hpp"
#include "kernels/near_miss.hpp"
#include "kernels/printable.hpp"

namespace fathom::cli {
namespace {

std::optional<std::size_t> positive(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value > 0 ? std::optional(value) : std::nullopt;
}

std::string check_positive(const std::string& text) {
  return positive(text) ? "" : fmt::format("expected a positive integer, found {}", kernels::shown(text));
}

std::string check_export_format(const std::string& text) {
  return golden::find_export_format(text) ? "" : fmt::format("expected c, csv, json or rust, found {}", kernels::shown(text));
}

std::vector<std::string> words_in(std::string_view list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    words.emplace_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// What is wrong with the words of --exclude: the first that excludes nothing, and the one that is meant.
std::string check_excluded(const std::string& list) {
  const std::vector<std::string> known = golden::excludable();
  for (const std::string& word : words_in(list)) {
    if (std::ranges::find(known, word) != known.end()) continue;
    const auto meant = std::ranges::find_if(known, [&word](const std::string& other) { return kernels::is_near(word, other); });
    return fmt::format(
        "expected flags of golden data, or a status, found {}{}", kernels::shown(word),
        meant == known.end() ? fmt::format(" (there are {})", fmt::join(known, ", ")) : fmt::format(" (did you mean {}?)", *meant));
  }
  return "";
}

}  // namespace

void add_export_options(CLI::App& app, golden::ExportRequest& request) {
  app.add_option_function<std::string>(
         "--format", [&request](const std::string& text) { request.format = *golden::find_export_format(text); },
         "c (C89 and C++), rust, json or csv")
      ->check(one_of({"c", "csv", "json", "rust"}, check_export_format))
      ->type_name("FORMAT")
      ->required();
  app.add_option_function<std::string>(
         "--exclude", [&request](const std::string& list) { request.excluded = words_in(list); },
         "leave out records with one of these flags, separated by commas:\nflat_a, ties, ..., or their first word: flat, huge; or of a\n"
         "status: penetrating, touching, disjoint")
      ->check(CLI::Validator(check_excluded, "", ""))
      ->type_name("FLAGS");
  app.add_option_function<std::string>(
         "--max-points", [&request](const std::string& text) { request.most_points = *positive(text); },
         "leave out records with more points in a body")
      ->check(CLI::Validator(check_positive, "", ""))
      ->type_name("N");
  app.add_option_function<std::string>(
         "--count", [&request](const std::string& text) { request.count = *positive(text); },
         "so many of the others, spread evenly over the families; all unless\ngiven")
      ->check(CLI::Validator(check_positive, "", ""))
      ->type_name("N");
}

}  // namespace fathom::cli
