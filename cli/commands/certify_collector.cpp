// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/commands/certify_results.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_told = 5;  // sentences of one kind

}  // namespace

Collector::Collector(const Request& request, const harness::SubjectInfo& info, std::optional<std::size_t> expected)
    : request_(request), expected_(expected) {
  const std::string header =
      harness::header_line(info, request.certify.tolerance,
                           {FATHOM_VERSION, request.certify.command_line, "", {}, request.certify.methods, request.certify.fit});
  summary_.fit = request.certify.fit;
  const auto remember = [this](harness::Outcome outcome) {
    std::tuple key(outcome.id, outcome.variant, outcome.digest);
    known_.insert_or_assign(std::move(key), std::move(outcome));
  };
  std::vector<harness::Unattributed> earlier;
  const auto keep = [&earlier](harness::Unattributed unattributed) { earlier.push_back(std::move(unattributed)); };
  const std::string& report = request.certify.report;
  if (!report.empty())
    journal_.emplace(request.certify.resume ? harness::Journal::resume(report, header, remember, keep)
                                            : harness::Journal::create(report, header, request.certify.overwrite));
  if (request.json) print(header);
  for (const harness::Unattributed& unattributed : earlier) take(unattributed, true);
}

const harness::Outcome* Collector::known(const std::string& id, const std::string& variant, const std::string& digest) const {
  const auto found = known_.find({id, variant, digest});
  return found == known_.end() ? nullptr : &found->second;
}

void Collector::take(const Case& original, const Case& seen, const harness::Outcome& outcome, bool known) {
  const std::string line = (journal_ && !known) || request_.json ? harness::outcome_line(outcome) : "";
  if (journal_ && !known) journal_->add(line);
  if (request_.json) {
    progress_.answered();
    print(line);
  }
  summary_.add(outcome);
  outcomes_.push_back(outcome);
  if (outcome.variant.empty()) {
    ++cases_;
    if (known) ++cases_before_;
  }
  if (fails(outcome.verdict)) {
    const CertifyRequest& certify = request_.certify;
    const bool needed = !certify.html.empty() || !certify.certificates.empty() || !certify.shrink.empty();
    if (needed) failed_.push_back({outcomes_.size() - 1, seen, original});
  }
  if (outcome.judgement && outcome.judgement->error_relative) {
    const double error = std::abs(*outcome.judgement->error_relative);
    if (error > worst_) worst_ = error;
  }
  show_progress();
}

void Collector::take(const harness::Unattributed& unattributed, bool known) {
  const std::string line = harness::unattributed_line(unattributed);
  if (journal_ && !known) journal_->add(line);
  if (request_.json) {
    progress_.clear();
    print(line);
  }
  summary_.add(unattributed);
}

void Collector::show_progress() {
  progress_.count({cases_, expected_, cases_before_}, fmt::format("{} failed, worst error {:.3g}", summary_.failures(), worst_));
}

void Collector::tell(const std::string& kind, const std::string& sentence) {
  if (++told_[kind] > most_told) return;
  progress_.clear();
  talk(sentence);
}

void Collector::close() {
  progress_.clear();
  progress_.end_count();
  for (const auto& [kind, count] : told_)
    if (count > most_told) talk(fmt::format("{}: {} more like these", kind, count - most_told));
}

void Collector::complete() {
  const std::size_t all = summary_.total(), passed = summary_.passes(), failed = summary_.failures();
  const harness::Tally& tally = summary_.tally();
  const std::string line = harness::summary_line({all, passed, failed, all - passed - failed, summary_.unattributed(), tally.all().judged,
                                                  &tally.times(), &tally.hulls(), &tally.unions(), &tally.all(), tally.parts()});
  if (journal_) journal_->add(line);
  if (request_.json) print(line);
}

}  // namespace fathom::cli
