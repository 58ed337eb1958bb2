// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a good case, read in a fraction of the time. For cases.cpp alone.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "reference/files/case_fields.hpp"

namespace fathom::files {

/// Reads one case after another, each in the memory of the one before. One for each thread.
class QuickCaseReader {
 public:
  QuickCaseReader();
  QuickCaseReader(QuickCaseReader&&) noexcept;
  QuickCaseReader& operator=(QuickCaseReader&&) noexcept;
  ~QuickCaseReader();

  /// Returns what read_case_fields, its naive twin, returns for the text; or nullopt, and read_case_fields has to read it. It does so for
  /// every text with a fault, and for a few good ones. Call it while rounding is to nearest.
  std::optional<CaseFields> fields(std::string_view text);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace fathom::files
