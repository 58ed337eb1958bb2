// SPDX-License-Identifier: GPL-3.0-or-later
// What a predicate answers. Zero is an answer ("on"); a filter that cannot tell returns std::optional<Sign> without a value.
#pragma once

#include <gmpxx.h>

#include <cstdint>

namespace fathom::kernels {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

/// The sign of a comparison's result: any int, of which only the sign counts.
constexpr Sign sign_of(int value) { return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero; }
inline Sign sign_of(const mpz_class& value) { return sign_of(sgn(value)); }

constexpr int to_int(Sign s) { return static_cast<int>(s); }
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-to_int(s)); }
constexpr Sign operator*(Sign s, Sign t) { return static_cast<Sign>(to_int(s) * to_int(t)); }

}  // namespace fathom::kernels
