// SPDX-License-Identifier: GPL-3.0-or-later
// The options of golden data. They have a file of their own because the program fathom-depth does
// not have them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <utility>

#include "cli/args/arguments.hpp"
#include "cli/args/values.hpp"
#include "kernels/messages.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::cli {
namespace {

std::string wrong_level(const std::string& text) {
  return unless(golden::find_level(text).has_value(), "L0, L1, L2, L3, P0, P1, U0 or C0", text);
}
std::string wrong_part(const std::string& text) {
  return unless(typed_part(text).has_value(), "i/n with 1 <= i <= n", text);
}
std::string wrong_format(const std::string& text) {
  return unless(golden::find_export_format(text).has_value(), "c, csv, json or rust", text);
}
std::string wrong_positive(const std::string& text) {
  return unless(typed_integer(text, 1).has_value(), "a positive integer", text);
}
std::string wrong_binary(const std::string& text) {
  return unless(text == "binary32" || text == "binary64", "binary32 or binary64", text);
}

/// Returns a sentence on the first word of the list that is unknown, with a suggestion, or "".
std::string wrong_words(const std::string& list, const std::vector<std::string>& known, std::string_view expected) {
  for (const std::string& word : words_of(list)) {
    const bool pattern = word.find_first_of("*?[") != word.npos;
    const auto same = [&](const std::string& other) {
      return pattern ? ::fnmatch(word.c_str(), other.c_str(), 0) == 0 : word == other;
    };
    if (std::ranges::any_of(known, same)) continue;
    const auto meant =
        std::ranges::find_if(known, [&word](const std::string& other) { return kernels::is_near(word, other); });
    return fmt::format("expected {}, found {}{}", expected, kernels::shown(word),
                       meant == known.end() ? fmt::format(" (there are {})", fmt::join(known, ", "))
                                            : fmt::format(" (did you mean {}?)", *meant));
  }
  return "";
}

/// Returns the kinds of contact that facets of P have: others occur only for bodies that do not
/// overlap.
std::vector<std::string> kinds_of_contact() {
  std::vector<std::string> known;
  for (int kind = 0; kind <= static_cast<int>(ContactKind::edge_edge); ++kind)
    known.emplace_back(name(static_cast<ContactKind>(kind)));
  return known;
}

std::string wrong_flags(const std::string& list) {
  return wrong_words(list, golden::words_of_cases(), "flags of golden data, or a status");
}
std::string wrong_families(const std::string& list) {
  return wrong_words(list, golden::groups_of_releases(), "families, catalogue or real");
}
std::string wrong_contacts(const std::string& list) {
  return wrong_words(list, kinds_of_contact(), "kinds of contact");
}

std::vector<Option> make_table() {
  const Values flags{wrong_flags, golden::words_of_cases()};
  return {
      {"golden generate",
       "--level",
       "LEVEL",
       "L0, L1, L2 or L3, of polytopes: hundreds of records, about ten thousand,\nover a hundred thousand, about ten "
       "million; P0 or P1, of "
       "shapes: about a\nthousand, about ten thousand; each holds the shards of those below it;\nU0, of unions of "
       "convex pieces: hundreds; C0, with where the bodies touch: hundreds",
       {wrong_level, {"L0", "L1", "L2", "L3", "P0", "P1", "U0", "C0"}},
       FileUse::none,
       Repeats::never,
       true},
      {"golden generate", "--seed", "N", "of the families; 1 unless given", {wrong_integer<0, UINT64_MAX>}},
      {"golden generate", "--out", "DIR", "the folder, made if need be", {}, FileUse::folder, Repeats::never, true},
      {"golden generate",
       "--shard",
       "I/N",
       "make every n-th shard only, from the i-th on, and leave it to a last run\nwithout --shard to complete the "
       "release",
       {wrong_part}},
      {"golden verify,golden export", "folder", "", ""},
      {"golden verify",
       "--method",
       "NAME",
       "compute every record again by exact (AGHRS's pipeline) or naive (the hull\nof all vertex differences) too, and "
       "compare every "
       "field; "
       "may be repeated",
       {wrong_second_method, {"exact", "naive"}},
       FileUse::none,
       Repeats::each},
      {"golden verify", "--state", "", "once all agree, write agreement.json into the folder, which says so"},
      {"golden generate,golden verify",
       "--jobs",
       "N",
       "threads; as many as there are cores unless given",
       {wrong_threads}},
      {"golden export",
       "--format",
       "FORMAT",
       "c (C89 and C++), rust, json or csv",
       {wrong_format, {"c", "csv", "json", "rust"}},
       FileUse::none,
       Repeats::never,
       true},
      {"golden export", "--only", "FLAGS", "take only records with one of these flags, as for --exclude", flags,
       FileUse::none, Repeats::lists},
      {"golden export", "--exclude", "FLAGS",
       "leave out records with one of these flags, separated by commas:\nflat_a, ties, ..., or their first word: flat, "
       "huge; or of a\n"
       "status: penetrating, touching, disjoint",
       flags, FileUse::none, Repeats::lists},
      {"golden export",
       "--family",
       "NAMES",
       "take only records of these families, separated by commas:\nfar_boxes, 'touching_*', ..., catalogue, real",
       {wrong_families, golden::groups_of_releases()},
       FileUse::none,
       Repeats::lists},
      {"golden export",
       "--contact",
       "KINDS",
       "take only records with a shortest way out of one of these kinds:\nedge-edge, facet-vertex (of A, of B), ...",
       {wrong_contacts, kinds_of_contact()},
       FileUse::none,
       Repeats::lists},
      {"golden export",
       "--exact-in",
       "FORMAT",
       "take only points that are numbers of binary32, or of binary64, as all\nare",
       {wrong_binary, {"binary32", "binary64"}}},
      {"golden export", "--max-points", "N", "leave out records with more points in a body", {wrong_positive}},
      {"golden export",
       "--count",
       "N",
       "so many of the others, spread evenly over the families; all unless\ngiven",
       {wrong_positive}},
      {"golden export",
       "--certificates",
       "FILE",
       "write the certificates of all cases in the export to this file",
       {},
       FileUse::written},
  };
}

}  // namespace

std::span<const Option> golden_options() {
  static const std::vector<Option> table = make_table();
  return table;
}

}  // namespace fathom::cli
