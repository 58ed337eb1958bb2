// SPDX-License-Identifier: GPL-3.0-or-later
// Starting a shell command whose three standard streams are pipes of ours.
#pragma once

#include <sys/types.h>

#include <string>

namespace fathom::harness {

struct Spawned {
  pid_t id = -1;
  int input = -1, output = -1, errors = -1;  ///< our ends: non-blocking, closed on exec
};

/// Runs `/bin/sh -c command` in a process group of its own, with default signal actions, an empty mask, and no other open file; the kernel
/// kills it should the calling thread end first. Throws std::system_error.
Spawned spawn(const std::string& command);

}  // namespace fathom::harness
