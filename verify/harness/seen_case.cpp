// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/seen_case.hpp"

#include <fmt/format.h>

#include <utility>

#include "kernels/number/parse.hpp"

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

}  // namespace

std::optional<Case> as_seen(const Case& pair, Precision precision) {
  std::optional<std::vector<Point>> a = seen(pair.a.points, precision), b = seen(pair.b.points, precision);
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

Outcome overflowed(const Case& pair, Precision precision) {
  Outcome outcome = outcome_for(pair);
  outcome.verdict = Verdict::unsupported;
  outcome.detail = fmt::format("a coordinate overflows {}, the precision of the subject", name(precision));
  return outcome;
}

void judge_answer(Outcome& outcome, const Case& seen, const Answer& answer, const SubjectInfo& info, const Tolerance& tolerance,
                  const std::function<bool()>& stop) {
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
  Options options;
  options.method = Method::certificate;
  options.progress = [&stop](const std::string&, double) { return !stop || !stop(); };
  outcome.reply = std::get<Reply>(answer.said);
  const Truth truth = truth_about(seen.a.points, seen.b.points, options);
  outcome.judgement = judge(truth, *outcome.reply, info.conventions, info.precision, tolerance);
  outcome.verdict = outcome.judgement->verdict;
  outcome.detail = answer.remark;
}

}  // namespace fathom::harness
