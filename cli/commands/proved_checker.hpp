// SPDX-License-Identifier: GPL-3.0-or-later
// The checker extracted from the Coq development, run after the C++ checker. It gets each certificate as that one read it and compared it
// with the user's cases and results, and must accept it too.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "verify/check/run.hpp"
#include "verify/harness/process.hpp"

namespace fathom::cli {

inline constexpr const char* proved_program = "fathom-check-proved";

class ProvedChecker : public fathom_check::SecondChecker {
 public:
  /// `width`: what it accepts must be about the width of a body.
  explicit ProvedChecker(bool width) : width_(width) {}

  void hand_over(const fathom_check::Certificate& certificate) override;
  /// Throws std::runtime_error if the program is missing or dies; failed() is true from then on.
  Opinion opinion(const std::string& name) override;
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  [[nodiscard]] std::string answer(const std::string& name);
  [[nodiscard]] std::runtime_error failure(const std::string& what);

  bool width_;
  std::unique_ptr<harness::Process> process_;
  int format_ = 1;
  std::string text_;  ///< of the certificate, from its points on
  std::size_t claim_line_ = 0;
  bool failed_ = false;
};

/// Returns the message that the program is missing, and how it is built.
std::string proved_program_is_missing();

}  // namespace fathom::cli
