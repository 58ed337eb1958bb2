// SPDX-License-Identifier: GPL-3.0-or-later
// A run as JUnit XML, for the systems that run tests of others: a suite for each family, a test case for each case.
//
//   pass, touching-by-convention                test case without a child
//   unsupported                                 <skipped>
//   crash, time-out, silent, garbage, failed    <error>
//   any other failure                           <failure>, its type the verdict
//   a failure that the list of known ones has   <skipped>
//   a listed failure that passes now            <failure type="unexpected-pass">
//   a listed failure that no case met           <failure type="not-met"> in a suite "known failures"
#pragma once

#include <span>
#include <string>

#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {

/// A whole document in UTF-8, well-formed whatever ids, details and replies hold; it depends on its arguments alone. Order: families by
/// name, cases as given. `known` is what ExpectedFailures::check said, and empty without a list; `from` is in the properties.
std::string junit_xml(const SubjectInfo& subject, std::span<const Outcome> outcomes, const ExpectedFailures::Check& known = {},
                      const RunInfo& from = {});

}  // namespace fathom::harness
