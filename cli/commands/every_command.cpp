// SPDX-License-Identifier: GPL-3.0-or-later
// What the program fathom runs: every command.
#include "cli/commands/command.hpp"

namespace fathom::cli {

ExitCode run_command(const Request& request) {
  switch (request.command) {
    case Command::depth: return run_depth(request);
    case Command::width: return run_width(request);
    case Command::approx: return run_approx(request);
    case Command::ray: return run_ray(request);
    case Command::metric: return run_metric(request);
    case Command::study: return run_study(request);
    case Command::stages: return run_stages(request);
    case Command::explain: return run_explain(request);
    case Command::cases: return run_cases(request);
    case Command::certify: return run_certify(request);
  }
  return internal_error;
}

ExitCode run_command(std::string_view name, const std::vector<std::string>& words) {
  if (name == "certify diff") return run_diff(words);
  if (name == "check") return run_check(words);
  return name == "golden" ? run_golden(words) : run_help(name, words);
}

}  // namespace fathom::cli
