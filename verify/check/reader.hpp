// SPDX-License-Identifier: Apache-2.0
// Certificates from a stream, one after another, each with its verdict.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "certificate.hpp"
#include "check.hpp"
#include "limits.hpp"
#include "parser.hpp"

namespace fathom_check {

/// What else the user asks of a well-formed certificate: throws a Fault to refuse it. May be empty.
using Inspect = std::function<void(const Certificate&)>;

class Reader {
 public:
  /// `lines` must outlive this.
  explicit Reader(Lines& lines) : lines_(&lines), parser_(lines) {}

  /// A certificate that has been read but not checked; or why it cannot be read.
  struct Found {
    Certificate certificate;
    std::optional<Verdict> fault;
    std::size_t last_line = 0;
  };

  /// The next certificate; nothing at the end. An input without any certificate yields one that is
  /// malformed. Does not throw.
  std::optional<Found> read();

  /// The verdict on the next certificate; nothing at the end. `inspect` is called between parsing
  /// and checking. Does not throw.
  std::optional<Verdict> next(const Inspect& inspect = {});

 private:
  Lines* lines_;
  Parser parser_;
  bool any_ = false;
};

/// The verdict on the one certificate that `text` holds. Throws Fault (malformed) if it holds more.
Verdict judged_alone(std::string_view text, const Inspect& inspect = {});

/// The verdict on what was found. Does not throw.
Verdict judged(const Reader::Found& found, const Inspect& inspect = {});

/// Runs `action`, and turns whatever it throws into a verdict that is not `verified`. `line` is
/// used where the fault has none.
Verdict caught(const std::function<Verdict()>& action, std::size_t line);

// For programs that write certificates: whether checkers will read one, before its proof matters.

/// Returns why every checker finds the certificate malformed that `text` begins with: it does not
/// follow the grammar, or exceeds a limit, which the phrase names. Returns an empty text if it is
/// well-formed; its proof is not checked. Throws std::bad_alloc.
[[nodiscard]] std::string unreadable(std::string_view text, const Limits& limits = {});

/// A certificate that every checker would find malformed; whoever gets this writes none.
struct Unreadable : std::length_error {
  using std::length_error::length_error;
};

/// Throws Unreadable, with the reason, unless `unreadable` returns an empty text. Code that gives
/// certificates to users calls this first.
void require_readable(std::string_view certificate, const Limits& limits = {});

}  // namespace fathom_check
