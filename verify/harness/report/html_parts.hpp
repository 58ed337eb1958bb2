// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of the HTML page. Each is a whole element or a few; texts of others are escaped in them.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "verify/harness/report/html.hpp"
#include "verify/harness/tally.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {

/// Verdicts in the order of the page: wrong answers by rank, then those where there is no answer, then what was declined, then passes.
std::size_t place_on_page(Verdict verdict);

/// The subject, the answer in one line, warnings, a bar of all verdicts, and how it was judged. `shown`: the verdicts that have a section.
std::string html_header(const SubjectInfo& subject, const Tally& tally, const Tolerance& tolerance, const RunInfo& from,
                        const std::set<Verdict>& shown);

/// Passes first, then what is wrong, then what has no answer, then what was declined. Those in `shown` refer to their sections.
std::vector<picture::Share> verdict_shares(const TallyRow& all, const std::set<Verdict>& shown);

/// The counts and errors of each family. `linked`: the cells refer to the cases.
std::string tally_table(const Tally& tally);

/// How often errors of each size came, one row for each verdict; empty if no depth was claimed at all. `in_u_r`: in units of uR, else
/// relative. `tolerance`: a line at that size, if it is positive.
std::string histogram(std::span<const Outcome> outcomes, bool in_u_r, double tolerance);

/// All of one failure. `anchor` is its id in the page.
std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor);

/// A failure of the page, and its id there.
struct Anchored {
  const HtmlFailure* failure;
  std::string anchor;
};

/// Each case with its verdict, in the order of the page and worst first, as far as a page can hold them; those of `shown` refer to their
/// pictures.
std::string cases_table(std::span<const Outcome> outcomes, const std::vector<Anchored>& shown);

}  // namespace fathom::harness
