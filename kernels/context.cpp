// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/context.hpp"

namespace fathom::kernels {

void Context::report(std::string_view stage, double share) {
  if (monitor_ != nullptr) monitor_->report(stage, share);
  check();
}

void Context::check() {
  if (monitor_ != nullptr && monitor_->stopped()) *stopped_ = true;
  if (*stopped_) throw Interrupted();
}

Context Context::worker() const {
  Context worker;
  worker.stopped_ = stopped_;
  return worker;
}

void Context::join(const Context& worker) { counters += worker.counters; }

}  // namespace fathom::kernels
