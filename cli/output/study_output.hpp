// SPDX-License-Identifier: GPL-3.0-or-later
// Studies for people (tables, and a page), for programs (JSON, study.schema.json) and for
// spreadsheets (CSV, RFC 4180 with "\n").
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
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

// The words of studies, which tables for people and pages share.

/// "8 vertices, 12 edges, 6 facets"; "1 disc, radius 1/2".
std::string size_text(const BodySize& size);
std::string size_text(const ShapeSize& size);

/// "penetrating; depth^2 1/16; 1 optimum"; "penetrating; signed depth 1/2".
std::string status_text(const Depth& depth);
std::string status_text(const SignedDepth& depth);

/// "penetrating"; "undecided" if the bounds leave it open.
std::string_view status_name(const SignedDepth& depth);

/// "axis (0, 0, 1) at (0, 0, 0)".
std::string feature_text(const ShapeFeature& feature);
/// "A axis ..., B axis ...".
std::string involved_text(const ShapeInvolved& involved);

// Studies as one page: what coincides, in a table that lights the features in the picture, and what
// the perturbation decided.
//                                                                   [docs/command_line.md, "study"]

/// The page of one case, or of a stream, whose cases are folded. Cases come one after another, in
/// the order in which they are shown.
class StudyPage {
 public:
  /// `stream`: cases are folded, and totals stand before them.
  explicit StudyPage(bool stream) : stream_(stream) {}

  void add(const Case& pair, const Study& study);
  void add(const Case& pair, const ShapeStudy& study);
  /// A case that has no study.
  void add_fault(const std::string& sentence);

  /// The whole page. `command`: the line that made it; `cut_short`: why it is not about all cases,
  /// or empty.
  [[nodiscard]] std::string html(const std::string& command, const std::string& cut_short) const;

 private:
  struct Total {
    std::size_t cases = 0, count = 0;
  };
  template <class AnyStudy, class Names>
  void take(const Case& pair, const AnyStudy& study, std::string_view status, const std::string& headline,
            const Names& names);
  [[nodiscard]] std::string head() const;
  [[nodiscard]] std::string totals() const;
  [[nodiscard]] std::string case_by_case() const;
  [[nodiscard]] std::string without_study() const;

  bool stream_;
  std::size_t cases_ = 0, shown_ = 0;
  std::string title_, headline_;  // of the last case, escaped
  std::map<std::string, std::size_t> statuses_;
  std::map<std::string, Total> coincidences_;  // by name, as spoken
  std::vector<std::string> faults_;
  std::string sections_;
};

}  // namespace fathom::cli
