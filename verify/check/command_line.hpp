// SPDX-License-Identifier: Apache-2.0
// The command line of fathom-check, for its own program and for others that offer it as a command.
#pragma once

#include <string>
#include <vector>

namespace fathom_check {

class SecondChecker;
class Workers;

/// Understands the words behind the program's name, checks, prints to the standard streams. `program` is for messages. Returns the exit
/// code; does not throw. `second`, if given, must accept as well; `workers`, if given, check several certificates at once. Where GMP would
/// abort for lack of memory, the process ends with 2.
int command_line(const std::vector<std::string>& words, const std::string& program, SecondChecker* second = nullptr,
                 Workers* workers = nullptr) noexcept;

}  // namespace fathom_check
