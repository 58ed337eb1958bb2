// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/in_order.hpp"

#include <sys/resource.h>

namespace fathom::cli {

unsigned usual_threads() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) return 1;
  return static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
}

}  // namespace fathom::cli
