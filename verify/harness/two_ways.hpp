// SPDX-License-Identifier: GPL-3.0-or-later
// Checks answers in a second way: by a proof of the truth that the checker accepts, or by a second
// solver that shares as little as possible with the first; on one case or on a stream of cases; and
// reduces a case on which two solvers differ.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/judge.hpp"

namespace fathom::harness {

/// Returns the text of the certificate of an answer, which the independent checker has accepted as
/// a proof of that very answer: of its status, its depth or distance, and how many optima it has.
/// Throws std::logic_error if the checker refuses it or finds another answer proved,
/// fathom_check::Unreadable if the text passes a limit of checkers, and Interrupted.
std::string accepted_certificate(const Case& pair, const Depth& answer, Monitor* monitor = nullptr);
/// The same for shapes: of the signed depth, or of its bounds.
std::string accepted_certificate(const std::string& id, const ShapeTruth& truth, Monitor* monitor = nullptr);
/// The same for unions: of the status, the depth and how many optima it has, or the distance.
std::string accepted_certificate(const std::string& id, const UnionTruth& truth, Monitor* monitor = nullptr);
/// Solves the case anew, and returns an accepted certificate of the truth.
std::string accepted_certificate(const Case& pair, Monitor* monitor);

// ---- two ways ----

/// The parts of an answer about unions that must not depend on the solver.
struct UnionsFound {
  Status status;
  mpq_class squared;                ///< depth^2, or distance^2 of bodies that are apart
  std::vector<Point> translations;  ///< all shortest ones of unions that penetrate, in lexicographic order
};

/// A function that answers about a case. An exception that it throws counts as an answer.
struct Solver {
  std::string name;
  std::function<Depth(const Case&, Monitor*)> depth;
  std::function<UnionsFound(const Case&, Monitor*)> of_unions = {};  ///< for cases of unions; may be empty
};

/// Returns a solver that uses the library's method.
Solver solver_by(Method method);

/// Returns a solver like the command line: the automatic method with its certificate, which the
/// independent checker must accept as a proof of that very answer; else it throws std::logic_error.
/// Answers about unions too.
Solver solver_with_proof();

/// Two solvers disagree about a case, which is a fault of fathom.
struct Disagreement : std::logic_error {
  Disagreement(Case about, Solver other, const std::string& sentence)
      : std::logic_error(sentence), pair(std::move(about)), second(std::move(other)) {}
  Case pair;
  Solver second;  ///< differs from the automatic method
};

/// Returns "automatic and exact differ: squared: 1/4 and 1/9", or the exception of a solver that
/// threw one; nullopt if the answers are equal in every field that must not depend on the solver. A
/// case of unions needs solvers for unions. Throws Interrupted and std::bad_alloc.
std::optional<std::string> difference(const Case& pair, const Solver& x, const Solver& y, Monitor* monitor = nullptr);

/// A difference that was written to disk.
struct KeptDifference {
  Case pair;             ///< the smallest so far
  std::string sentence;  ///< the difference there
  std::string path;      ///< of the case file
};

/// Reduces a case on which the solvers differ as `shrink` does, and writes the smallest so far to
/// `directory`/difference.case.json, at the beginning and at each step. If the difference vanishes
/// when the points are rounded to binary64, it keeps the case. Drops pieces of unions that the
/// difference does not need. `sentence` describes the difference. `stop` ends the search early.
/// Throws InputError if the file cannot be written.
KeptDifference keep_difference(const std::string& directory, const Case& pair, const std::string& sentence,
                               const Solver& x, const Solver& y, const std::function<bool()>& stop = {});

// ---- an endless stream of cases of all families, each given by the stream's seed and its number
// alone ----

/// Returns case `number` of the stream: families take turns, size and seed are random. About two in
/// three cases have their points rounded, to binary64 or to binary32, unless a coordinate
/// overflows; their ids end in ".b64" or ".b32". The same on every machine.
Case random_case(std::uint64_t seed, std::uint64_t number);

/// Returns the same for unions of convex pieces, with sizes from 1 to most_random_pieces.
Case random_unions(std::uint64_t seed, std::uint64_t number);

// ---- two ways on a stream ----

struct StreamPlan {
  std::function<Case(std::uint64_t)> make;  ///< may be called by all threads
  std::uint64_t from = 0;                   ///< the first number
  std::optional<std::uint64_t> count;       ///< the number of cases; unlimited unless given
  unsigned jobs = 1;                        ///< threads, including the caller's
  std::function<bool()> stop;               ///< called before each case, by one thread at a time: true ends the stream
  std::function<void(std::uint64_t done)> report;  ///< called after each case, from one thread at a time; may be empty
};

struct StreamDifference {
  std::uint64_t number;
  Case pair;
  std::string sentence;
};

struct StreamResult {
  std::uint64_t end = 0;                  ///< the solvers agree on the cases from `from` to before `end`
  std::optional<StreamDifference> first;  ///< on case `end` they differ
};

/// Compares case after case until the stream ends, is stopped, or a difference is found. The result
/// does not depend on the number of threads, except for the end of a stopped stream. Rethrows
/// exceptions of solvers that do not count as answers, such as std::bad_alloc.
StreamResult compare_stream(const StreamPlan& plan, const Solver& x, const Solver& y);

}  // namespace fathom::harness
