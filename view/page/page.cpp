// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/page/page.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fathom/numbers.hpp"
#include "view/page/assembled.hpp"
#include "view/page/parts.hpp"
#include "view/picture/markup.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::page {
namespace {

/// The exact squares that the stages leave out, of canonical pairs with one crossing: an array beside `pairs`.
std::string squares(const stages::Stages& stages) {
  Data result = Data::array();
  for (const stages::StagedPair& pair : stages.pairs)
    result.push_back(pair.closest && pair.crossings() == 1 ? Data(exact_text(pair.closest->squared)) : Data());
  return result.dump();
}

Data parsed(const std::string& depth) {
  Data result = Data::parse(depth, nullptr, false);
  if (!result.is_object()) throw std::invalid_argument("the answer of a page is no JSON object");
  return result;
}

std::string sections(const Data& depth, const Sheet& sheet) {
  const stages::Stages& stages = sheet.stages;
  const atlas::SumPicture sum = atlas::sum_picture(stages, "still-sum");
  return filled(
      pair_sections(),
      {{"picture_what", figure(sheet.picture, "<span class=\"key-a\">A</span> and <span class=\"key-b\">B</span>, seen across n.")},
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
       {"cost", costs(stages)}});
}

}  // namespace

std::string html_page(const Sheet& sheet) {
  const Data depth = parsed(sheet.depth);
  return assembled(
      {sheet.version,
       "fathom depth --json",
       picture::markup(answer_sentence(depth)),
       subtitle(depth),
       sheet.notes,
       {{"what", "What happens"},
        {"why", "Why no shorter way"},
        {"where", "Where it comes from"},
        {"coincided", "What coincided"},
        {"cost", "Cost"}},
       sections(depth, sheet),
       left_out_section(sheet.stages.left_out),
       {{"depth", sheet.depth}, {"stages", stages::to_json(sheet.stages)}, {"squares", squares(sheet.stages)}, {"case", sheet.pair}}});
}

}  // namespace fathom::page
