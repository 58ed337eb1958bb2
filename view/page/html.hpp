// SPDX-License-Identifier: GPL-3.0-or-later
// Small pieces of HTML over JSON values.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "view/page/parts.hpp"

namespace fathom::page {

/// The value of a field; null if the object has none, or is none.
const Data& at(const Data& object, std::string_view key);

/// A number, a word, or (1, 2, 3) of an array, as text that is escaped; "-" for null. Very long texts are cut, and say so.
std::string shown(const Data& value);

/// "1 way", "2 ways".
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

/// Points of a body, as "1, 5, 7".
std::string points(const Data& ids);

/// A summary that opens to `text`, which is markup.
std::string on_demand(std::string_view summary, const std::string& text);

/// Rows of a <dl>. Each has a name for scripts and tests.
class Rows {
 public:
  /// Adds a row; `text` and `more` are markup.
  void add(std::string_view field, std::string_view label, const std::string& text, const std::string& more = "");
  [[nodiscard]] std::string list() const;

 private:
  std::string rows_;
};

/// A table that scrolls by itself if it is too wide.
class Table {
 public:
  /// `caption`: what it lists. `heads`: of the columns; those whose name begins with ' are texts, and stand to the left.
  Table(std::string caption, std::vector<std::string_view> heads);
  /// Adds a row of cells, which are markup, as many as columns; the first heads the row. `attributes`: of the row, as markup.
  void add(const std::vector<std::string>& cells, std::string_view attributes = "");
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string text() const;

 private:
  std::string caption_, rows_;
  std::vector<std::string_view> heads_;
};

}  // namespace fathom::page
