// SPDX-License-Identifier: GPL-3.0-or-later
// The one builder of HTML and SVG. First any bytes as text that XML, HTML and terminals take: ids,
// details and settings come from others and may hold anything. Then the frame of a picture, the
// parts of pages, and pages themselves.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::picture {

/// As character data or as a quoted attribute value of XML 1.0 or HTML, in UTF-8. Tabs and line
/// ends become character references; what neither format may hold, and bytes that are not UTF-8,
/// are shown as "\x1b".
std::string markup(std::string_view text);

/// Printable ASCII; other bytes as "\x1b". At most `width` >= 3 characters: what is longer ends in
/// "...".
std::string ascii(std::string_view text, std::size_t width = static_cast<std::size_t>(-1));

/// The text with each absolute path in it cut to its last part: pages and pictures are shown to
/// others, whom folders do not concern. A path begins with a slash where a word begins, and ends at
/// a space, a quotation mark, a comma, a semicolon or a parenthesis.
std::string without_folders(std::string_view text);

/// What a picture says of itself to those who do not see it, and its size in pixels; texts are
/// markup.
struct SvgFrame {
  std::string style;  ///< its class
  double width = 0, height = 0;
  std::string name;  ///< begins the ids of its title and description
  std::string title, description;
  bool is_file = false;  ///< whether it stands alone
};
std::string svg_element(const SvgFrame& frame, const std::string& content);

// Pages: one file that needs no network, reads without scripts, and is well-formed as XML too.

/// A document. Its policy allows this style and this script and nothing else. `title` and `body`
/// are markup already.
std::string page(const std::string& title, const std::string& body);

/// The style of pages: layout in light, dark and on paper. Colours are those of style.hpp.
std::string_view page_style();

/// What scripts add to a page: filters, buttons that copy, folded parts that open for links into
/// them. It holds no character that would need an escape in XML.
std::string_view page_script();

/// A part of a whole that is shown by its size.
struct Share {
  std::string name;  ///< markup
  std::size_t count = 0;
  std::string style;  ///< "good", "fair", "left", "wrong", "lost"
  std::string link;   ///< the id that the legend refers to; empty: none
};

/// A bar of all shares that are not empty, as wide as the page, and under it each with its count.
/// `id` begins the ids of its elements; `label` says what the whole is, and is markup. Empty if all
/// shares are.
std::string share_bar(std::span<const Share> shares, const std::string& id, const std::string& label);

/// One of the kinds that a filter lets choose.
struct Choice {
  std::string kind;   ///< the value of data-kind; markup
  std::string label;  ///< markup
};

/// A form that hides the children of the element `of` that lack a text or are of another kind; seen
/// only where scripts run. `what`: what the kinds are, as "verdict".
std::string filter_bar(const std::string& of, const std::string& what, std::span<const Choice> kinds);

/// A folded text with a button that copies it, which is seen only where scripts run. `id` is that
/// of the text; `text` is escaped here.
std::string copied_text(const std::string& id, const std::string& button, const std::string& summary,
                        std::string_view text);

/// A figure on the left, or above where the page is narrow, and what is said of it; without a
/// figure what is said alone.
std::string beside(const std::string& figure, const std::string& said);

/// A box that scrolls by itself, around a table with this accessible name, which is markup. `tall`:
/// it has a limit of height too.
std::string table_box(const std::string& name, const std::string& table, bool tall);

/// A summary that opens to a text, which is markup.
std::string folded(std::string_view summary, const std::string& text);

/// Rows of a <dl>.
class FactList {
 public:
  /// Adds a row. `label`, `text` and `more` are markup; `field` is its name for scripts and tests,
  /// if it has one.
  void add(std::string_view field, std::string_view label, const std::string& text, const std::string& more = "");
  [[nodiscard]] std::string list() const { return "<dl>" + rows_ + "</dl>\n"; }

 private:
  std::string rows_;
};

/// A table that scrolls by itself if it is too wide.
class Table {
 public:
  /// `caption`: what it lists. `heads`: of the columns; those whose name begins with ' are texts,
  /// and stand to the left.
  Table(std::string caption, std::vector<std::string_view> heads);
  /// Adds a row of cells, which are markup, as many as columns; the first heads the row.
  /// `attributes`: of the row.
  void add(const std::vector<std::string>& cells, std::string_view attributes = "");
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string text() const;

 private:
  std::string caption_, rows_;
  std::vector<std::string_view> heads_;
};

// What a page may do: run the scripts and use the styles that it was made with. It asks no network
// and no other file for anything.

/// Returns the Content-Security-Policy of a page that holds exactly these texts in <script> and
/// <style> elements, and pictures as data at most. Blocks of data, <script
/// type="application/json">, are no scripts to it.
std::string security_policy(std::span<const std::string_view> scripts, std::span<const std::string_view> styles);

/// The same as the <meta> element that stands before all others of the head but the charset.
std::string policy_element(std::span<const std::string_view> scripts, std::span<const std::string_view> styles);

}  // namespace fathom::picture
