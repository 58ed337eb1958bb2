// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers for properties of numbers: at full size from the first case on, where RapidCheck
// would begin with small ones; and a square.
#pragma once

#include <gmpxx.h>
#include <rapidcheck.h>

#include <cstdint>

namespace fathom::testing {

inline std::uint64_t random_word() { return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()); }

/// From first to last - 1.
inline int random_in(int first, int last) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last)); }

inline mpq_class square(const mpq_class& x) { return mpq_class(x * x); }

}  // namespace fathom::testing
