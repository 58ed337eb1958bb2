// SPDX-License-Identifier: GPL-3.0-or-later
// What pages have in common: one file that needs no network, reads without scripts, and is well-formed as XML too.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::picture {

/// A document. Its policy allows this style and this script and nothing else. `title` and `body` are markup already.
std::string page(const std::string& title, const std::string& body);

/// The style of pages: layout in light, dark and on paper. Colours are those of style.hpp.
std::string_view page_style();

/// What scripts add to a page: filters, buttons that copy, rows that light their features, folded parts that open for links into them. It
/// holds no character that would need an escape in XML.
std::string_view page_script();

/// A part of a whole that is shown by its size.
struct Share {
  std::string name;  ///< markup
  std::size_t count = 0;
  std::string style;  ///< "good", "fair", "left", "wrong", "lost"
  std::string link;   ///< the id that the legend refers to; empty: none
};

/// A bar of all shares that are not empty, as wide as the page, and under it each with its count. `id` begins the ids of its elements;
/// `label` says what the whole is, and is markup. Empty if all shares are.
std::string share_bar(std::span<const Share> shares, const std::string& id, const std::string& label);

/// One of the kinds that a filter lets choose.
struct Choice {
  std::string kind;   ///< the value of data-kind; markup
  std::string label;  ///< markup
};

/// A form that hides the children of the element `of` that lack a text or are of another kind; seen only where scripts run. `what`: what
/// the kinds are, as "verdict".
std::string filter_bar(const std::string& of, const std::string& what, std::span<const Choice> kinds);

/// A folded text with a button that copies it, which is seen only where scripts run. `id` is that of the text; `text` is escaped here.
std::string copied_text(const std::string& id, const std::string& button, const std::string& summary, std::string_view text);

/// A figure on the left, or above where the page is narrow, and what is said of it; without a figure what is said alone.
std::string beside(const std::string& figure, const std::string& said);

/// A box that scrolls by itself, around a table with this accessible name, which is markup. `tall`: it has a limit of height too.
std::string table_box(const std::string& name, const std::string& table, bool tall);

}  // namespace fathom::picture
