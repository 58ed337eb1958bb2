// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of the HTML page. Each is a whole element or a few; texts of others are escaped in them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "verify/harness/report/html.hpp"
#include "verify/harness/report/tally.hpp"

namespace fathom::harness {

/// The style of the page: light, dark, on paper.
std::string_view page_style();

/// The counts and errors of each family.
std::string tally_table(const Tally& tally);

/// How often errors of each size came, one row for each verdict; empty if no depth was claimed at all. `in_u_r`: in units of uR, else
/// relative. `tolerance`: a line at that size, if it is positive.
std::string histogram(std::span<const Outcome> outcomes, bool in_u_r, double tolerance);

/// All of one failure. `anchor` is its id in the page.
std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor);

}  // namespace fathom::harness
