// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/families/catalogue.hpp"
#include "verify/families/degrade.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

constexpr std::size_t small = 16;

const Case& any_entry(Random& random) {
  const std::span<const CatalogueEntry> all = catalogue();
  return all[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(all.size()) - 1))].pair;
}

}  // namespace

Bodies from_catalogue(Random& random, unsigned) {
  const Case& pair = any_entry(random);
  return {pair.a, pair.b};
}

Bodies approaching_catalogue(Random& random, unsigned) {
  const Case* pair = &any_entry(random);
  while (pair->a.points.size() > small || pair->b.points.size() > small) pair = &any_entry(random);
  const auto k = static_cast<unsigned>(random.between(4, 200));
  Case near = approach(*pair, k, random.next());
  return {std::move(near.a), std::move(near.b)};
}

Bodies degraded(Degradation way, Random& random, unsigned n) {
  Bodies generic = random_sphere(random, std::max(4u, n));
  Case broken = degrade({"", std::move(generic.a), std::move(generic.b)}, way, random.next());
  return {std::move(broken.a), std::move(broken.b)};
}

}  // namespace fathom::families
