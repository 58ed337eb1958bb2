// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/seen_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "reference/solve/disagreement.hpp"
#include "verify/harness/judgement_difference.hpp"

namespace fathom::harness {
namespace {

class Fnv1a {
 public:
  void take(std::string_view text) {
    for (const char c : text) {
      state_ ^= static_cast<unsigned char>(c);
      state_ *= 0x100000001b3U;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Field by field; a witness is two points.
std::vector<std::string> missing(const Reply& reply, const std::set<std::string>& promises) {
  std::vector<std::string> result;
  const auto check = [&](const char* name, bool is_there) {
    if (!is_there && promises.contains(name)) result.emplace_back(name);
  };
  check("depth", reply.depth.has_value());
  check("direction", reply.direction.has_value());
  check("witness", reply.witness_a && reply.witness_b);
  return result;
}

/// An answer without what the hello promises contradicts it.
void hold_to_promises(Judgement& judgement, const Reply& reply, const std::set<std::string>& promises) {
  const std::vector<std::string> lacking = missing(reply, promises);
  if (!reply.overlap || lacking.empty()) return;
  const std::string sentence = fmt::format("inconsistent: the hello promises {}, and the reply has none", fmt::join(lacking, ", "));
  judgement.sentence = passes(judgement.verdict) ? sentence : judgement.sentence + "; " + sentence;
  judgement.accuracy.reset();
  std::vector<Verdict>& all = judgement.findings;
  const auto place = std::ranges::lower_bound(all, Verdict::inconsistent);
  if (place == all.end() || *place != Verdict::inconsistent) all.insert(place, Verdict::inconsistent);
  judgement.verdict = all.front();
}

}  // namespace

std::optional<Case> as_seen(const Case& pair, Precision precision) {
  std::optional<GivenPoints> a = seen(pair.a.points, precision), b = seen(pair.b.points, precision);
  if (!a || !b) return std::nullopt;
  return Case{pair.id, {*std::move(a)}, {*std::move(b)}};
}

std::string digest_of(const Case& pair) {
  Fnv1a hash;
  for (const Body* body : {&pair.a, &pair.b}) {
    for (const Point& p : body->points) hash.take(exact_text(p.x) + ' ' + exact_text(p.y) + ' ' + exact_text(p.z) + '\n');
    hash.take("\n");
  }
  return fmt::format("{:016x}", hash.value());
}

Outcome outcome_for(const Case& seen) {
  Outcome outcome;
  outcome.id = seen.id;
  outcome.digest = digest_of(seen);
  return outcome;
}

/// Stops the library when `stop` says so; it may be empty.
class StopWhen final : public Monitor {
 public:
  explicit StopWhen(const std::function<bool()>& stop) : stop_(stop) {}
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override { return stop_ && stop_(); }

 private:
  const std::function<bool()>& stop_;
};

Outcome overflowed(const Case& pair, Precision precision) {
  Outcome outcome = outcome_for(pair);
  outcome.verdict = Verdict::unsupported;
  outcome.detail = fmt::format("a coordinate overflows {}, the precision of the subject", name(precision));
  return outcome;
}

void judge_answer(Outcome& outcome, const Case& seen, const SubjectAnswer& answer, const SubjectInfo& info, const Judging& judging) {
  if (const auto* unsupported = std::get_if<Unsupported>(&answer.said)) {
    outcome.verdict = Verdict::unsupported;
    outcome.detail = unsupported->why;
    return;
  }
  if (const auto* failed = std::get_if<Failed>(&answer.said)) {
    outcome.verdict = Verdict::failed;
    outcome.detail = failed->why;
    return;
  }
  StopWhen stopping(judging.stop);
  Options options;
  options.monitor = &stopping;
  options.workspace = judging.workspace;
  outcome.reply = std::get<Reply>(answer.said);
  const auto judged = [&](const Truth& truth) { return judge(truth, *outcome.reply, info.conventions, info.precision, judging.tolerance); };
  const Truth truth = truth_about(seen.a.points, seen.b.points, options);
  outcome.judgement = judged(truth);
  for (const Solver& solver : judging.second) {
    const Truth again{truth.a, truth.b, solver.depth(seen, &stopping)};
    const auto refuse = [&](const std::string& where) {
      throw Disagreement(seen, solver, fmt::format("{} and {} differ: {}", name(Method::automatic), solver.name, where));
    };
    if (const auto where = solve::disagreement(truth.depth, again.depth)) refuse(*where);
    if (const auto where = difference(*outcome.judgement, judged(again))) refuse(*where);
  }
  hold_to_promises(*outcome.judgement, *outcome.reply, info.promises);
  outcome.verdict = outcome.judgement->verdict;
  outcome.detail = answer.remark;
}

}  // namespace fathom::harness
