// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as one page: what coincides, in a table that lights the features in the picture, and what
// the perturbation decided.
//                                                                   [docs/command_line.md, "study"]
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "verify/study/study.hpp"

namespace fathom::cli {

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
