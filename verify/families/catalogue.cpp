// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/catalogue.hpp"

#include <algorithm>
#include <iterator>

#include "verify/families/catalogue_groups.hpp"

namespace fathom::families {

std::span<const CatalogueEntry> catalogue() {
  static const Entries all = [] {
    Entries entries;
    for (const auto group :
         {touching_entries, contact_entries, shared_entries, sphere_entries, redundant_entries, flat_entries, near_entries})
      std::ranges::move(group(), std::back_inserter(entries));
    return entries;
  }();
  return all;
}

const CatalogueEntry* find_catalogue_entry(std::string_view name) {
  const std::span<const CatalogueEntry> all = catalogue();
  const auto found = std::ranges::find(all, name, &CatalogueEntry::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace fathom::families
