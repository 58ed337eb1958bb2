// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mpi/verbs.hpp"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace fathom::cli {

unsigned usual_jobs() {
  const char* const ours = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const unsigned processes = ours ? static_cast<unsigned>(std::max(1, std::atoi(ours))) : 1;
  return std::max(1U, std::thread::hardware_concurrency() / processes);
}

}  // namespace fathom::cli
