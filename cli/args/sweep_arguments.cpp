// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/sweep_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "cli/args/parser_words.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr unsigned largest_size = 1'000'000;
constexpr const char* usual_sizes = "10..1000";

std::optional<unsigned> size_of(std::string_view text) {
  unsigned size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && size >= 1 && size <= largest_size ? std::optional(size) : std::nullopt;
}

/// Both ends, and 1, 2 and 5 times the powers of ten between them.
std::optional<std::vector<unsigned>> range_of(std::string_view low_text, std::string_view high_text) {
  const std::optional<unsigned> low = size_of(low_text), high = size_of(high_text);
  if (!low || !high || *low > *high) return std::nullopt;
  std::vector<unsigned> sizes{*low};
  for (unsigned decade = 1; decade <= largest_size; decade *= 10)
    for (const unsigned factor : {1U, 2U, 5U})
      if (factor * decade > *low && factor * decade < *high) sizes.push_back(factor * decade);
  if (*high > *low) sizes.push_back(*high);
  return sizes;
}

/// "10..10000", or "10,20,50": ascending.
std::optional<std::vector<unsigned>> sizes_of(std::string_view text) {
  if (const std::size_t dots = text.find(".."); dots != text.npos) return range_of(text.substr(0, dots), text.substr(dots + 2));
  std::vector<unsigned> sizes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::optional<unsigned> size = size_of(text.substr(begin, end - begin));
    if (!size || (!sizes.empty() && *size <= sizes.back())) return std::nullopt;
    sizes.push_back(*size);
    begin = end + 1;
  }
  return sizes;
}

std::string check_sizes(const std::string& text) {
  if (sizes_of(text)) return "";
  return fmt::format("expected a range such as 10..10000, or sizes from small to large such as 10,20,50, of 1 to {}, found {}",
                     largest_size, kernels::shown(text));
}

}  // namespace

void add_sweep_options(CLI::App& app, Request& request) {
  app.add_option("--sweep", request.sweep.family,
                 "instead of two bodies: how crossings, canonical subsets and work grow with the size of this family's pairs, by the exact "
                 "method; `fathom cases --list` names the families")
      ->type_name("FAMILY");
  app.add_option_function<std::string>(
         "--sizes", [&request](const std::string& text) { request.sweep.sizes = *sizes_of(text); },
         fmt::format("with --sweep: about so many points a body. LOW..HIGH takes 1, 2 and 5 times the powers of ten in between; {} unless "
                     "given",
                     usual_sizes))
      ->check(CLI::Validator(check_sizes, "", ""))
      ->type_name("LOW..HIGH");
  app.add_option_function<std::vector<std::string>>(
         "--closest-lines",
         [&request](const std::vector<std::string>& names) {
           for (const std::string& name : names)
             request.sweep.engines.push_back(static_cast<ClosestLines>(std::ranges::find(engine_names, name) - engine_names.begin()));
         },
         "with --sweep: the pairs of lines that these engines evaluate, side by side: cutting, sampled, naive (all pairs of lines)")
      ->delimiter(',')
      ->check(one_of({engine_names.begin(), engine_names.end()}))
      ->type_name("NAME,...");
  app.add_flag("--times", request.times, "with --sweep: add the seconds that each size took, which differ from run to run");
}

std::string wrong_sweep(const CLI::App& study, Request& request) {
  const auto given = [&](const char* option) { return study.count(option) > 0; };
  if (!given("--sweep")) {
    for (const char* option : {"--sizes", "--closest-lines", "--times", "--svg", "--seed"})
      if (given(option)) return fmt::format("{} goes with --sweep FAMILY", option);
    return "";
  }
  if (!request.inputs.empty()) return "--sweep makes its bodies itself, found " + kernels::shown(request.inputs[0]);
  for (const char* option :
       {"--json", "--html", "--case", "--all", "--pose-a", "--pose-b", "--require-convex", "--exact-decimals", "--threads"})
    if (given(option)) return fmt::format("--sweep answers as a table, with --csv and --svg, and cannot be combined with {}", option);
  if (request.sweep.sizes.empty()) request.sweep.sizes = *sizes_of(usual_sizes);
  return "";
}

}  // namespace fathom::cli
