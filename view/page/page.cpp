// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/page/page.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fathom/numbers.hpp"
#include "view/atlas/atlas.hpp"
#include "view/page/embedded.hpp"
#include "view/page/fill.hpp"
#include "view/page/parts.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/policy.hpp"
#include "view/picture/style.hpp"

namespace fathom::page {
namespace {

/// JSON that can stand in a script element: "<" occurs in its strings alone, where it has another form.
std::string block(const std::string& json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json) {
    if (c == '<') result += "\\u003c";
    else result += c;
  }
  return result;
}

/// The colours and pictures of all pages, and the layout of this one.
const std::string& whole_style() {
  static const std::string text = "\n" + picture::colour_style() + picture::picture_style() + atlas::atlas_style() + std::string(style());
  return text;
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string result;
  for (const std::string& note : notes) result += fmt::format("<p class=\"warning\" role=\"note\">{}</p>\n", picture::markup(note));
  return result;
}

/// The exact squares that the stages leave out, of canonical pairs with one crossing: an array beside `pairs`.
std::string squares(const stages::Stages& stages) {
  Data result = Data::array();
  for (const stages::StagedPair& pair : stages.pairs)
    result.push_back(pair.closest && pair.crossings() == 1 ? Data(exact_text(pair.closest->squared)) : Data());
  return result.dump();
}

std::string figure(const std::string& svg, std::string_view caption) {
  return svg.empty() ? "" : fmt::format("<figure class=\"still\">{}<figcaption>{}</figcaption></figure>", svg, caption);
}

Data parsed(const std::string& depth) {
  Data result = Data::parse(depth, nullptr, false);
  if (!result.is_object()) throw std::invalid_argument("the answer of a page is no JSON object");
  return result;
}

}  // namespace

std::string html_page(const Sheet& sheet) {
  const Data depth = parsed(sheet.depth);
  const stages::Stages& stages = sheet.stages;
  const std::string answer = picture::markup(answer_sentence(depth));
  const atlas::SumPicture sum = atlas::sum_picture(stages, "still-sum");
  const std::array scripts{script()};
  const std::array<std::string_view, 1> styles{whole_style()};
  return filled(
      shell(),
      {{"version", picture::markup(sheet.version)},
       {"policy", picture::security_policy(scripts, styles)},
       {"title", answer},
       {"style", whole_style()},
       {"answer", answer},
       {"subtitle", subtitle(depth)},
       {"notes", notes_text(sheet.notes)},
       {"picture_what", figure(sheet.picture, "<span class=\"key-a\">A</span> and <span class=\"key-b\">B</span>, seen across n.")},
       {"facts", facts(depth)},
       {"lead_why", lead_why(stages)},
       {"picture_sum", figure(sum.svg, picture::markup(sum.note))},
       {"ranked", ranked(stages)},
       {"lead_where", lead_where(stages)},
       {"picture_sphere", figure(atlas::sphere_picture(stages, "still-sphere"), "The diagrams of -A and of B on the sphere.")},
       {"picture_chart",
        figure(atlas::chart_picture(stages, "still-chart"), "A hemisphere as a chart: longitude to the right, latitude up.")},
       {"pairs", pairs(stages)},
       {"cutting", cutting(stages)},
       {"lead_coincided", lead_coincided(stages)},
       {"coincided", coincided(stages)},
       {"lead_cost", lead_cost(stages)},
       {"cost", costs(stages)},
       {"left_out", left_out(stages)},
       {"depth", block(sheet.depth)},
       {"stages", block(stages::to_json(stages))},
       {"squares", squares(stages)},
       {"case", block(sheet.pair)},
       {"script", std::string(script())}});
}

}  // namespace fathom::page
