// SPDX-License-Identifier: GPL-3.0-or-later
// One function per command.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// Runs the command of the request, or the one of this name, which parses the words behind it
/// itself. The two programs differ here: every_command.cpp belongs to fathom, depth_alone.cpp to
/// fathom-depth.
ExitCode run_command(const Request& request);
ExitCode run_command(std::string_view name, const std::vector<std::string>& words);

/// These throw InputError, OutputError, Interrupted; any other exception is an internal error.
ExitCode run_depth(const Request& request);
/// depth --along
ExitCode run_along(const Request& request);
ExitCode run_width(const Request& request);
ExitCode run_approx(const Request& request);
ExitCode run_ray(const Request& request);
ExitCode run_metric(const Request& request);
ExitCode run_study(const Request& request);
ExitCode run_stages(const Request& request);
/// study --sweep
ExitCode run_sweep(const Request& request);
ExitCode run_explain(const Request& request);
ExitCode run_cases(const Request& request);
ExitCode run_certify(const Request& request);

/// Takes the words behind "certify diff".
ExitCode run_diff(const std::vector<std::string>& words);

/// Takes the words behind "check"; prints itself what is wrong with them.
ExitCode run_check(std::vector<std::string> words);

/// Takes the words behind "golden".
ExitCode run_golden(const std::vector<std::string>& words);

/// `help`, `man` and `completion`, with the words behind them.
ExitCode run_help(std::string_view name, const std::vector<std::string>& words);

/// fathom certify --claims FILE: judges what was published about pairs of bodies. Returns 1 if a
/// claim is wrong. Throws InputError if the file cannot be read, OutputError, Interrupted.
ExitCode judge_claims(const Request& request);

}  // namespace fathom::cli
