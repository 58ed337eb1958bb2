// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fathom::picture {
namespace {

struct Lead {
  std::size_t length;  // of the sequence in bytes
  unsigned bits;       // that the first byte gives
  unsigned least;      // smaller code points have shorter sequences, so in this one they are not UTF-8
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if (byte >= 0xc0 && byte < 0xe0) return {2, byte & 0x1fU, 0x80};
  if (byte >= 0xe0 && byte < 0xf0) return {3, byte & 0x0fU, 0x800};
  if (byte >= 0xf0 && byte < 0xf8) return {4, byte & 0x07U, 0x10000};
  return {0, 0, 0};
}

/// Returns the number of bytes of the first character of `text`, which must not be empty; 0 if it
/// is not UTF-8, or XML 1.0 does not allow it.
std::size_t character(std::string_view text) {
  const auto [length, bits, least] = lead_of(static_cast<unsigned char>(text[0]));
  if (length == 0 || length > text.size()) return 0;
  unsigned point = bits;
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned byte = static_cast<unsigned char>(text[i]);
    if (byte >> 6 != 2) return 0;
    point = point << 6 | (byte & 0x3fU);
  }
  const bool surrogate = point >= 0xd800 && point < 0xe000;
  const bool control = point < 0x20 || (point >= 0x7f && point < 0xa0);
  const bool none = (point & 0xfffeU) == 0xfffe || (point >= 0xfdd0 && point < 0xfdf0);
  return point < least || point > 0x10ffff || surrogate || control || none ? 0 : length;
}

std::string byte_text(char c) { return fmt::format("\\x{:02x}", static_cast<unsigned char>(c)); }

std::size_t sum(std::span<const Share> shares) {
  std::size_t result = 0;
  for (const Share& share : shares) result += share.count;
  return result;
}

double percent(std::size_t count, std::size_t all) {
  return 100 * static_cast<double>(count) / static_cast<double>(all);
}

}  // namespace

std::string markup(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const char c = text.front();
    std::size_t used = 1;
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else if (c == '\'') result += "&#39;";
    else if (c == '\t' || c == '\n' || c == '\r') result += fmt::format("&#{};", static_cast<int>(c));
    else if (used = character(text); used > 0) result += text.substr(0, used);
    else result += byte_text(c), used = 1;
    text.remove_prefix(used);
  }
  return result;
}

std::string ascii(std::string_view text, std::size_t width) {
  std::string result;
  for (const char c : text) {
    result += c >= 0x20 && c < 0x7f ? std::string(1, c) : byte_text(c);
    if (result.size() > width) return result.substr(0, width - 3) + "...";
  }
  return result;
}

std::string without_folders(std::string_view text) {
  constexpr std::string_view before = " \t\n'\"=:,;(", after = " \t\n'\",;)";
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool begins = text[at] == '/' && (at == 0 || before.find(text[at - 1]) != std::string_view::npos);
    const std::size_t end = begins ? std::min(text.find_first_of(after, at), text.size()) : at + 1;
    std::string_view part = text.substr(at, end - at);
    if (begins && part.find_last_not_of('/') != std::string_view::npos) {
      part = part.substr(0, part.find_last_not_of('/') + 1);
      part = part.substr(part.rfind('/') + 1);
    }
    result += part;
    at = end;
  }
  return result;
}

std::string svg_element(const SvgFrame& frame, const std::string& content) {
  return fmt::format(
      "<svg{0} class=\"{1}\" viewBox=\"0 0 {2} {3}\" width=\"{2}\" height=\"{3}\" role=\"img\" aria-labelledby=\"{4}-t "
      "{4}-d\">"
      "<title id=\"{4}-t\">{5}</title><desc id=\"{4}-d\">{6}</desc>{7}</svg>\n",
      frame.is_file ? " xmlns=\"http://www.w3.org/2000/svg\"" : "", frame.style, frame.width, frame.height, frame.name,
      frame.title, frame.description, content);
}

std::string share_bar(std::span<const Share> shares, const std::string& id, const std::string& label) {
  const std::size_t all = sum(shares);
  if (all == 0) return "";
  std::string bars, legend, described;
  std::size_t before = 0;
  std::map<std::string, std::size_t> seen;  // for ids: neighbours of the same style alternate
  for (const Share& share : shares) {
    if (share.count == 0) continue;
    const std::string style = share.style + (seen[share.style]++ % 2 == 0 ? "" : " other");
    const std::string text = fmt::format("{} {}", share.count, share.name);
    bars += fmt::format(
        "<rect class=\"share {}\" x=\"{:.3f}%\" y=\"0\" width=\"{:.3f}%\" height=\"22\"><title>{} of {}: "
        "{}</title></rect>",
        style, percent(before, all), percent(share.count, all), share.count, all, share.name);
    const std::string named =
        share.link.empty() ? share.name : fmt::format("<a href=\"#{}\">{}</a>", share.link, share.name);
    legend += fmt::format(
        "<li><svg class=\"swatch\" width=\"12\" height=\"12\" aria-hidden=\"true\"><rect class=\"share {}\" "
        "width=\"12\" "
        "height=\"12\"/></svg> "
        "<b>{}</b> {}</li>",
        style, share.count, named);
    described += (described.empty() ? "" : ", ") + text;
    before += share.count;
  }
  return fmt::format(
      "<figure class=\"shares\"><svg width=\"100%\" height=\"22\" role=\"img\" aria-labelledby=\"{0}-t {0}-d\"><title "
      "id=\"{0}-t\">{1}"
      "</title><desc id=\"{0}-d\">{2}.</desc>{3}</svg><ul class=\"legend\">{4}</ul></figure>\n",
      id, label, described, bars, legend);
}

std::string filter_bar(const std::string& of, const std::string& what, std::span<const Choice> kinds) {
  std::string options = "<option value=\"\">all</option>";
  for (const Choice& choice : kinds)
    options += fmt::format("<option value=\"{}\">{}</option>", choice.kind, choice.label);
  return fmt::format(
      "<form class=\"filter\" data-of=\"{0}\" hidden=\"hidden\"><label>text <input type=\"search\" "
      "name=\"text\"/></label> "
      "<label>{1} <select name=\"kind\">{2}</select></label> <output aria-live=\"polite\"></output></form>\n",
      of, what, options);
}

std::string copied_text(const std::string& id, const std::string& button, const std::string& summary,
                        std::string_view text) {
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

std::string folded(std::string_view summary, const std::string& text) {
  return fmt::format("<details><summary>{}</summary><pre tabindex=\"0\">{}</pre></details>", summary, text);
}

void FactList::add(std::string_view field, std::string_view label, const std::string& text, const std::string& more) {
  rows_ += fmt::format("<dt>{}</dt><dd><span data-field=\"{}\">{}</span>{}</dd>\n", label, field, text, more);
}

Table::Table(std::string caption, std::vector<std::string_view> heads)
    : caption_(std::move(caption)), heads_(std::move(heads)) {}

void Table::add(const std::vector<std::string>& cells, std::string_view attributes) {
  rows_ += fmt::format("<tr{}{}>", attributes.empty() ? "" : " ", attributes);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view kind = heads_[i].starts_with('\'') ? " class=\"text\"" : "";
    rows_ += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", kind, cells[i])
                    : fmt::format("<td{}>{}</td>", kind, cells[i]);
  }
  rows_ += "</tr>\n";
}

std::string Table::text() const {
  std::string head;
  for (const std::string_view name : heads_)
    head += name.starts_with('\'') ? fmt::format("<th scope=\"col\" class=\"text\">{}</th>", name.substr(1))
                                   : fmt::format("<th scope=\"col\">{}</th>", name);
  return fmt::format(
      "<div class=\"wide\" role=\"region\" tabindex=\"0\" "
      "aria-label=\"{0}\"><table><caption>{0}</caption>\n<thead><tr>{1}</tr></thead>\n"
      "<tbody>\n{2}</tbody></table></div>\n",
      caption_, head, rows_);
}

}  // namespace fathom::picture
