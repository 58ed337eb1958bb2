// SPDX-License-Identifier: GPL-3.0-or-later
// Outcomes made by hand, for tests of reports.
#pragma once

#include <string>

#include "verify/harness/outcome.hpp"

namespace fathom::harness::testing {

inline Outcome outcome(const std::string& id, Verdict verdict, const std::string& variant = "") {
  Outcome result;
  result.id = id;
  result.variant = variant;
  result.verdict = verdict;
  return result;
}

/// One whose depth was judged.
inline Outcome judged_outcome(const std::string& id, Verdict verdict, double relative, double u_r) {
  Outcome result = outcome(id, verdict);
  result.judgement.emplace();
  result.judgement->verdict = verdict;
  result.judgement->error_relative = relative;
  result.judgement->error_u_r = u_r;
  result.judgement->sentence = "a sentence about " + id;
  return result;
}

inline SubjectInfo judged_subject() {
  SubjectInfo result;
  result.name = "demo";
  result.version = "2.1";
  result.library = "libccd";
  result.settings = {{"epa_tolerance", "1e-4"}, {"max_iterations", "1000"}};
  return result;
}

/// Everything that breaks careless writers: markup, control characters, line ends, bytes that are
/// not UTF-8, and characters that are.
inline std::string hostile() {
  using namespace std::string_literals;
  return "<&>\"']]>\t\n\r\0\x01\x1b\x7f\x80\xff\xc0\xaf\xed\xa0\x80\xef\xbf\xbe\xf4\x90\x80\x80 \xc3\xa9\xe2\x88\x9a\xf0\x9f\x98\x80%~# -->\xc3"s;
}

}  // namespace fathom::harness::testing
