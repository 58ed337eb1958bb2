// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/in_order.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <optional>

namespace fathom::cli {

namespace {

constexpr rlim_t of_a_thread = rlim_t{128}
                               << 20;  // bytes of address space for each thread: its stack, its heap, and its items

std::optional<rlim_t> limit_of_addresses() {
  rlimit limit{};
  const bool limited = ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::optional(limit.rlim_cur) : std::nullopt;
}

}  // namespace

unsigned usual_threads() {
  return limit_of_addresses() ? 1 : static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
}

unsigned possible_threads(unsigned asked) {
  const std::optional<rlim_t> limit = limit_of_addresses();
  return limit ? static_cast<unsigned>(std::clamp<rlim_t>(*limit / of_a_thread, 1, asked)) : asked;
}

}  // namespace fathom::cli
