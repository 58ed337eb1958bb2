// SPDX-License-Identifier: Apache-2.0
// What stops the checking of an input, and the memory of JSON. No memory is reserved because a file
// announces a size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace fathom_check {

constexpr std::size_t longest_json = std::size_t{256} << 20;  ///< bytes of a JSON line or file
constexpr std::uint64_t most_memory = std::uint64_t{2}
                                      << 30;  ///< bytes, estimated, for the values of one JSON line or file

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

 private:
  std::uint64_t memory_ = most_memory;
};

}  // namespace fathom_check
