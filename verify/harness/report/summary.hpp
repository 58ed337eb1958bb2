// SPDX-License-Identifier: GPL-3.0-or-later
// The table that ends a run: what became of the cases of each family, and how large the errors were.              [docs/certify.md]
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/harness/tally.hpp"

namespace fathom::harness {

class Summary {
 public:
  void add(const Outcome& outcome) { tally_.add(outcome); }
  void add(const Unattributed& unattributed) { ++unattributed_[unattributed.detail]; }

  /// Several lines, the last with its newline: the subject with its conventions and settings, a row for each family that fails and one for
  /// the others, or for each with `all_rows`, of `outcomes` the worst failures of each verdict by name, `where` to look for more, what was
  /// judged, what the words mean, totals. At most `columns` wide, or 40 if that is more, but for the numbers of a column and for words that
  /// are longer, and pure ASCII, whatever names hold; only the verdicts that occur have a column.
  [[nodiscard]] std::string table(const SubjectInfo& subject, std::span<const Outcome> outcomes = {},
                                  const std::vector<std::string>& where = {}, std::size_t columns = 140, bool all_rows = false) const;
  [[nodiscard]] std::size_t failures() const { return tally_.all().failures(); }
  [[nodiscard]] std::size_t passes() const { return tally_.all().passes(); }
  [[nodiscard]] std::size_t total() const { return tally_.all().total; }
  /// How often something happened that is no case's fault.
  [[nodiscard]] std::size_t unattributed() const { return sum(unattributed_); }
  [[nodiscard]] const UnattributedCounts& unattributed_counts() const { return unattributed_; }
  [[nodiscard]] const Tally& tally() const { return tally_; }

  std::optional<mpq_class> fit;  ///< the size that cases were brought to

 private:
  Tally tally_;
  UnattributedCounts unattributed_;
};

}  // namespace fathom::harness
