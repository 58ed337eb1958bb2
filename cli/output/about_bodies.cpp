// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/about_bodies.hpp"

namespace fathom::cli {

AboutBodies about_bodies(const Case& input, bool one_body) { return {sizes_of(input, one_body), hull_facts(input, one_body)}; }

void add_bodies(std::vector<Row>& rows, const AboutBodies& bodies) {
  rows.emplace_back("sizes", sizes_text(bodies.sizes));
  if (const std::string dents = dents_text(bodies.hull); !dents.empty()) rows.emplace_back("hull", dents);
}

void add_bodies(Json& result, const AboutBodies& bodies) {
  result["sizes"] = sizes_object(bodies.sizes);
  if (const std::optional<Json> hull = hull_object(bodies.hull)) result["hull"] = *hull;
}

}  // namespace fathom::cli
