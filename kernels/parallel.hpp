// SPDX-License-Identifier: GPL-3.0-or-later
// Two pieces of work that do not depend on each other, in two threads.
#pragma once

#include <functional>

#include "kernels/context.hpp"

namespace fathom {

/// Calls both, in two threads if it is `worth_it`, else one after the other. `first` is handed `context`; so is `second`, unless it runs in
/// a thread of its own: then it is handed a worker of it, which is joined. When this returns or throws, nothing runs any more. If `first`
/// throws, that exception is passed on, else one of `second`.
void run_both(bool worth_it, Context& context, const std::function<void(Context&)>& first, const std::function<void(Context&)>& second);

}  // namespace fathom
