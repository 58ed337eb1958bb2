// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/golden/release/real_cases.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "fathom/files.hpp"

namespace fathom::golden {
namespace {

std::vector<Case> read_all() {
  constexpr std::string_view prefix = "real::";
  std::vector<Case> cases;
  std::string_view text = real_cases_text();
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    CaseItem item = parse_case(text.substr(0, length), "real_cases.jsonl", line);
    if (!item.ok()) throw item.error();
    Case& found = cases.emplace_back(std::get<Case>(std::move(item.outcome)));
    if (found.id.starts_with(prefix)) found.id.erase(0, prefix.size());
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return cases;
}

}  // namespace

std::span<const Case> real_cases() {
  static const std::vector<Case> cases = read_all();
  return cases;
}

const Case* find_real_case(std::string_view name) {
  const std::span<const Case> all = real_cases();
  const auto found = std::ranges::find(all, name, &Case::id);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace fathom::golden
