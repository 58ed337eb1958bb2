// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <mutex>
#include <system_error>
#include <thread>
#include <variant>

#include "fathom/shape.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/examiner.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {
namespace {

mpq_class extent_of(const Body& body) {
  if (body.pieces) return judging::sizes_of(*body.pieces, *body.pieces).extent;
  if (body.shape) return judging::sizes_of(*body.shape, *body.shape, judging::usual_bits).extent;
  return judging::sizes_of(body.points.exact(), body.points.exact()).extent;
}

bool has_usual_size(const Body& body) {
  if (body.shape && std::holds_alternative<HalfSpace>(body.shape->core)) return true;
  const mpq_class longest = extent_of(body);
  return longest >= mpq_class(1, 100) && longest <= 100;
}

// Cases that every engine is made for are counted apart.                                                    [docs/certify.md]

/// Whether both bodies have a volume; exact.
bool is_solid(const Case& pair) {
  const auto is_flat = [](const Body& body) { return !body.pieces && fathom::is_flat(files::shape_of(body)); };  // pieces have interiors
  return !is_flat(pair.a) && !is_flat(pair.b);
}

/// Whether the length is above that of the longest side of the bodies' boxes.
bool is_dwarfed_by(const mpq_class& length, const Case& pair) { return length > 0 && length > sizes_of(pair).extent; }

/// Whether the longest side of each body's box is from 1/100 to 100, in the numbers of the case: exact of points, and of shapes rounded up
/// by 2^-40 of itself at most. A half-space has any size.
bool is_metre_sized(const Case& pair) { return has_usual_size(pair.a) && has_usual_size(pair.b); }

class Run {
 public:
  explicit Run(const RunPlan& plan) : plan_(plan) {}

  void work() {
    try {
      const Worker worker = make_worker();
      while (const std::optional<Case> pair = next()) examine_guarded(*pair, worker.examine);
      if (worker.finish) worker.finish();
    } catch (...) {
      const std::lock_guard lock(results_);
      if (!error_) error_ = std::current_exception();
      ended_ = true;
    }
  }

  void finish() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  Worker make_worker() {
    const std::lock_guard lock(source_);
    return plan_.worker();
  }

  std::optional<Case> next() {
    const std::lock_guard lock(source_);
    if (ended_) return std::nullopt;
    std::optional<Case> pair = plan_.next();
    if (!pair) ended_ = true;
    return pair;
  }

  void examine_guarded(const Case& pair, const ExamineInUnit& examine) {
    try {
      examine_all(pair, examine);
    } catch (...) {
      const std::lock_guard lock(results_);
      plan_.fault(pair, std::current_exception());
    }
  }

  /// The case and its variants.
  void examine_all(const Case& pair, const ExamineInUnit& examine) {
    std::string why;
    const long exponent = exponent_to_fit(pair, plan_.fit);
    const NumberFormat format = in_unit(plan_.format, exponent);
    const std::optional<Case> seen = as_seen(pair, format, plan_.shapes, &why);
    if (!seen) {
      outcome_of(pair, pair, "", [&] { return declined(pair, why); });
      return;
    }
    bool fresh = exponent == 0;  // in another unit a report may hold fewer digits of an answer
    const auto ask = [&] {
      fresh = true;
      return examine(*seen, exponent);
    };
    Outcome original = outcome_of(*seen, *seen, "", ask);
    if (plan_.variants.empty()) return;
    std::vector<std::string> sentences;
    for (const Variant& variant : variants(*seen, format, plan_.variants, &sentences)) {
      outcome_of(*seen, variant.seen, variant.name, [&] {
        if (!fresh) original = ask();
        return compare_variant(original, examine(variant.seen, exponent), variant, plan_.tolerance);
      });
    }
    const std::lock_guard lock(results_);
    for (const std::string& sentence : sentences) plan_.left_out(pair, sentence);
  }

  template <class Find>
  Outcome outcome_of(const Case& original, const Case& seen, const std::string& variant, const Find& find) {
    const Outcome* known = plan_.known ? plan_.known(seen.id, variant, digest_of(seen)) : nullptr;
    Outcome outcome = known ? *known : find();
    outcome.variant = variant;
    tell(original, seen, outcome, known != nullptr);
    return outcome;
  }

  void tell(const Case& original, const Case& seen, Outcome outcome, bool known) {
    outcome.solid = is_solid(original);
    outcome.metre_sized = is_metre_sized(original);
    outcome.dwarfed = is_dwarfed_by(outcome.radii, original);
    const std::lock_guard lock(results_);
    plan_.found(original, seen, outcome, known);
  }

  const RunPlan& plan_;
  std::mutex source_, results_;
  std::atomic<bool> ended_ = false;
  std::exception_ptr error_;
};

}  // namespace

void run(const RunPlan& plan) {
  Run run(plan);
  const unsigned jobs = std::max(plan.jobs, 1U);
  std::vector<std::thread> others;
  others.reserve(jobs);
  try {
    while (others.size() + 1 < jobs) others.emplace_back([&run] { run.work(); });
  } catch (const std::system_error&) {  // no more threads to be had: those that there are do the work
  }
  run.work();
  for (std::thread& other : others) other.join();
  run.finish();
}

}  // namespace fathom::harness
