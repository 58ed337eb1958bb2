// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "view/page/parts.hpp"
#include "view/picture/markup.hpp"

namespace fathom::page {
namespace {

constexpr std::size_t longest = 4000;  // characters of one number; the page's data hold the whole

bool is_text(std::string_view head) { return head.starts_with('\''); }

std::string plain(const Data& value) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());  // 1, not 1.0, as in the text of answers
  if (!value.is_array()) return value.dump();
  std::string result;
  for (const Data& item : value) result += (result.empty() ? "" : ", ") + plain(item);
  return "(" + result + ")";
}

}  // namespace

const Data& at(const Data& object, std::string_view key) {
  static const Data none;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found == object.end() ? none : *found;
}

std::string shown(const Data& value) {
  const std::string text = plain(value);
  if (text.size() <= longest) return picture::markup(text);
  return picture::markup(fmt::format("{}... ({} characters)", text.substr(0, longest), text.size()));
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string points(const Data& ids) {
  if (!ids.is_array() || ids.empty()) return "-";
  std::string result;
  for (const Data& id : ids) {
    if (result.size() > 200) return result + ", ...";
    result += (result.empty() ? "" : ", ") + shown(id);
  }
  return result;
}

std::string on_demand(std::string_view summary, const std::string& text) {
  return fmt::format("<details><summary>{}</summary><pre tabindex=\"0\">{}</pre></details>", summary, text);
}

void Rows::add(std::string_view field, std::string_view label, const std::string& text, const std::string& more) {
  rows_ += fmt::format("<dt>{}</dt><dd><span data-field=\"{}\">{}</span>{}</dd>\n", label, field, text, more);
}

std::string Rows::list() const { return "<dl>" + rows_ + "</dl>\n"; }

Table::Table(std::string caption, std::vector<std::string_view> heads) : caption_(std::move(caption)), heads_(std::move(heads)) {}

void Table::add(const std::vector<std::string>& cells, std::string_view attributes) {
  rows_ += fmt::format("<tr{}{}>", attributes.empty() ? "" : " ", attributes);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view kind = is_text(heads_[i]) ? " class=\"text\"" : "";
    rows_ += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", kind, cells[i]) : fmt::format("<td{}>{}</td>", kind, cells[i]);
  }
  rows_ += "</tr>\n";
}

std::string Table::text() const {
  std::string head;
  for (const std::string_view name : heads_)
    head += is_text(name) ? fmt::format("<th scope=\"col\" class=\"text\">{}</th>", name.substr(1))
                          : fmt::format("<th scope=\"col\">{}</th>", name);
  return fmt::format(
      "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\"><table><caption>{0}</caption>\n<thead><tr>{1}</tr></thead>\n"
      "<tbody>\n{2}</tbody></table></div>\n",
      caption_, head, rows_);
}

}  // namespace fathom::page
