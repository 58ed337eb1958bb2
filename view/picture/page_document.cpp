// SPDX-License-Identifier: GPL-3.0-or-later
// The document around a page.
#include <fmt/format.h>

#include <array>

#include "view/picture/markup.hpp"
#include "view/picture/style.hpp"

namespace fathom::picture {

std::string page(const std::string& title, const std::string& body) {
  const std::string style = colour_style() + picture_style() + std::string(page_style());
  const std::array<std::string_view, 1> scripts{page_script()}, styles{style};
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>{}"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/><title>{}</title><style>{}</style></head>\n<body>\n"
      "{}<script>{}</script></body></html>\n",
      policy_element(scripts, styles), title, style, body, page_script());
}

}  // namespace fathom::picture
