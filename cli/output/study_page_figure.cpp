// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a case in the page of studies.
#include <fmt/format.h>

#include "cli/output/study_page_parts.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/pair_picture.hpp"

namespace fathom::cli {
namespace {

std::string figure(const std::string& svg, Status status) {
  std::string caption = "<span class=\"key body-a\">A</span>, <span class=\"key body-b\">B</span>, hidden edges thin";
  if (status == Status::penetrating) caption += "; <span class=\"key true\">arrow</span>: the shortest way of A out, and A after it dashed";
  if (status == Status::disjoint) caption += "; <span class=\"key true\">arrow</span>: the gap from A to B, and A moved across it dashed";
  return fmt::format("<figure><div class=\"pairs\">{}</div><figcaption>{}.</figcaption></figure>\n", svg, caption);
}

}  // namespace

std::string study_figure(const Case& pair, const Depth& depth, const Marks& marks, const std::string& anchor) {
  (void)marks;
  const std::string label = "Hulls of " + picture::markup(pair.id);
  return figure(picture::pair_picture({pair.a.points, pair.b.points, depth}, std::nullopt, anchor, label), depth.status());
}

std::string study_figure(const Case& pair, const SignedDepth& depth, const std::string& anchor) {
  (void)pair, (void)depth, (void)anchor;
  return "";
}

}  // namespace fathom::cli
