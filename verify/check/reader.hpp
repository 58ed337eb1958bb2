// SPDX-License-Identifier: Apache-2.0
// Certificates from a stream, one after another, each with its verdict.
#pragma once

#include <functional>
#include <optional>

#include "certificate.hpp"
#include "check.hpp"
#include "lines.hpp"
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

/// The verdict on what was found. Does not throw.
Verdict judged(const Reader::Found& found, const Inspect& inspect = {});

/// Runs `action`, and turns whatever it throws into a verdict that is not `verified`. `line` is
/// used where the fault has none.
Verdict caught(const std::function<Verdict()>& action, std::size_t line);

}  // namespace fathom_check
