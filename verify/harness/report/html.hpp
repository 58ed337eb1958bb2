// SPDX-License-Identifier: GPL-3.0-or-later
// A run as one page that needs nothing else: no script, no font, no picture from elsewhere. The table, error histograms, and of each
// failure the pair, the claim and the truth.                                                                      [docs/certify.md]
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {

/// A failure that is shown in full.
struct HtmlFailure {
  Outcome outcome;
  Case seen;                     ///< its points, as the subject saw them
  std::string certificate_name;  ///< of the file that proves the truth; empty if there is none
};

inline constexpr std::size_t most_shown_failures = 200;

/// Which outcomes to show in full: indices of failures, worst first. Of each verdict and of each family at least one, as far as `most`
/// reaches, then the largest errors.
std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most = most_shown_failures);

/// The page. `outcomes` are all of the run; those of `failures` are shown in full, and the other failures of `outcomes` as a table. Solves
/// each pair of `failures` once more, for the picture. Well-formed whatever ids and details hold.
std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes, std::span<const HtmlFailure> failures,
                      const Tolerance& tolerance, const RunInfo& from = {});

}  // namespace fathom::harness
