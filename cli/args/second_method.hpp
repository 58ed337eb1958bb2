// SPDX-License-Identifier: GPL-3.0-or-later
// The option --method of commands that compute their answers in two ways.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cli/args/parser_words.hpp"
#include "kernels/messages.hpp"
#include "reference/solve/disagreement.hpp"

namespace fathom::cli {

/// Adds --method NAME, which may be repeated; each method is listed once, in the order of the words.
inline void add_second_method(CLI::App& app, std::vector<Method>& methods, const std::string& meaning) {
  const auto check = [](const std::string& word) {
    return solve::second_method(word) ? "" : fmt::format("expected exact or naive, found {}", kernels::shown(word));
  };
  const auto take = [&methods](const std::string& word) {
    const Method method = *solve::second_method(word);
    if (std::find(methods.begin(), methods.end(), method) == methods.end()) methods.push_back(method);
  };
  app.add_option_function<std::string>("--method", take, meaning)
      ->check(one_of({"exact", "naive"}, check))
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->trigger_on_parse()
      ->type_name("NAME");
}

}  // namespace fathom::cli
