// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "view/page/assembled.hpp"
#include "view/page/page.hpp"
#include "view/page/parts.hpp"
#include "view/picture/markup.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::page {

std::string html_page(const UnionSheet& sheet) {
  const Data depth = Data::parse(sheet.depth, nullptr, false);
  if (!depth.is_object()) throw std::invalid_argument("the answer of a page is no JSON object");
  const atlas::SumPicture sum = atlas::sum_picture(sheet.stages, "still-sum");
  const std::string main =
      filled(union_sections(),
             {{"picture_what",
               figure(sheet.picture,
                      "<span class=\"key-a\">A</span> and <span class=\"key-b\">B</span>, seen across the translation; deeper: the "
                      "pieces in contact.")},
              {"facts", union_facts(depth, sheet.stages)},
              {"contacts", union_contacts(depth)},
              {"lead_why", lead_of_sums(sheet.stages)},
              {"picture_sum", figure(sum.svg, picture::markup(sum.note))},
              {"sums", piece_sums(sheet.stages)}});
  return assembled({sheet.version,
                    "fathom depth --pieces --json",
                    picture::markup(union_sentence(depth)),
                    union_subtitle(depth),
                    sheet.notes,
                    {{"what", "What happens"}, {"why", "Why no shorter way"}},
                    main,
                    left_out_section(sheet.stages.left_out),
                    {{"depth", sheet.depth}, {"stages", stages::to_json(sheet.stages)}, {"case", sheet.pair}}});
}

}  // namespace fathom::page
