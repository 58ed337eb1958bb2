// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <map>

#include "view/picture/markup.hpp"

namespace fathom::picture {
namespace {

std::size_t sum(std::span<const Share> shares) {
  std::size_t result = 0;
  for (const Share& share : shares) result += share.count;
  return result;
}

double percent(std::size_t count, std::size_t all) { return 100 * static_cast<double>(count) / static_cast<double>(all); }

}  // namespace

std::string share_bar(std::span<const Share> shares, const std::string& id, const std::string& label) {
  const std::size_t all = sum(shares);
  if (all == 0) return "";
  std::string bars, legend, described;
  std::size_t before = 0;
  std::map<std::string, std::size_t> seen;  // neighbours of one style alternate
  for (const Share& share : shares) {
    if (share.count == 0) continue;
    const std::string style = share.style + (seen[share.style]++ % 2 == 0 ? "" : " other");
    const std::string text = fmt::format("{} {}", share.count, share.name);
    bars += fmt::format("<rect class=\"share {}\" x=\"{:.3f}%\" y=\"0\" width=\"{:.3f}%\" height=\"22\"><title>{} of {}: {}</title></rect>",
                        style, percent(before, all), percent(share.count, all), share.count, all, share.name);
    const std::string named = share.link.empty() ? share.name : fmt::format("<a href=\"#{}\">{}</a>", share.link, share.name);
    legend += fmt::format(
        "<li><svg class=\"swatch\" width=\"12\" height=\"12\" aria-hidden=\"true\"><rect class=\"share {}\" width=\"12\" "
        "height=\"12\"/></svg> "
        "<b>{}</b> {}</li>",
        style, share.count, named);
    described += (described.empty() ? "" : ", ") + text;
    before += share.count;
  }
  return fmt::format(
      "<figure class=\"shares\"><svg width=\"100%\" height=\"22\" role=\"img\" aria-labelledby=\"{0}-t {0}-d\"><title id=\"{0}-t\">{1}"
      "</title><desc id=\"{0}-d\">{2}.</desc>{3}</svg><ul class=\"legend\">{4}</ul></figure>\n",
      id, label, described, bars, legend);
}

std::string filter_bar(const std::string& of, const std::string& what, std::span<const Choice> kinds) {
  std::string options = "<option value=\"\">all</option>";
  for (const Choice& choice : kinds) options += fmt::format("<option value=\"{}\">{}</option>", choice.kind, choice.label);
  return fmt::format(
      "<form class=\"filter\" data-of=\"{0}\" hidden=\"hidden\"><label>text <input type=\"search\" name=\"text\"/></label> "
      "<label>{1} <select name=\"kind\">{2}</select></label> <output aria-live=\"polite\"></output></form>\n",
      of, what, options);
}

std::string copied_text(const std::string& id, const std::string& button, const std::string& summary, std::string_view text) {
  return fmt::format(
      "<p class=\"copying\"><button type=\"button\" class=\"copy\" data-of=\"{0}\" hidden=\"hidden\">{1}</button> "
      "<span role=\"status\"></span></p>\n<details><summary>{2}</summary><pre id=\"{0}\" class=\"wrap\" "
      "tabindex=\"0\">{3}</pre></details>\n",
      id, button, summary, markup(text));
}

std::string beside(const std::string& figure, const std::string& said) {
  if (figure.empty()) return said;
  return "<div class=\"beside\">\n<div class=\"picture\">" + figure + "</div>\n<div>\n" + said + "</div>\n</div>\n";
}

std::string table_box(const std::string& name, const std::string& table, bool tall) {
  return fmt::format("<div class=\"wide{}\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table>{}</table></div>\n",
                     tall ? " tall" : "", name, table);
}

}  // namespace fathom::picture
