// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record_order.hpp"

namespace fathom::golden {

std::vector<std::string> ids_of(const Recipe& recipe) {
  const Case base = base_case(recipe);
  std::vector<std::string> ids = {base.id};
  Case last = base;
  for (const Form form : {Form::binary64, Form::binary32}) {
    if (in_format(last, form)) continue;  // it holds the very points that rounding would give
    std::optional<Case> rounded = rounded_case(base, form);
    if (!rounded) continue;
    last = std::move(*rounded);
    ids.push_back(last.id);
  }
  return ids;
}

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
