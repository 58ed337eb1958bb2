// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as text (tables, for streams also on a page), as JSON (study.schema.json) and as CSV (RFC
// 4180 with "\n").
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

/// Returns several lines, without the last newline. `all`: with every coincidence that the study
/// lists.
std::string study_block(const Study& study, bool all);

/// Returns "parallel edges" for parallel_edges.
std::string spoken(std::string_view name);

/// Returns one line, without its newline, with the counts that are not zero.
std::string study_line(const std::string& id, const Study& study);

/// Returns the same for shapes.
std::string study_block(const ShapeStudy& study, bool all);
std::string study_line(const std::string& id, const ShapeStudy& study);
std::string study_json(const std::string& id, const ShapeStudy& study);

/// Returns one line, without its newline, in ASCII for any id.
std::string study_json(const std::string& id, const Study& study);
/// Returns the line for a case of a stream that has no study.
std::string study_json_error(const std::string& id, std::size_t line, const std::string& error);

/// Return the names of the columns; a row of counts; a row with nothing but an error. Without their
/// newlines.
std::string study_csv_header();
std::string study_csv_row(const std::string& id, const Study& study);
std::string study_csv_error(const std::string& id, const std::string& error);

// The studies of a stream as one page, a table of the coincidences of each case. The page of a
// single case is that of `explain`.

/// A row of the table.
struct StudyTableRow {
  std::string id, status, headline;
  std::vector<std::pair<std::string_view, std::uint64_t>> present;  ///< the coincidences that occur, with their counts
};
StudyTableRow table_row(const std::string& id, const Study& study);
StudyTableRow table_row(const std::string& id, const ShapeStudy& study);

/// The table. Cases are added in the order in which they are shown.
class StudyTable {
 public:
  void add(const StudyTableRow& row);
  /// Adds a case that has no study.
  void add_fault(const std::string& sentence);

  /// Returns the page. `command`: the command line that made it; `cut_short`: why cases are
  /// missing, or "".
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
  std::string fault_items_;  // of the first most_faults of them
  std::string rows_;
};

}  // namespace fathom::cli
