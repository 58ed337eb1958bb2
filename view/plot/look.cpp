// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/plot/look.hpp"

namespace fathom::plot {

std::string_view colours() {
  return R"(:root { color-scheme: light dark; --ground: #ffffff; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --shade: #f6f8fa;
  --a: #0550ae; --b: #8a4600; --true: #116329; --claimed: #a40e26; --link: #0550ae; }
@media (prefers-color-scheme: dark) { :root { --ground: #14181d; --ink: #e6edf3; --soft: #9da7b1; --line: #3d444d; --shade: #1d232a;
  --a: #79c0ff; --b: #f0b072; --true: #56d364; --claimed: #ff8f88; --link: #79c0ff; } }
@media print { :root { --ground: #fff; --ink: #000; --soft: #444; --line: #999; --shade: #fff; --a: #0550ae; --b: #8a4600; --true: #116329;
  --claimed: #a40e26; --link: #0550ae; } }
)";
}

std::string markup(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) result += ' ';
    else result += c;
  }
  return result;
}

}  // namespace fathom::plot
