// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/dyadic.hpp"

#include <bit>
#include <cstddef>
#include <limits>

namespace fathom::kernels {

std::optional<Dyadic> dyadic(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_size(n) > 1 || mpz_sgn(d) <= 0) return std::nullopt;
  const mp_limb_t magnitude = mpz_getlimbn(n, 0);
  if (magnitude > std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  const auto mantissa = mpz_sgn(n) < 0 ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
  const std::size_t highest = mpz_size(d) - 1;
  const mp_limb_t top = mpz_getlimbn(d, static_cast<mp_size_t>(highest));
  if (!std::has_single_bit(top)) return std::nullopt;
  for (std::size_t i = 0; i < highest; ++i)
    if (mpz_getlimbn(d, static_cast<mp_size_t>(i)) != 0) return std::nullopt;
  const auto shift = static_cast<long>(64 * highest) + std::countr_zero(top);
  if (shift == 0) return normalised(mantissa, 0);
  return magnitude % 2 != 0 ? std::optional(Dyadic{mantissa, -shift}) : std::nullopt;
}

}  // namespace fathom::kernels
