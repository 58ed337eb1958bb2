// SPDX-License-Identifier: GPL-3.0-or-later
// A run as one self-contained page: without scripts, fonts or pictures from elsewhere. It has the
// table, error histograms, and for each failure the pair, the claim and the truth.
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
  Case seen;                     ///< its points, as they were put to the subject
  std::string certificate_name;  ///< the file that proves the truth; empty if there is none
};

inline constexpr std::size_t most_shown_failures = 200;
/// The most cases that have a row in the table.
inline constexpr std::size_t most_listed = 5000;

/// Returns the indices of failures to show in full, worst first: of each verdict and of each family
/// at least one, within `most`, then the largest errors.
std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most = most_shown_failures);

/// Returns the page. `outcomes` are all of the run; it shows those of `failures` in full, and the
/// other failures in a table. Solves each pair of `failures` again for its picture. Well-formed for
/// any ids and details.
std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      std::span<const HtmlFailure> failures, const Tolerance& tolerance, const RunInfo& from = {});

// ---- the parts of the page: each consists of whole elements, and escapes foreign texts ----

/// Returns the rank of a verdict on the page: wrong answers by rank, then missing answers, then
/// declined cases, then passes.
std::size_t place_on_page(Verdict verdict);

/// Returns the shares of a bar: passes, then wrong answers, then missing answers, then declined
/// cases. Verdicts in `shown` link to their sections.
std::vector<picture::Share> verdict_shares(const TallyRow& all, const std::set<Verdict>& shown);

/// Returns all about one failure. `anchor` is its id in the page.
std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor);

/// A failure of the page, and its id there.
struct Anchored {
  const HtmlFailure* failure;
  std::string anchor;
};

// ---- the picture of a failure: the truth and the reply about the same pair ----

/// Returns the translation of A that a reply claims, to within a few roundings, for directions of
/// any length. Returns nullopt if the reply has no direction, or a number of it is not finite.
std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions);

/// Returns one or two SVG elements, as view/picture paints them.
std::string pair_picture(const Truth& truth, const std::optional<Point>& claimed, const std::string& name,
                         const std::string& label);

/// Returns the same for unions.
std::string unions_picture(const UnionTruth& truth, const std::optional<Point>& claimed, const std::string& name,
                           const std::string& label);

/// Returns the same for a case of shapes, without a claim; empty if its depth is not found.
std::string shapes_picture(const Case& seen, const std::string& name, const std::string& label);

}  // namespace fathom::harness
