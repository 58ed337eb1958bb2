// SPDX-License-Identifier: GPL-3.0-or-later
// One function for each command. Each fills a struct of its own from the options, which the parser
// has checked against the table.
#pragma once

#include <string>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// Runs the command. The two programs differ here: every_command.cpp belongs to fathom,
/// depth_alone.cpp to fathom-depth.
ExitCode run_command(const Given& given);

/// Returns the part to build for the command beside the program, under its name in ./fathom, or "".
std::string part_needed(const Given& given);

/// These functions throw InputError, OutputError, Interrupted; any other exception is an internal
/// error.
ExitCode run_depth(const Given& given);
/// depth --along
ExitCode run_along(const Given& given);
ExitCode run_width(const Given& given);
ExitCode run_approx(const Given& given);
ExitCode run_ray(const Given& given);
ExitCode run_metric(const Given& given);
ExitCode run_impact(const Given& given);
ExitCode run_study(const Given& given);
/// study --sweep
ExitCode run_sweep(const Given& given);
ExitCode run_stages(const Given& given);
ExitCode run_explain(const Given& given);
ExitCode run_solid(const Given& given);
ExitCode run_robot(const Given& given);
ExitCode run_cases(const Given& given);
ExitCode run_certify(const Given& given);
/// Implements `certify --claims FILE`: judges published statements about pairs of bodies. Returns 1
/// if a claim is wrong.
ExitCode run_claims(const Given& given);
/// certify diff
ExitCode run_diff(const Given& given);

/// These functions parse the rest of the words themselves, and print errors in them.
ExitCode run_check(const Given& given);
/// Returns whether the words after `check` ask for the checker that was extracted from the Coq
/// proof.
bool asks_for_proved(const std::vector<std::string>& words);
ExitCode run_golden(const Given& given);
/// `help`, `man` and `completion`.
ExitCode run_help(const Given& given);

}  // namespace fathom::cli
