// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/dyadic.hpp"

#include <limits>

namespace fathom::kernels {

std::optional<Dyadic> dyadic(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_size(n) > 1 || mpz_sgn(d) <= 0) return std::nullopt;
  const mp_limb_t magnitude = mpz_getlimbn(n, 0);
  if (magnitude > std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  const auto mantissa = mpz_sgn(n) < 0 ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
  const auto shift = static_cast<long>(mpz_scan1(d, 0));
  if (shift == 0) return mpz_cmp_ui(d, 1) == 0 ? std::optional(normalised(mantissa, 0)) : std::nullopt;
  if (static_cast<long>(mpz_sizeinbase(d, 2)) != shift + 1 || magnitude % 2 == 0) return std::nullopt;
  return Dyadic{mantissa, -shift};
}

}  // namespace fathom::kernels
