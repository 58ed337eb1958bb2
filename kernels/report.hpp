// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fathom::kernels {

/// What `validate` found: empty when every law holds, else one sentence per broken law.
struct Report {
  std::vector<std::string> faults;

  [[nodiscard]] bool ok() const { return faults.empty(); }
  /// Records `fault` unless `holds`. Returns `holds`.
  bool expect(bool holds, std::string fault) {
    if (!holds) faults.push_back(std::move(fault));
    return holds;
  }
};

/// Throws std::logic_error with the first fault, if there is one.
inline void insist(const Report& report) {
  if (!report.ok()) throw std::logic_error("broken law: " + report.faults.front());
}

}  // namespace fathom::kernels
