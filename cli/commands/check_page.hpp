// SPDX-License-Identifier: GPL-3.0-or-later
// The page of help about `fathom check`: the options of the checker, and those that are this program's.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "cli/args/help.hpp"
#include "verify/check/command_line.hpp"

namespace fathom::cli {

inline HelpPage check_page() {
  HelpPage page{*std::ranges::find(command_table, "check", &CommandHelp::name), {}};
  for (const auto& [name, value, meaning] : fathom_check::option_texts) {
    OptionHelp option{{std::string(name)}, std::string(value), std::string(meaning)};
    if (name == "--help") option.names.insert(option.names.begin(), "-h");
    page.options.push_back(std::move(option));
  }
  page.options.push_back({{"--threads"},
                          "N",
                          "how many certificates are checked at once; as many as there are cores unless given. The output is the same "
                          "with any number"});
  page.options.push_back({{"--proved"},
                          "",
                          "by the checker that was extracted from the Coq proof: alone, or with --case, --results, --echo and --width "
                          "after this one"});
  return page;
}

}  // namespace fathom::cli
