// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/natural_order.hpp"

#include <algorithm>
#include <cstddef>

namespace fathom::files {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the run of digits from the front of `text`; returns it without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  std::string_view p = a, q = b;
  while (!p.empty() && !q.empty()) {
    if (is_digit(p.front()) && is_digit(q.front())) {
      const std::string_view m = take_number(p), n = take_number(q);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      continue;
    }
    if (p.front() != q.front()) return p.substr(0, 1) < q.substr(0, 1);  // as unsigned bytes
    p.remove_prefix(1);
    q.remove_prefix(1);
  }
  return p.empty() != q.empty() ? p.empty() : a < b;
}

}  // namespace fathom::files
