// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "verify/families/degrade.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

Case approach(const Case& degenerate, unsigned k, std::uint64_t seed) {
  Case result = degenerate;
  result.id += "-k" + std::to_string(k) + "-s" + std::to_string(seed);
  Random random(seed);
  for (Body* body : {&result.a, &result.b})
    for (Point& p : body->points.edit())
      for (mpq_class* x : {&p.x, &p.y, &p.z}) *x += times_power_of_two(random_dyadic(random, -1, 1, 20), -static_cast<long>(k));
  return result;
}

}  // namespace fathom::families
