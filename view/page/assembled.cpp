// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/page/assembled.hpp"

#include <fmt/format.h>

#include <array>

#include "view/page/parts.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/style.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::page {
namespace {

/// JSON that can stand in a script element: "<" occurs in its strings alone, where it has another form.
std::string block(std::string_view id, const std::string& json) {
  std::string result = fmt::format("<script type=\"application/json\" id=\"{}\">", id);
  result.reserve(result.size() + json.size() + 16);
  for (const char c : json) {
    if (c == '<') result += "\\u003c";
    else result += c;
  }
  return result + "</script>\n";
}

/// The colours and pictures of all pages, and the layout of this one.
const std::string& whole_style() {
  static const std::string text = "\n" + picture::colour_style() + picture::picture_style() + atlas::atlas_style() + std::string(style());
  return text;
}

}  // namespace

std::string assembled(const PageParts& parts) {
  std::string notes, nav, data;
  for (const std::string& note : parts.notes) notes += fmt::format("<p class=\"warning\" role=\"note\">{}</p>\n", picture::markup(note));
  for (const auto& [id, name] : parts.sections) nav += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, name);
  for (const auto& [id, json] : parts.data) data += block(id, json);
  const std::array scripts{script()};
  const std::array<std::string_view, 1> styles{whole_style()};
  return filled(shell(), {{"version", picture::markup(parts.version)},
                          {"command", picture::markup(parts.command)},
                          {"policy", picture::security_policy(scripts, styles)},
                          {"title", parts.answer},
                          {"style", whole_style()},
                          {"answer", parts.answer},
                          {"subtitle", parts.subtitle},
                          {"notes", notes},
                          {"nav", nav},
                          {"main", parts.main},
                          {"left_out", parts.left_out},
                          {"data", data},
                          {"script", std::string(script())}});
}

std::string figure(const std::string& svg, std::string_view caption) {
  return svg.empty() ? "" : fmt::format("<figure class=\"still\">{}<figcaption>{}</figcaption></figure>", svg, caption);
}

std::string left_out_section(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string items;
  for (const std::string& sentence : sentences) items += fmt::format("<li>{}</li>\n", picture::markup(sentence));
  return "<section id=\"left-out\" aria-labelledby=\"left-out-h\">\n<h2 id=\"left-out-h\">What is left out</h2>\n<ul>\n" + items +
         "</ul>\n</section>\n";
}

}  // namespace fathom::page
