// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `approx`, `ray`, `metric` and `width --delta`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "cli/args/request.hpp"

namespace fathom::cli {

/// Three numbers with commas between them, not all zero: decimals are exact. Returns nullopt for anything else.
std::optional<Point> typed_vector(std::string_view text);
/// What is wrong with such a text, or "".
std::string check_vector(const std::string& text);

void add_delta(CLI::App& app, Request& request, const std::string& meaning);
void add_approx_options(CLI::App& app, Request& request);
void add_ray_options(CLI::App& app, Request& request);
void add_metric_options(CLI::App& app, Request& request);

/// Returns what is missing or contradicts itself, or "". `exact_options`: whether options of the exact methods were given. Sets the
/// defaults of `approx`.
std::string wrong_approximation(Request& request, bool exact_options);

}  // namespace fathom::cli
