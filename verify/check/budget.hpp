// SPDX-License-Identifier: Apache-2.0
// Limits, so that no input, however hostile, can make the checker run out of memory or run for ever. Nothing is ever reserved because a
// file announces it; what is really stored or computed is paid for here first.                                       [FORMAT.md, section 8]
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace fathom_check {

constexpr std::size_t longest_integer = 2'000'000;             ///< digits
constexpr std::size_t longest_line = std::size_t{16} << 20;    ///< bytes
constexpr std::size_t longest_json = std::size_t{256} << 20;   ///< bytes of a JSON line or file
constexpr std::uint64_t most_memory = std::uint64_t{2} << 30;  ///< bytes, estimated, for one certificate or one file of cases
constexpr std::uint64_t most_work = std::uint64_t{1} << 36;    ///< bits that pass through products, for one certificate

/// What stops the checking of one certificate. It never leaves this library.
struct Fault : std::runtime_error {
  Fault(bool is_malformed, std::size_t on_line, const std::string& reason)
      : std::runtime_error(reason), malformed(is_malformed), line(on_line) {}
  bool malformed;  ///< else refused
  std::size_t line;
};

inline Fault malformed(std::size_t line, const std::string& reason) { return {true, line, reason}; }
inline Fault refused(std::size_t line, const std::string& reason) { return {false, line, reason}; }

class Budget {
 public:
  void store(std::uint64_t bytes, std::size_t line) {
    if (bytes > memory_) throw malformed(line, "larger than this checker's limit of 2 GiB for one input");
    memory_ -= bytes;
  }
  void work(std::uint64_t bits, std::size_t line) {
    if (bits > work_) throw refused(line, "more work than this checker takes on for one certificate");
    work_ -= bits;
  }

 private:
  std::uint64_t memory_ = most_memory, work_ = most_work;
};

}  // namespace fathom_check
