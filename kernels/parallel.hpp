// SPDX-License-Identifier: GPL-3.0-or-later
// Two pieces of work that do not depend on each other, in two threads.
#pragma once

#include <functional>

#include "kernels/context.hpp"

namespace fathom::kernels {

/// Calls both, in two threads if `worth_it`, else one after the other. `first` gets `context`; so
/// does `second`, unless it runs in its own thread: then it gets a worker of `context`, which is
/// joined. When this returns or throws, neither runs any more. If `first` throws, that exception is
/// rethrown, else that of `second`.
void run_both(bool worth_it, Context& context, const std::function<void(Context&)>& first,
              const std::function<void(Context&)>& second);

}  // namespace fathom::kernels
