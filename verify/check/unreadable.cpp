// SPDX-License-Identifier: Apache-2.0
#include "unreadable.hpp"

#include "budget.hpp"
#include "lines.hpp"
#include "parser.hpp"

namespace fathom_check {

std::string unreadable(std::string_view text, const Limits& limits) {
  Lines lines(text, longest_line);
  Parser parser(lines, limits);
  Certificate certificate;
  try {
    parser.find_next();
    parser.read(certificate);
    return "";
  } catch (const Fault& fault) {
    return fault.what();
  }
}

}  // namespace fathom_check
