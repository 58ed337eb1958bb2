// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/two_ways.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/certificate.hpp"
#include "fathom/judge.hpp"
#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "fathom/union.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/solve/depth.hpp"
#include "verify/check/check.hpp"
#include "verify/check/reader.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {
namespace {

constexpr unsigned most_random_pieces = 5;

constexpr unsigned least_random_size = 4, most_random_size = 40;

/// Returns the number in the checker's notation.
std::string surd_text(const Surd& value) {
  return fmt::format("{}sqrt({})+{}", value.root < 0 ? "-" : "", exact_text(abs(value.root)),
                     exact_text(value.rational));
}

/// Returns the checker's verdict. Throws fathom_check::Unreadable if the text exceeds the limits of
/// checkers, std::logic_error if the checker refuses the proof.
fathom_check::Verdict acceptance(const std::string& id, const std::string& text) {
  fathom_check::require_readable(text);
  fathom_check::Verdict verdict = fathom_check::verify(text);
  if (!verdict.accepted())
    throw std::logic_error(fmt::format("the certificate of {} is refused: {}", id, verdict.reason));
  return verdict;
}

constexpr Verdict differs = Verdict::inconsistent;  // the verdict that `shrink` looks for

/// The answer, or the message of the exception in its place.
template <class Answer>
struct Attempt {
  std::optional<Answer> answer;
  std::string thrown;

  Attempt(const std::string& name, const std::function<Answer(const Case&, Monitor*)>& solve, const Case& pair,
          Monitor* monitor) {
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
    result +=
        fmt::format("{}({}, {}, {})", result.empty() ? "" : " ", exact_text(p.x), exact_text(p.y), exact_text(p.z));
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
                                    std::function<Answer(const Case&, Monitor*)> Solver::*way,
                                    const Disagreement& disagreement) {
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
  UnionsFound answer{
      truth.depth.status, truth.depth.apart ? truth.depth.apart->distance.squared : truth.depth.squared(), {}};
  if (answer.status == Status::penetrating)
    for (const UnionOptimum& optimum : truth.depth.optima) answer.translations.push_back(optimum.translation);
  return answer;
}

/// Returns the body without one of its pieces.
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

/// Drops pieces as long as the difference remains; a body keeps one.
void drop_pieces(KeptDifference& kept, const std::string& directory, const Solver& x, const Solver& y,
                 const std::function<bool()>& stop) {
  for (Body Case::*of : {&Case::a, &Case::b})
    for (std::size_t i = pieces_of(kept.pair.*of).size(); i-- > 0 && pieces_of(kept.pair.*of).size() > 1;) {
      if (stop && stop()) return;
      Case smaller = kept.pair;
      smaller.*of = without(kept.pair.*of, i);
      if (const std::optional<std::string> found = difference(smaller, x, y)) write(kept, directory, smaller, *found);
    }
}

/// Returns a random case of these families.
Case random_of(std::span<const families::Family> families, std::uint64_t seed, std::uint64_t number, unsigned least,
               unsigned most) {
  families::Random random(families::Random(seed).next() + number);
  const auto size = static_cast<unsigned>(random.between(least, most));
  const std::uint64_t of_family = random.next();
  Case pair = families[number % families.size()].make(of_family, size);
  const std::int64_t form = random.between(0, 2);
  if (form == 0) return pair;
  const Precision precision = form == 1 ? Precision::binary64 : Precision::binary32;
  std::optional<Case> rounded = as_seen(pair, precision);
  if (!rounded) return pair;
  rounded->id += precision == Precision::binary64 ? ".b64" : ".b32";
  return *std::move(rounded);
}

/// Threads take numbers in ascending order and finish each one that they take. So when all are
/// done, every case below the least number with a difference has been compared.
class Comparer {
 public:
  Comparer(const StreamPlan& plan, const Solver& x, const Solver& y) : plan_(&plan), x_(&x), y_(&y), next_(plan.from) {}

  void work() {
    try {
      while (const std::optional<std::uint64_t> number = take()) {
        Case pair = plan_->make(*number);
        std::optional<std::string> sentence = difference(pair, *x_, *y_);
        const std::lock_guard lock(mutex_);
        if (sentence && (!first_ || *number < first_->number))
          first_ = {*number, std::move(pair), *std::move(sentence)};
        ++done_;
        if (plan_->report) plan_->report(done_);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  StreamResult result() {
    if (error_) std::rethrow_exception(error_);
    return {first_ ? first_->number : next_, std::move(first_)};
  }

 private:
  std::optional<std::uint64_t> take() {
    const std::lock_guard lock(mutex_);
    const bool ended = plan_->count && next_ - plan_->from >= *plan_->count;
    if (ended || first_ || error_ || (plan_->stop && plan_->stop())) return std::nullopt;
    return next_++;
  }

  const StreamPlan* plan_;
  const Solver *x_, *y_;
  std::mutex mutex_;
  std::uint64_t next_, done_ = 0;
  std::optional<StreamDifference> first_;
  std::exception_ptr error_;
};

}  // namespace

std::string accepted_certificate(const Case& pair, const Depth& answer, Monitor* monitor) {
  std::string text = certificate_text(pair.a.points, pair.b.points, answer, pair.id, monitor);
  const fathom_check::Verdict verdict = acceptance(pair.id, text);
  const Distance* const apart = answer.distance();
  const bool same = apart ? verdict.signed_depth == surd_text({0, -apart->squared})
                          : verdict.depth_squared == exact_text(answer.squared());
  if (!same || verdict.status != name(answer.status()) || verdict.optima != answer.optima().size())
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", pair.id));
  return text;
}

std::string accepted_certificate(const std::string& id, const ShapeTruth& truth, Monitor* monitor) {
  const Bracket* const bracket = std::get_if<Bracket>(&truth.depth.core);
  if (bracket && bracket->around) {  // a certificate does not prove all that it states
    SignedDepthOptions wider;
    wider.cores.monitor = monitor;
    wider.coaxial = false;
    return accepted_certificate(id, truth_about(truth.a, truth.b, wider), monitor);
  }
  std::string text = certificate_text(truth.a, truth.b, truth.depth, id, ShapeFormat::richest, monitor);
  const fathom_check::Verdict verdict = acceptance(id, text);
  const Bounds* const bounds = truth.depth.bounds();
  const bool same = bounds ? verdict.at_least == exact_text(bounds->low) && verdict.at_most == exact_text(bounds->high)
                           : verdict.signed_depth == surd_text(*truth.depth.exact());
  const std::optional<Status> status = truth.depth.status();
  if (!same || verdict.status != name(status))
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", id));
  return text;
}

std::string accepted_certificate(const std::string& id, const UnionTruth& truth, Monitor* monitor) {
  const UnionDepth& depth = truth.depth;
  std::string text = certificate_text(truth.a, truth.b, depth, id, monitor);
  const fathom_check::Verdict verdict = acceptance(id, text);
  const bool same = depth.apart ? verdict.distance_squared == exact_text(depth.apart->distance.squared)
                                : verdict.depth_squared == exact_text(depth.squared());
  const std::size_t optima = depth.status == Status::penetrating ? depth.optima.size() : 0;
  if (!same || verdict.status != name(depth.status) || verdict.optima != optima)
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", id));
  return text;
}

namespace {

std::string accepted_in_plane(const Case& pair, Monitor* monitor) {
  Question question;
  question.options.monitor = monitor;
  const Answer answer = exact_answer(pair.a, pair.b, question);
  std::string text = certificate_text(pair.a, pair.b, answer, pair.id, monitor);
  const fathom_check::Verdict verdict = acceptance(pair.id, text);
  const Depth* const depth = std::get_if<Depth>(&answer.found);
  const bool same = !depth || depth->distance() || verdict.depth_squared == exact_text(depth->squared());
  if (!verdict.plane || !same || verdict.status != name(answer.status()))
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", pair.id));
  return text;
}

}  // namespace

std::string accepted_certificate(const Case& pair, Monitor* monitor) {
  if (pair.a.dimension == 2) return accepted_in_plane(pair, monitor);
  if (pair.a.pieces || pair.b.pieces) {
    UnionOptions options;
    options.monitor = monitor;
    return accepted_certificate(pair.id, truth_about(pieces_of(pair.a), pieces_of(pair.b), options), monitor);
  }
  if (pair.a.shape || pair.b.shape) {
    SignedDepthOptions options;
    options.cores.monitor = monitor;
    return accepted_certificate(pair.id, truth_about(files::shape_of(pair.a), files::shape_of(pair.b), options),
                                monitor);
  }
  Options options;
  options.monitor = monitor;
  return accepted_certificate(pair, penetration_depth(pair.a.points, pair.b.points, options), monitor);
}

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
  if (!files::has_union(pair)) return compared(pair, x, y, monitor, &Solver::depth, solve::disagreement);
  return compared(pair, x, y, monitor, &Solver::of_unions,
                  [](const UnionsFound& one, const UnionsFound& other) { return disagreement(one, other); });
}

KeptDifference keep_difference(const std::string& directory, const Case& pair, const std::string& sentence,
                               const Solver& x, const Solver& y, const std::function<bool()>& stop) {
  KeptDifference kept;
  write(kept, directory, pair, sentence);
  if (files::has_union(pair)) {
    drop_pieces(kept, directory, x, y, stop);
    return kept;
  }
  const Examine examine = [&](const Case& candidate) {
    Outcome outcome = outcome_for(candidate);
    Case in_space = candidate;
    if (candidate.a.dimension == 2) {
      answer::Prisms prisms = answer::prisms_of(candidate.a, candidate.b);
      in_space = {candidate.id, std::move(prisms.a), std::move(prisms.b), {}};
    }
    const std::optional<std::string> found = difference(in_space, x, y);
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

Case random_case(std::uint64_t seed, std::uint64_t number) {
  return random_of(families::families(), seed, number, least_random_size, most_random_size);
}

Case random_unions(std::uint64_t seed, std::uint64_t number) {
  return random_of(families::families(families::Kind::unions), seed, number, 1, most_random_pieces);
}

StreamResult compare_stream(const StreamPlan& plan, const Solver& x, const Solver& y) {
  Comparer comparer(plan, x, y);
  std::vector<std::thread> others;
  for (unsigned i = 1; i < plan.jobs; ++i) others.emplace_back([&comparer] { comparer.work(); });
  comparer.work();
  for (std::thread& other : others) other.join();
  return comparer.result();
}

}  // namespace fathom::harness
