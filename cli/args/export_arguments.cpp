// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/export_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/named_files.hpp"
#include "cli/args/parser_words.hpp"
#include "fathom/depth.hpp"
#include "kernels/messages.hpp"

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

/// What is wrong with words of a list: the first that is not known, and the one that is meant.
std::string check_words(const std::string& list, const std::vector<std::string>& known, std::string_view expected) {
  for (const std::string& word : words_in(list)) {
    const bool pattern = word.find_first_of("*?[") != word.npos;
    const auto same = [&](const std::string& other) { return pattern ? ::fnmatch(word.c_str(), other.c_str(), 0) == 0 : word == other; };
    if (std::ranges::any_of(known, same)) continue;
    const auto meant = std::ranges::find_if(known, [&word](const std::string& other) { return kernels::is_near(word, other); });
    return fmt::format(
        "expected {}, found {}{}", expected, kernels::shown(word),
        meant == known.end() ? fmt::format(" (there are {})", fmt::join(known, ", ")) : fmt::format(" (did you mean {}?)", *meant));
  }
  return "";
}

std::string check_flags(const std::string& list) {
  return check_words(list, golden::words_of_cases(), "flags of golden data, or a status");
}

std::string check_families(const std::string& list) {
  return check_words(list, golden::groups_of_releases(), "families, catalogue or real");
}

/// Those of facets of P: others occur only where bodies do not overlap.
std::vector<std::string> kinds_of_contact() {
  std::vector<std::string> known;
  for (int kind = 0; kind <= static_cast<int>(ContactKind::edge_edge); ++kind) known.emplace_back(name(static_cast<ContactKind>(kind)));
  return known;
}

std::string check_contacts(const std::string& list) { return check_words(list, kinds_of_contact(), "kinds of contact"); }

std::string check_binary(const std::string& text) {
  return text == "binary32" || text == "binary64" ? "" : fmt::format("expected binary32 or binary64, found {}", kernels::shown(text));
}

/// An option that takes some of the known words, separated by commas; each time it is given more of them.
void add_words(CLI::App& app, const std::string& option, std::vector<std::string>& words, std::vector<std::string> known,
               std::string (*check)(const std::string&), const std::string& type, const std::string& about) {
  app.add_option_function<std::vector<std::string>>(
         option,
         [&words](const std::vector<std::string>& lists) {
           for (const std::string& list : lists)
             for (std::string& word : words_in(list)) words.push_back(std::move(word));
         },
         about)
      ->check(one_of(std::move(known), check))
      ->allow_extra_args(false)  // the next word is the folder
      ->type_name(type);
}

}  // namespace

void add_export_options(CLI::App& app, golden::ExportRequest& request, std::string& certificates) {
  app.add_option_function<std::string>(
         "--format", [&request](const std::string& text) { request.format = *golden::find_export_format(text); },
         "c (C89 and C++), rust, json or csv")
      ->check(one_of({"c", "csv", "json", "rust"}, check_export_format))
      ->type_name("FORMAT")
      ->required();
  add_words(app, "--only", request.only, golden::words_of_cases(), check_flags, "FLAGS",
            "take only records with one of these flags, as for --exclude");
  add_words(app, "--exclude", request.excluded, golden::words_of_cases(), check_flags, "FLAGS",
            "leave out records with one of these flags, separated by commas:\nflat_a, ties, ..., or their first word: flat, huge; or of a\n"
            "status: penetrating, touching, disjoint");
  add_words(app, "--family", request.families, golden::groups_of_releases(), check_families, "NAMES",
            "take only records of these families, separated by commas:\nfar_boxes, 'touching_*', ..., catalogue, real");
  add_words(app, "--contact", request.contacts, kinds_of_contact(), check_contacts, "KINDS",
            "take only records with a shortest way out of one of these kinds:\nedge-edge, facet-vertex (of A, of B), ...");
  app.add_option_function<std::string>(
         "--exact-in", [&request](const std::string& text) { request.exact_in = text; },
         "take only points that are numbers of binary32, or of binary64, as all\nare")
      ->check(one_of({"binary32", "binary64"}, check_binary))
      ->type_name("FORMAT");
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
  names_file(app.add_option_function<std::string>(
                 "--certificates",
                 [&request, &certificates](const std::string& path) {
                   certificates = path;
                   request.certificates = true;
                 },
                 "write the certificates of all cases in the export to this file"),
             FileUse::written)
      ->type_name("FILE");
}

}  // namespace fathom::cli
