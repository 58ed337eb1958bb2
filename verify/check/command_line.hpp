// SPDX-License-Identifier: Apache-2.0
// The command line of fathom-check, for its own program and for others that offer it as a command.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom_check {

class SecondChecker;
class Workers;

/// An option of the command line, for help.
struct OptionText {
  std::string_view name, value, meaning;
};
inline constexpr OptionText option_texts[] = {
    {"--case", "CASES",
     "also refuse a certificate whose points are not those of\nyour case (JSON, schema fathom/case/1 "
     "or\nfathom/golden-export/1; of "
     "several cases, the one with\nthe certificate's id)"},
    {"--width", "",
     "also refuse a certificate whose b is not a again: its\ndepth is the width of a; --case then compares a alone"},
    {"--results", "FILE", "JSON Lines, each with a certificate in its field\n\"certificate\""},
    {"--echo", "", "print the bodies and the claim as they were read, in\nlines that begin with c"},
    {"--help", "", "print help"},
};

/// Understands the words behind the program's name, checks, prints to the standard streams.
/// `program` is for messages. Returns the exit code; does not throw. `second`, if given, must
/// accept as well; `workers`, if given, check several certificates at once. Where GMP would abort
/// for lack of memory, the process ends with 2.
int command_line(const std::vector<std::string>& words, const std::string& program, SecondChecker* second = nullptr,
                 Workers* workers = nullptr) noexcept;

}  // namespace fathom_check
