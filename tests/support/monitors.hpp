// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "fathom/monitor.hpp"

namespace fathom::testing {

/// Remembers what it was told, and stops the work once it has been told `most` times.
struct Recorder final : Monitor {
  explicit Recorder(std::size_t most = std::numeric_limits<std::size_t>::max()) : most(most) {}

  void report(std::string_view stage, double share) override {
    stages.emplace_back(stage);
    shares.push_back(share);
  }
  bool stopped() override { return stages.size() >= most; }

  std::size_t most;
  std::vector<std::string> stages;
  std::vector<double> shares;
};

}  // namespace fathom::testing
