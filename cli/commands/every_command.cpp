// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program fathom: all of them.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "cli/commands/command.hpp"
#include "cli/commands/names.hpp"

namespace fathom::cli {

ExitCode run_command(const Given& given) {
  using Run = ExitCode (*)(const Given&);
  static constexpr std::pair<std::string_view, Run> commands[] = {
      {"depth", run_depth},     {"width", run_width},       {"approx", run_approx},  {"ray", run_ray},
      {"metric", run_metric},   {"impact", run_impact},     {"study", run_study},    {"stages", run_stages},
      {"explain", run_explain}, {"solid", run_solid},       {"robot", run_robot},    {"cases", run_cases},
      {"certify", run_certify}, {"certify diff", run_diff}, {"check", run_check},    {"golden", run_golden},
      {"help", run_help},       {"man", run_help},          {"completion", run_help}};
  return std::ranges::find(commands, std::string_view(given.command), &std::pair<std::string_view, Run>::first)
      ->second(given);
}

std::string part_needed(const Given& given) {
  if (given.command == "check") return asks_for_proved(given.rest) ? "proved" : "";
  const std::string words = given.command == "certify" ? given.text("--adapter") : "";
  const Adapter* const adapter = adapter_named(words);
  if (!adapter) return "";
  if (!adapter->program.ends_with(".mjs")) return "subjects";
  return words.find(",version=") == std::string::npos ? "web" : "web-history";
}

}  // namespace fathom::cli
