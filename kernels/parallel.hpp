// SPDX-License-Identifier: GPL-3.0-or-later
// Two pieces of work that do not depend on each other, in two threads.
#pragma once

#include <functional>

namespace fathom {

/// Calls both, in two threads if it is `worth_it`, else one after the other. When it returns or throws, nothing runs any more, and what
/// either has counted is in the caller's predicate_counts(). If `first` throws, that exception is passed on, else one of `second`.
void run_both(bool worth_it, const std::function<void()>& first, const std::function<void()>& second);

}  // namespace fathom
