// SPDX-License-Identifier: Apache-2.0
// What stops the checking of an input: a fault, and limits, so that none, however hostile, makes a
// checker run out of memory or run for ever. All checkers find the same texts malformed: the limits
// follow from the text alone, but that on the tree of section 15, which takes checked polytopes.
//                                                                            [FORMAT.md, section 8]
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "certificate.hpp"

namespace fathom_check {

/// What stops the checking of one certificate. It never leaves this library.
struct Fault : std::runtime_error {
  Fault(bool is_malformed, std::size_t on_line, const std::string& reason)
      : std::runtime_error(reason), malformed(is_malformed), line(on_line) {}
  bool malformed;  ///< else refused
  std::size_t line;
};

inline Fault malformed(std::size_t line, const std::string& reason) { return {true, line, reason}; }
inline Fault refused(std::size_t line, const std::string& reason) { return {false, line, reason}; }

constexpr std::size_t longest_line = std::size_t{1} << 24;    ///< bytes
constexpr std::size_t longest_number = 100'000;               ///< digits
constexpr std::size_t most_constraints = 4;                   ///< of a leaf
constexpr std::size_t longest_json = std::size_t{256} << 20;  ///< bytes of a JSON line or file
/// Bytes, estimated, for the values of one JSON line or file.
constexpr std::uint64_t most_memory = std::uint64_t{2} << 30;

/// The limits of a certificate as a whole. All checkers have these; tests have smaller ones.
struct Limits {
  std::size_t bytes = 1'000'000'000, numbers = 10'000'000;
  std::uint64_t size = 4'000'000'000, work = 100'000'000'000'000;
};

/// Sets the common denominators of the points and the optima. Throws Fault (malformed, on `line`)
/// if the certificate is too large, or too much work; of two bodies of format 5 the work of the
/// tree is left.
void require_limits(Certificate& certificate, std::size_t line, const Limits& limits);

/// The work of a tree of format 5, which is known when its planes are.
class WorkOfTree {
 public:
  explicit WorkOfTree(const UnionParts& parts) : parts_(&parts), total_(parts.work) {}

  /// Takes a leaf with this number of constraints, or with 0 a facet, the numbers of whose planes
  /// have at most this many digits. Throws Fault (malformed) if it is too much work.
  void take(std::size_t constraints, std::size_t digits);

 private:
  const UnionParts* parts_;
  std::uint64_t total_;
};

/// The memory of JSON. None is reserved because a file announces a size.
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
