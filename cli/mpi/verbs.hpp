// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that several processes share. Every rank calls the same function with the same words; rank 0 alone prints.
#pragma once

#include <string>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/io/output.hpp"
#include "cli/mpi/ranks.hpp"

namespace fathom::cli {

/// Takes the words behind "golden".
ExitCode golden_by_ranks(const Processes& world, const std::vector<std::string>& words);

/// certify, with a subject of its own for each rank.
ExitCode certify_by_ranks(const Processes& world, const Request& request);

/// depth on a stream: blocks of cases, each answered by one rank.
ExitCode depth_by_ranks(const Processes& world, const Request& request);

/// Threads for each process, unless the user says: the cores of this machine, shared by the processes on it.
unsigned usual_jobs();

}  // namespace fathom::cli
