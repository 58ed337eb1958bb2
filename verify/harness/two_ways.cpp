// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/two_ways.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

#include "fathom/judge.hpp"
#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "reference/solve/disagreement.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/reproducer.hpp"
#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {
namespace {

constexpr Verdict differs = Verdict::inconsistent;  // what `shrink` is to find again

/// The answer, or what was thrown instead.
template <class Answer>
struct Attempt {
  std::optional<Answer> answer;
  std::string thrown;

  Attempt(const std::string& name, const std::function<Answer(const Case&, Monitor*)>& solve, const Case& pair, Monitor* monitor) {
    try {
      answer = solve(pair, monitor);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      thrown = fmt::format("{} gave no answer: {}", name, error.what());
    }
  }
};

std::string shown(const std::vector<Point>& points) {
  std::string result;
  for (const Point& p : points)
    result += fmt::format("{}({}, {}, {})", result.empty() ? "" : " ", exact_text(p.x), exact_text(p.y), exact_text(p.z));
  return result;
}

std::optional<std::string> disagreement(const UnionsFound& x, const UnionsFound& y) {
  if (x.status != y.status) return fmt::format("status: {} and {}", name(x.status), name(y.status));
  if (x.squared != y.squared) return fmt::format("squared: {} and {}", exact_text(x.squared), exact_text(y.squared));
  if (x.translations == y.translations) return std::nullopt;
  return fmt::format("translations: {} and {}", shown(x.translations), shown(y.translations));
}

template <class Answer, class Disagreement>
std::optional<std::string> compared(const Case& pair, const Solver& x, const Solver& y, Monitor* monitor,
                                    std::function<Answer(const Case&, Monitor*)> Solver::*way, const Disagreement& disagreement) {
  const Attempt<Answer> one(x.name, x.*way, pair, monitor), other(y.name, y.*way, pair, monitor);
  for (const Attempt<Answer>* attempt : {&one, &other})
    if (!attempt->answer) return attempt->thrown;
  const std::optional<std::string> where = disagreement(*one.answer, *other.answer);
  if (!where) return std::nullopt;
  return fmt::format("{} and {} differ: {}", x.name, y.name, *where);
}

UnionsFound proved_answer(const Case& pair, Monitor* monitor) {
  const UnionTruth truth = truth_about(pieces_of(pair.a), pieces_of(pair.b), {monitor, true});
  static_cast<void>(accepted_certificate(pair.id, truth, monitor));
  UnionsFound answer{truth.depth.status, truth.depth.apart ? truth.depth.apart->distance.squared : truth.depth.squared(), {}};
  if (answer.status == Status::penetrating)
    for (const UnionOptimum& optimum : truth.depth.optima) answer.translations.push_back(optimum.translation);
  return answer;
}

/// The body without one of its pieces.
Body without(const Body& body, std::size_t piece) {
  Pieces pieces = pieces_of(body);
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(piece));
  return Body{.points = {}, .pieces = std::make_shared<const Pieces>(std::move(pieces))};
}

void write(KeptDifference& kept, const std::string& directory, const Case& pair, const std::string& sentence) {
  kept.pair = pair;
  kept.sentence = sentence;
  kept.path = write_case(directory, "difference", pair, sentence);
}

/// Goes on while the difference is there without some piece; a body keeps one.
void drop_pieces(KeptDifference& kept, const std::string& directory, const Solver& x, const Solver& y, const std::function<bool()>& stop) {
  for (Body Case::*of : {&Case::a, &Case::b})
    for (std::size_t i = pieces_of(kept.pair.*of).size(); i-- > 0 && pieces_of(kept.pair.*of).size() > 1;) {
      if (stop && stop()) return;
      Case smaller = kept.pair;
      smaller.*of = without(kept.pair.*of, i);
      if (const std::optional<std::string> found = difference(smaller, x, y)) write(kept, directory, smaller, *found);
    }
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
  solver.of_unions = proved_answer;
  return solver;
}

std::optional<std::string> difference(const Case& pair, const Solver& x, const Solver& y, Monitor* monitor) {
  if (!has_union(pair)) return compared(pair, x, y, monitor, &Solver::depth, solve::disagreement);
  return compared(pair, x, y, monitor, &Solver::of_unions,
                  [](const UnionsFound& one, const UnionsFound& other) { return disagreement(one, other); });
}

KeptDifference keep_difference(const std::string& directory, const Case& pair, const std::string& sentence, const Solver& x,
                               const Solver& y, const std::function<bool()>& stop) {
  KeptDifference kept;
  write(kept, directory, pair, sentence);
  if (has_union(pair)) {
    drop_pieces(kept, directory, x, y, stop);
    return kept;
  }
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
