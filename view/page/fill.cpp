// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "view/page/parts.hpp"

namespace fathom::page {

std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string result;
  for (std::size_t begin = 0;;) {
    const std::size_t open = text.find("{{", begin);
    result += text.substr(begin, open - begin);
    if (open == std::string_view::npos) return result;
    const std::size_t close = text.find("}}", open);
    const auto value = close == std::string_view::npos ? values.end() : values.find(text.substr(open + 2, close - open - 2));
    if (value == values.end()) throw std::logic_error("a gap of the page without a value");
    result += value->second;
    begin = close + 2;
  }
}

}  // namespace fathom::page
