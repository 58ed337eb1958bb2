// SPDX-License-Identifier: GPL-3.0-or-later
// Starting a shell command whose three standard streams are pipes of ours.
#pragma once

#include <sys/types.h>

#include <string>

namespace fathom::harness {

struct Spawned {
  pid_t id = -1;
  int input = -1, output = -1, errors = -1;  ///< our ends: non-blocking, closed on exec
  int inlet = -1;                            ///< its own end of the input, to see how much of it is unread; closed on exec
};

/// Puts "exec" before a simple command (no lists, pipelines or substitutions) whose program exists. Then no shell stays behind, which
/// would hold the streams open that the program closes.
std::string without_shell(const std::string& command);

/// Runs `/bin/sh -c without_shell(command)` in a process group of its own, with default signal actions, an empty signal mask, and no other
/// open file. The kernel kills it if the calling thread ends first. Throws std::system_error.
Spawned spawn(const std::string& command);

}  // namespace fathom::harness
