// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate checker on arbitrary bytes: certificates one after another, or, where a brace
// comes first, a case file and a line of results. Corpus: tests/fuzz/corpus/check.
// tests/fuzz/fuzz.sh builds and runs it.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "verify/check/comparisons.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"

namespace {

using namespace fathom_check;

void require(bool law) {
  if (!law) std::abort();
}

void json(std::string_view text) {
  try {
    const CaseFile cases(text);
    cases.compare(Certificate());
  } catch (const Fault&) {
    // A refusal is a fine answer; any other exception is a finding.
  }
  try {
    Result result;
    read_result(text, 1, result);
    require(verify(result.certificate).reason.size() < 1000);
  } catch (const Fault&) {
  }
}

/// As a stream, and as one text: no certificate is lost, and a text that is accepted is complete.
void certificates(std::string_view text) {
  std::istringstream stream{std::string(text)};
  Lines lines(stream, longest_line);
  Reader reader(lines);
  std::size_t count = 0, accepted = 0;
  while (const std::optional<Verdict> verdict = reader.next()) {
    ++count;
    if (verdict->accepted()) ++accepted;
    require(verdict->accepted() == verdict->reason.empty());
    require(!verdict_line(*verdict, "x").empty());
  }
  require(count > 0);
  const Verdict alone = verify(text);
  require(alone.accepted() == (count == 1 && accepted == 1));
  if (alone.accepted()) require(!verify(text.substr(0, text.size() - 1)).accepted());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (!text.empty() && text[0] == '{') {
    json(text);
  } else {
    certificates(text);
  }
  return 0;
}
