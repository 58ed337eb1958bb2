// SPDX-License-Identifier: GPL-3.0-or-later
// Studies for people (tables, of streams also on a page), for programs (JSON, study.schema.json)
// and for spreadsheets (CSV, RFC 4180 with "\n").
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/study.hpp"
#include "reference/text/json.hpp"
#include "verify/study/study.hpp"

namespace fathom::cli {

using text::Json;

/// Several lines, without the last newline. `all`: with every coincidence that the study lists.
std::string study_block(const Study& study, bool all);

/// "parallel edges", for parallel_edges.
std::string spoken(std::string_view name);

/// One line, without its newline: what is not zero.
std::string study_line(const std::string& id, const Study& study);

/// The same for shapes.
std::string study_block(const ShapeStudy& study, bool all);
std::string study_line(const std::string& id, const ShapeStudy& study);
std::string study_json(const std::string& id, const ShapeStudy& study);

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string study_json(const std::string& id, const Study& study);
/// Returns the line for a case of a stream that has no study.
std::string study_json_error(const std::string& id, std::size_t line, const std::string& error);

/// The names of the columns; a row of counts; a row with nothing but an error. Without their
/// newlines.
std::string study_csv_header();
std::string study_csv_row(const std::string& id, const Study& study);
std::string study_csv_error(const std::string& id, const std::string& error);

// The studies of a stream as one page, a table: what coincides in which case. Of a single case the
// page is that of `explain`.

/// What the table says of a case.
struct StudyTableRow {
  std::string id, status, headline;
  std::vector<std::pair<std::string_view, std::uint64_t>> present;  ///< what coincides, and how often
};
StudyTableRow table_row(const std::string& id, const Study& study);
StudyTableRow table_row(const std::string& id, const ShapeStudy& study);

/// Cases come one after another, in the order in which they are shown.
class StudyTable {
 public:
  void add(const StudyTableRow& row);
  /// A case that has no study.
  void add_fault(const std::string& sentence);

  /// The page. `command`: the line that made it; `cut_short`: why it is not about all cases, or
  /// empty.
  [[nodiscard]] std::string html(const std::string& command, const std::string& cut_short) const;

 private:
  struct Total {
    std::uint64_t cases = 0, count = 0;
  };
  [[nodiscard]] std::string totals() const;
  [[nodiscard]] std::string without_study() const;

  std::size_t cases_ = 0;
  std::map<std::string, std::size_t> statuses_;
  std::map<std::string_view, Total> coincidences_;
  std::size_t faults_ = 0;
  std::string fault_items_;  // of the first of them
  std::string rows_;
};

}  // namespace fathom::cli
