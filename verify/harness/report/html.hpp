// SPDX-License-Identifier: GPL-3.0-or-later
// A run as one page that needs nothing else: no script, no font, no picture from elsewhere. The
// table, error histograms, and of each failure the pair, the claim and the truth.
//                                                                                 [docs/certify.md]
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {

/// A failure that is shown in full.
struct HtmlFailure {
  Outcome outcome;
  Case seen;                     ///< its points, as the subject saw them
  std::string certificate_name;  ///< of the file that proves the truth; empty if there is none
};

inline constexpr std::size_t most_shown_failures = 200;
/// The most cases that have a row in the table.
inline constexpr std::size_t most_listed = 5000;

/// Which outcomes to show in full: indices of failures, worst first. Of each verdict and of each
/// family at least one, as far as `most` reaches, then the largest errors.
std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most = most_shown_failures);

/// The page. `outcomes` are all of the run; those of `failures` are shown in full, and the other
/// failures of `outcomes` as a table. Solves each pair of `failures` once more, for the picture.
/// Well-formed whatever ids and details hold.
std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      std::span<const HtmlFailure> failures, const Tolerance& tolerance, const RunInfo& from = {});

// ---- the pieces of the page: each is a whole element or a few; texts of others are escaped in
// them ----

/// Verdicts in the order of the page: wrong answers by rank, then those where there is no answer,
/// then what was declined, then passes.
std::size_t place_on_page(Verdict verdict);

/// Passes first, then what is wrong, then what has no answer, then what was declined. Those in
/// `shown` refer to their sections.
std::vector<picture::Share> verdict_shares(const TallyRow& all, const std::set<Verdict>& shown);

/// All of one failure. `anchor` is its id in the page.
std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor);

/// A failure of the page, and its id there.
struct Anchored {
  const HtmlFailure* failure;
  std::string anchor;
};

// ---- the picture of a failure: what the truth and the reply say about the same pair ----

/// The translation of A that a reply claims, to within a few roundings, for directions of any
/// length. Returns nullopt if the reply has no direction, or one that is not finite.
std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions);

/// One or two SVG elements, as view/picture paints them.
std::string pair_picture(const Truth& truth, const std::optional<Point>& claimed, const std::string& name,
                         const std::string& label);

/// The same for unions.
std::string unions_picture(const UnionTruth& truth, const std::optional<Point>& claimed, const std::string& name,
                           const std::string& label);

/// The same for a case of shapes, without a claim; empty if its depth is not found.
std::string shapes_picture(const Case& seen, const std::string& name, const std::string& label);

}  // namespace fathom::harness
