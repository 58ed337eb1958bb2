// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of a run of `fathom certify`: each id once; bad ones are told and counted.
#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <set>
#include <string>

#include "cli/io/interruptible_input.hpp"
#include "reference/files/cases.hpp"

namespace fathom::cli {

class CertifyCases {
 public:
  /// Opens the stream; throws InputError. "-" is standard input, and waiting for it can be interrupted.
  CertifyCases(const std::string& input, std::function<void(const std::string&)> tell);

  /// The next good case; nothing at the end. Of a bad one, or one with an id that was there before, `tell` hears. As CaseStream::next,
  /// throws std::bad_alloc and can go on.
  std::optional<Case> next();

  [[nodiscard]] std::size_t bad() const { return bad_; }
  /// Of the case that was read last, or that did not fit into the memory, for messages.
  [[nodiscard]] std::string place() const;
  [[nodiscard]] const std::set<std::string>& ids() const { return ids_; }
  /// The number of lines that a regular file has; nothing of other inputs.
  [[nodiscard]] std::optional<std::size_t> expected() const { return expected_; }

 private:
  std::string input_;
  std::function<void(const std::string&)> tell_;
  InterruptibleInput standard_input_;
  std::istream stdin_{&standard_input_};
  CaseStream items_;
  std::set<std::string> ids_;
  std::size_t bad_ = 0;
  std::optional<std::size_t> expected_;
};

}  // namespace fathom::cli
