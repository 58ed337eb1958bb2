// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of a run of `fathom certify`: each id once; bad ones are reported and counted.
#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/io/case_input.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

class CertifyCases {
 public:
  /// Opens the stream; throws InputError. "-" is standard input, and waiting for it can be interrupted.
  CertifyCases(const std::string& input, std::function<void(const std::string&)> tell);

  /// Returns the next good case, or nullopt at the end. Calls `tell` for a bad one and for one with an id that was there before. Throws
  /// std::bad_alloc and can go on, as CaseStream::next.
  std::optional<Case> next();

  [[nodiscard]] std::size_t bad() const { return bad_; }
  /// The place, for messages, of the case that was read last, or that did not fit into the memory.
  [[nodiscard]] std::string place() const;
  /// Whether a case so far has the id, or two pieces of its unions; see harness::pair_id.
  [[nodiscard]] bool asked(const std::string& id) const;
  /// About how many there are in a regular file; nullopt for other inputs. See cases_in.
  [[nodiscard]] std::optional<std::size_t> expected() const { return expected_; }

 private:
  std::string input_;
  std::function<void(const std::string&)> tell_;
  InterruptibleInput standard_input_;
  std::istream stdin_{&standard_input_};
  CaseStream items_;
  std::set<std::string> ids_;
  std::vector<Case> unions_;  // of these
  std::size_t bad_ = 0;
  std::optional<std::size_t> expected_;
};

}  // namespace fathom::cli
