// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a case in the page of studies.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "cli/output/study_page_parts.hpp"
#include "reference/files/shape_names.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/paint.hpp"

namespace fathom::cli {
namespace {

std::string figure(const picture::PairScene& scene, const std::string& svg) {
  std::string caption = "<span class=\"key body-a\">A</span> toned, <span class=\"key body-b\">B</span> hatched";
  if (scene.has_edges()) caption += ", hidden edges dashed";
  if (!scene.moves()) caption += "; <span class=\"key true\">dot</span>: where they touch";
  else if (scene.status == Status::disjoint)
    caption += "; <span class=\"key true\">arrow</span>: the way of A until it touches B, and A there, dashed";
  else
    caption += "; <span class=\"key true\">arrow</span>: the shortest way of A out of B, and A there, dashed; thick: the faces in contact";
  return fmt::format("<figure><div class=\"pairs\">{}</div><figcaption>{}.</figcaption></figure>\n", svg, caption);
}

}  // namespace

std::string study_figure(const Case& pair, const Depth& depth, const Marks& marks, const std::string& anchor) {
  std::vector<picture::Mark> shown;
  for (const auto& [feature, id] : marks.all()) {
    const GivenPoints& points = feature.first ? pair.a.points : pair.b.points;
    picture::Mark mark{feature.first, {}, id};
    for (const std::uint32_t i : feature.second) mark.points.push_back(points[i]);
    shown.push_back(std::move(mark));
  }
  const picture::PairScene scene = picture::scene_of({pair.a.points, pair.b.points, depth});
  return figure(scene, picture::scene_panels(scene, anchor, "Hulls of " + picture::markup(pair.id), shown));
}

std::string study_figure(const Case& pair, const SignedDepth& depth, const std::string& anchor) {
  const picture::PairScene scene = picture::scene_of(files::shape_of(pair.a), files::shape_of(pair.b), depth);
  return figure(scene, picture::scene_panels(scene, anchor, "Shapes of " + picture::markup(pair.id)));
}

}  // namespace fathom::cli
