// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record_order.hpp"

namespace fathom::golden {

std::string RecordOrder::expected() const {
  if (seen_ < awaited_.size()) return awaited_[seen_];
  return begun_ < recipes_->size() ? id_of((*recipes_)[begun_]) : "";
}

std::optional<std::string> RecordOrder::next(std::string_view id, const std::vector<std::string>& ids) {
  const std::string awaited = expected();
  if (awaited.empty()) return "the plan has no more records";
  if (id != awaited) return "expected the record " + awaited;
  if (seen_ == awaited_.size()) {
    awaited_ = ids;
    seen_ = 0;
    ++begun_;
  }
  ++seen_;
  return std::nullopt;
}

std::optional<std::string> RecordOrder::at_end() const {
  const std::string awaited = expected();
  return awaited.empty() ? std::nullopt : std::optional("the record " + awaited + " is missing");
}

}  // namespace fathom::golden
