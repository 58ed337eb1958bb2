// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/cases_arguments.hpp"

#include <fmt/format.h>

#include <charconv>

#include "cli/args/named_files.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::uint64_t most_count = 1'000'000'000, most_size = 1'000'000, most_seed = UINT64_MAX;

/// An integer in plain digits.
CLI::Validator integer(std::uint64_t low, std::uint64_t high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && value >= low && value <= high) return "";
    return fmt::format("expected an integer from {} to {}, found {}", low, high == most_seed ? "2^64 - 1" : std::to_string(high),
                       kernels::shown(text));
  };
  return CLI::Validator(check, "", "");
}

bool given(const CLI::App& app, const char* option) { return app.count(option) > 0; }

}  // namespace

void add_cases_options(CLI::App& app, CasesRequest& cases) {
  app.add_option(
         "--family", cases.families,
         "cases of these families, in turn: names with commas between them, with * and ? for any letters; may be repeated; all: every one")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  app.add_option("--count", cases.count, "so many, with successive seeds (1)")->check(integer(1, most_count))->type_name("N");
  app.add_option("--seed", cases.seed, "the first seed (1)")->check(integer(0, most_seed))->type_name("N");
  app.add_option("--size", cases.size, "about so many points a body, of unions pieces (the family's usual size)")
      ->check(integer(1, most_size))
      ->type_name("N");
  using Text = std::pair<const char*, std::string>;
  for (const auto& [flag, meaning] :
       {Text{"--catalogue", "all named degenerate pairs"}, Text{"--list", "the families, with a line on each"},
        Text{"--from", "the meshes A and B as one case, vertices as read"}})
    app.add_flag(flag, meaning);
  app.add_flag("--shapes", cases.shapes,
               "after --list, --catalogue, --family all: those of round and curved bodies, not those of polytopes");
  app.add_flag("--unions", cases.unions, "likewise: those of bodies that are not convex, as unions of convex pieces");
  names_file(app.add_option("--from-fcl", cases.fcl,
                            "the failures in a log or a text of FCL (\"Error with configuration\"; -: standard input): "
                            "boxes and Convex with their poses; the placed points are rounded once to binary64"),
             FileUse::read)
      ->type_name("FILE");
}

std::string wrong_cases(const CLI::App& app, CasesRequest& cases, const std::vector<std::string>& inputs) {
  using What = CasesRequest::What;
  constexpr std::pair<const char*, What> tasks[] = {{"--family", What::family},
                                                    {"--catalogue", What::catalogue},
                                                    {"--list", What::list},
                                                    {"--from", What::from},
                                                    {"--from-fcl", What::from_fcl}};
  unsigned wanted = 0;
  for (const auto& [option, what] : tasks)
    if (given(app, option)) {
      ++wanted;
      cases.what = what;
    }
  if (wanted != 1)
    return fmt::format("cases expects one of --family, --catalogue, --list, --from and --from-fcl, found {}",
                       wanted == 0 ? "none" : "several");
  for (const char* option : {"--count", "--seed", "--size"})
    if (cases.what != What::family && given(app, option)) return fmt::format("{} goes with --family", option);
  const bool of_many = cases.what == What::catalogue || cases.what == What::list ||
                       (cases.what == What::family && cases.families == std::vector<std::string>{"all"});
  for (const auto& [option, asked] : {std::pair("--shapes", cases.shapes), std::pair("--unions", cases.unions)})
    if (asked && !of_many) return fmt::format("{} goes with --list, --catalogue and --family all", option);
  if (cases.shapes && cases.unions) return "--shapes and --unions are two kinds of bodies: ask for one after the other";
  for (const char* option : {"--pose-a", "--pose-b", "--exact-decimals"})
    if (cases.what != What::from && given(app, option)) return fmt::format("{} goes with --from", option);
  const std::size_t meshes = cases.what == What::from ? 2 : 0;
  if (inputs.size() == meshes) return "";
  return fmt::format("cases expects two meshes after --from and no input otherwise, found {} argument{}", inputs.size(),
                     inputs.size() == 1 ? "" : "s");
}

}  // namespace fathom::cli
