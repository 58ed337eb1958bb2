// SPDX-License-Identifier: Apache-2.0
// The limits of a certificate, so that none, however hostile, makes a checker run out of memory or
// run for ever. All checkers find the same texts malformed: the limits follow from the text alone,
// but that on the tree of section 15, which takes checked polytopes.
//                                                                            [FORMAT.md, section 8]
#pragma once

#include <cstddef>
#include <cstdint>

#include "certificate.hpp"

namespace fathom_check {

constexpr std::size_t longest_line = std::size_t{1} << 24;  ///< bytes
constexpr std::size_t longest_number = 100'000;             ///< digits

/// The limits of a certificate as a whole. All checkers have these; tests have smaller ones.
struct Limits {
  std::size_t bytes = 1'000'000'000, numbers = 10'000'000;
  std::uint64_t size = 4'000'000'000, work = 100'000'000'000'000;
};

/// Sets the common denominators of the points and the optima. Throws Fault (malformed, on `line`)
/// if the certificate is too large, or too much work.
void require_limits(Certificate& certificate, std::size_t line, const Limits& limits);

/// The same for format 5, sections 14 and 15; for two bodies the work of the tree is left.
void require_limits_of_solids(Certificate& certificate, std::size_t line, const Limits& limits);

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

}  // namespace fathom_check
