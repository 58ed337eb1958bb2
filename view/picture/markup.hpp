// SPDX-License-Identifier: GPL-3.0-or-later
// The builder of HTML and SVG. First escaping of any bytes for XML, HTML and terminals, because
// ids, details and settings are foreign texts. Then the frame of a picture, the parts of pages,
// pages themselves, and the style of them all.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::picture {

/// Returns the text as character data or a quoted attribute value of XML 1.0 or HTML, in UTF-8.
/// Tabs and line ends become character references; characters that neither format allows, and bytes
/// that are not UTF-8, are shown as "\x1b".
std::string markup(std::string_view text);

/// Returns printable ASCII, with other bytes as "\x1b". At most `width` >= 3 characters: a longer
/// text ends in "...".
std::string ascii(std::string_view text, std::size_t width = static_cast<std::size_t>(-1));

/// Returns the text with each absolute path in it cut to its last part, because folders are private
/// and pages and pictures are shown to others. A path begins with a slash at the beginning of a
/// word, and ends at a space, a quotation mark, a comma, a semicolon or a parenthesis.
std::string without_folders(std::string_view text);

/// The accessible texts of a picture, which are markup, and its size in pixels.
struct SvgFrame {
  std::string style;  ///< its class
  double width = 0, height = 0;
  std::string name;  ///< begins the ids of its title and description
  std::string title, description;
  bool is_file = false;  ///< whether it is a file of its own
};
std::string svg_element(const SvgFrame& frame, const std::string& content);

// Pages: each is one file that needs no network, is readable without scripts, and is well-formed as
// XML too.

/// Returns a document. Its policy allows this style and this script and nothing else. `title` and
/// `body` are markup.
std::string page(const std::string& title, const std::string& body);

/// Returns the style of pages: layout in light, dark and on paper. Colours are those below.
std::string_view page_style();

/// Returns the script of pages: filters, buttons that copy, and folded parts that open for links
/// into them. It has no character that would need an escape in XML.
std::string_view page_script();

/// A part of a whole that is shown by its size.
struct Share {
  std::string name;  ///< markup
  std::size_t count = 0;
  std::string style;  ///< "good", "fair", "left", "wrong", "lost"
  std::string link;   ///< the id that the legend refers to; empty: none
};

/// Returns a bar of all shares that are not empty, as wide as the page, and under it each with its
/// count. `id` begins the ids of its elements; `label` describes the whole, and is markup. Empty if
/// all shares are.
std::string share_bar(std::span<const Share> shares, const std::string& id, const std::string& label);

/// A kind that can be chosen in a filter.
struct Choice {
  std::string kind;   ///< the value of data-kind; markup
  std::string label;  ///< markup
};

/// Returns a form that hides the children of the element `of` that lack a text or are of another
/// kind; visible only if scripts run. `what`: the name of the kinds, as "verdict".
std::string filter_bar(const std::string& of, const std::string& what, std::span<const Choice> kinds);

/// Returns a folded text with a button that copies it, which is visible only if scripts run. `id`
/// is that of the text; `text` is escaped here.
std::string copied_text(const std::string& id, const std::string& button, const std::string& summary,
                        std::string_view text);

/// Returns a figure on the left, or above if the page is narrow, and the text about it; without a
/// figure the text alone.
std::string beside(const std::string& figure, const std::string& said);

/// Returns a box that scrolls on its own, around a table with this accessible name, which is
/// markup. `tall`: limits its height too.
std::string table_box(const std::string& name, const std::string& table, bool tall);

/// Returns a summary that opens to a text, which is markup.
std::string folded(std::string_view summary, const std::string& text);

/// Rows of a <dl>.
class FactList {
 public:
  /// Adds a row. `label`, `text` and `more` are markup; `field` is its name for scripts and tests,
  /// or "".
  void add(std::string_view field, std::string_view label, const std::string& text, const std::string& more = "");
  [[nodiscard]] std::string list() const { return "<dl>" + rows_ + "</dl>\n"; }

 private:
  std::string rows_;
};

/// A table that scrolls on its own if it is too wide.
class Table {
 public:
  /// `caption`: the contents of the table. `heads`: the headings of the columns; one that begins
  /// with ' is of a column of texts, and is aligned left.
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

// The policy of a page: it may run the scripts and use the styles that it was made with, and may
// load nothing from the network or from other files.

/// Returns the Content-Security-Policy of a page that holds exactly these texts in <script> and
/// <style> elements, and pictures as data at most. Blocks of data, <script
/// type="application/json">, are no scripts to it.
std::string security_policy(std::span<const std::string_view> scripts, std::span<const std::string_view> styles);

/// Returns the same as the <meta> element that precedes all others of the head but the charset.
std::string policy_element(std::span<const std::string_view> scripts, std::span<const std::string_view> styles);

// The style of every page and picture: one set of colours, for light, dark and paper, and the rules
// for drawing pictures. The colours for A, B, the truth and the claim can be distinguished by the
// colour-blind, and each has a second sign: A is toned, B is hatched, the claim is dashed.

/// Returns the colours as custom properties of the root: --ground, --ink, --soft, --line, --shade,
/// --a, --b, --true, --claimed, --link, --lit. They depend on prefers-color-scheme; print is light.
/// Has no other rules.
std::string colour_style();

/// Returns the rules for elements of class "wide", which scroll sideways: a shadow at an edge shows
/// that there is more beyond it, because phones show no scroll bar.
std::string_view scroll_style();

/// Returns the rules with each "@name" replaced by the custom property of that colour; `plain`:
/// each property twice, first with the light colour, for programs without var().
std::string coloured(std::string_view rules, bool plain);

/// Returns the rules for the output of scene_panels and scene_document, in the colours of
/// colour_style.
std::string picture_style();

/// Returns both, for an SVG file. Programs without custom properties draw it in light colours.
std::string document_style();

}  // namespace fathom::picture
