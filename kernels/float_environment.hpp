// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point environment that the filters are proved for, whatever the calling process has
// set.                                                                          [proofs/kernels.md]
#pragma once

#include <cfenv>

namespace fathom::kernels {

/// While it lives, the calling thread rounds to nearest, keeps subnormal numbers (no flush-to-zero,
/// no denormals-are-zero) and traps no exception; then the caller's environment returns, flags
/// included. Every function of the public interface begins with one, since a process linked with
/// -ffast-math, or a physics engine in it, flushes subnormals to zero: that broke a filter's bound.
/// Threads started meanwhile inherit it.
class DefaultFloatEnvironment {
 public:
  DefaultFloatEnvironment();
  ~DefaultFloatEnvironment();
  DefaultFloatEnvironment(const DefaultFloatEnvironment&) = delete;
  DefaultFloatEnvironment& operator=(const DefaultFloatEnvironment&) = delete;

 private:
#ifdef __SSE2__
  // std::fenv_t would hold all of the x87 unit too, and saving it takes ten times as long. Only its
  // rounding mode matters: strtod obeys it.
  unsigned caller_;
  int caller_rounding_;
#else
  std::fenv_t caller_;
#endif
};

}  // namespace fathom::kernels
