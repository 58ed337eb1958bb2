// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/two_ways.hpp"

#include <fmt/format.h>

#include <new>
#include <utility>

#include "fathom/monitor.hpp"
#include "reference/solve/disagreement.hpp"
#include "verify/harness/proof.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/shrink.hpp"
#include "verify/harness/shrink/write_shrunk.hpp"

namespace fathom::harness {
namespace {

constexpr Verdict differs = Verdict::inconsistent;  // what `shrink` is to find again

/// The answer, or what was thrown instead.
struct Attempt {
  std::optional<Depth> depth;
  std::string thrown;

  Attempt(const Case& pair, const Solver& solver, Monitor* monitor) {
    try {
      depth = solver.depth(pair, monitor);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      thrown = fmt::format("{} gave no answer: {}", solver.name, error.what());
    }
  }
};

void write(KeptDifference& kept, const std::string& directory, const Case& pair, const std::string& sentence) {
  kept.pair = pair;
  kept.sentence = sentence;
  kept.path = write_case(directory, "difference", pair, sentence);
}

}  // namespace

Solver solver_by(Method method) {
  const auto depth = [method](const Case& pair, Monitor* monitor) {
    Options options;
    options.method = method;
    options.monitor = monitor;
    return penetration_depth(pair.a, pair.b, options);
  };
  return {std::string(name(method)), depth};
}

Solver solver_with_proof() {
  Solver solver = solver_by(Method::automatic);
  solver.depth = [plain = solver.depth](const Case& pair, Monitor* monitor) {
    Depth depth = plain(pair, monitor);
    static_cast<void>(accepted_certificate(pair, depth, monitor));
    return depth;
  };
  return solver;
}

std::optional<std::string> difference(const Case& pair, const Solver& x, const Solver& y, Monitor* monitor) {
  const Attempt one(pair, x, monitor), other(pair, y, monitor);
  for (const Attempt* attempt : {&one, &other})
    if (!attempt->depth) return attempt->thrown;
  const std::optional<std::string> where = solve::disagreement(*one.depth, *other.depth);
  if (!where) return std::nullopt;
  return fmt::format("{} and {} differ: {}", x.name, y.name, *where);
}

KeptDifference keep_difference(const std::string& directory, const Case& pair, const std::string& sentence, const Solver& x,
                               const Solver& y, const std::function<bool()>& stop) {
  KeptDifference kept;
  write(kept, directory, pair, sentence);
  const Examine examine = [&](const Case& candidate) {
    Outcome outcome = outcome_for(candidate);
    const std::optional<std::string> found = difference(candidate, x, y);
    outcome.verdict = found ? differs : Verdict::pass;
    outcome.detail = found.value_or("");
    return outcome;
  };
  const auto better = [&](const Shrunk& best) { write(kept, directory, best.pair, best.outcome.detail); };
  ShrinkSettings settings;
  settings.certify = false;  // the truth itself is in doubt
  if (as_seen(pair, settings.precision)) shrink(pair, differs, examine, better, stop, settings);
  return kept;
}

}  // namespace fathom::harness
