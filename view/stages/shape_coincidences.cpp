// SPDX-License-Identifier: GPL-3.0-or-later
// What coincides of shapes, by the names of the study. Part of parts.hpp.
#include "fathom/study.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {

void add_shape_coincidences(const Shape& a, const Shape& b, const StageOptions& options, Stages& stages) {
  const ShapeStudy found = study(a, b, {.listed = 0, .monitor = options.monitor});
  for (std::size_t i = 0; i < found.coincidences.size(); ++i)
    if (found.coincidences[i].count > 0) stages.coincidences.push_back({shape_coincidence_names[i], found.coincidences[i].count, {}});
  if (!stages.coincidences.empty())
    stages.left_out.emplace_back(
        "Of what coincides of curved bodies only names and counts are here, the features are left out: fathom study lists them.");
}

}  // namespace fathom::stages
