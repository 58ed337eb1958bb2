// SPDX-License-Identifier: GPL-3.0-or-later
// Replies that a subject gave earlier, from a file: an optional hello, then replies in any order. [verify/PROTOCOL.md]
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {

/// The file has no reply to a case.
struct NoReply : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Replies by the ids of their cases.
class Replay {
 public:
  /// Reads a file; "-" is standard input. Without a hello the subject is "replay" in binary64, with the default conventions. Throws
  /// InputError if the file cannot be read, its hello is wrong, or it holds no reply.
  static Replay read(const std::string& given);

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// A sentence with file and line for each line that is not a reply.
  [[nodiscard]] const std::vector<InputError>& faults() const { return faults_; }

  /// Judges the reply to the case as a subject gave it that saw all lengths times 2^exponent; several replies to one case are garbage. Of
  /// unions without a reply of their own, the replies to their pairs of pieces are judged; see pair_id. Throws NoReply, Disagreement and
  /// Interrupted. Any thread may call it.
  [[nodiscard]] Outcome examine(const Case& pair, long exponent, const Judging& judging) const;

  /// The ids of replies to what was not asked, sorted.
  [[nodiscard]] std::vector<std::string> unasked(const std::function<bool(const std::string&)>& is_asked) const;

 private:
  Outcome ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer) const;
  void take(std::string_view line, const std::string& path, std::size_t number);

  SubjectInfo info_;
  std::map<std::string, std::vector<SubjectAnswer>> answers_;
  std::vector<InputError> faults_;
};

}  // namespace fathom::harness
