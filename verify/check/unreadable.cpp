// SPDX-License-Identifier: Apache-2.0
#include "unreadable.hpp"

#include "budget.hpp"
#include "checks.hpp"
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
    // The work of a tree is known when its planes are, so only a check finds it too much.
    if (is_of_solids(certificate) && certificate.claim == Claim::depth) check_claim(certificate);
    return "";
  } catch (const Fault& fault) {
    return fault.malformed ? fault.what() : "";
  }
}

void require_readable(std::string_view certificate, const Limits& limits) {
  const std::string why = unreadable(certificate, limits);
  if (!why.empty()) throw Unreadable("no certificate is written, since all checkers would refuse to read it: " + why);
}

}  // namespace fathom_check
