// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/along_arguments.hpp"

#include <fmt/format.h>

#include <charconv>

#include "cli/args/approx_arguments.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::uint32_t most_steps = 1'000'000;

std::optional<std::uint32_t> steps_of(const std::string& text) {
  std::uint32_t steps = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), steps);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && steps >= 1 && steps <= most_steps ? std::optional(steps) : std::nullopt;
}

std::string check_steps(const std::string& text) {
  return steps_of(text) ? "" : fmt::format("expected an integer from 1 to {}, found {}", most_steps, kernels::shown(text));
}

/// What a curve of signed depths has no place for.
constexpr const char* of_one_answer[] = {"--optima", "--digits",   "--certificate", "--embed-certificate",
                                         "--exact",  "--counters", "--threads"};

}  // namespace

void add_along_options(CLI::App& app, Request& request) {
  app.add_option_function<std::string>(
         "--along", [&request](const std::string& text) { request.along.translation = typed_vector(text); },
         "the signed depth along a path instead: A is moved by s X,Y,Z for s from 0 to 1. It is positive while the bodies penetrate, 0 "
         "when "
         "they touch, and minus the distance when they are apart: one continuous curve, exact at each step")
      ->check(CLI::Validator(check_vector, "", ""))
      ->type_name("X,Y,Z");
  app.add_option_function<std::string>(
         "--steps", [&request](const std::string& text) { request.along.steps = *steps_of(text); },
         "with --along: how many steps the path has; 32 unless given")
      ->check(CLI::Validator(check_steps, "", ""))
      ->type_name("N");
  app.add_flag("--csv", request.csv, "with --along: a header, then one row for each place");
}

std::string wrong_along(const CLI::App& depth, const Request& request) {
  const auto given = [&](const char* option) { return depth.count(option) > 0; };
  if (!request.along.translation) {
    for (const char* option : {"--steps", "--csv"})
      if (given(option)) return fmt::format("{} goes with --along X,Y,Z", option);
    return "";
  }
  for (const char* option : of_one_answer)
    if (given(option)) return fmt::format("--along answers with a curve of signed depths, and cannot be combined with {}", option);
  if (given("--method") && depth.get_option("--method")->as<std::string>() == "shallow")
    return "--along answers for bodies that are apart too, and cannot be combined with --method shallow";
  return "";
}

}  // namespace fathom::cli
