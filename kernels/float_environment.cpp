// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/float_environment.hpp"

#include <cfloat>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace fathom::kernels {

static_assert(FLT_EVAL_METHOD == 0, "the filters' error bounds are those of binary64 without excess precision");

#ifdef __SSE2__

DefaultFloatEnvironment::DefaultFloatEnvironment() : caller_(_mm_getcsr()), caller_rounding_(std::fegetround()) {
  std::fesetround(FE_TONEAREST);
  _mm_setcsr(_MM_MASK_MASK);  // every exception masked; rounding to nearest, flush-to-zero and denormals-are-zero are
                              // other bits, now 0
}

DefaultFloatEnvironment::~DefaultFloatEnvironment() {
  std::fesetround(caller_rounding_);
  _mm_setcsr(caller_);
}

#else

DefaultFloatEnvironment::DefaultFloatEnvironment() {
  std::fegetenv(&caller_);
  std::fesetenv(FE_DFL_ENV);
}

DefaultFloatEnvironment::~DefaultFloatEnvironment() { std::fesetenv(&caller_); }

#endif

}  // namespace fathom::kernels
