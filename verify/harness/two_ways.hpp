// SPDX-License-Identifier: GPL-3.0-or-later
// Answers found again: by a proof of the truth that the checker accepts, or by a second way that
// shares as little as possible with the first; on one case or on a stream of them, and made smaller
// where two ways differ.
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
/// The truth about a case, solved anew, and accepted.
std::string accepted_certificate(const Case& pair, Monitor* monitor);

// ---- two ways ----

/// What two ways must find alike about unions.
struct UnionsFound {
  Status status;
  mpq_class squared;                ///< depth^2, or distance^2 of bodies that are apart
  std::vector<Point> translations;  ///< of unions that penetrate all shortest, in lexicographic order
};

/// A way to find the answer about a case. It may throw, which counts as an answer of its own.
struct Solver {
  std::string name;
  std::function<Depth(const Case&, Monitor*)> depth;
  std::function<UnionsFound(const Case&, Monitor*)> of_unions = {};  ///< for cases of unions, if there are any
};

/// The library's method.
Solver solver_by(Method method);

/// What users get: the automatic method and its certificate, which the independent checker must
/// accept as a proof of that very answer. Throws std::logic_error otherwise. Answers about unions
/// too, in the same way.
Solver solver_with_proof();

/// Two ways do not agree about a case. It is the program's own fault.
struct Disagreement : std::logic_error {
  Disagreement(Case about, Solver other, const std::string& sentence)
      : std::logic_error(sentence), pair(std::move(about)), second(std::move(other)) {}
  Case pair;
  Solver second;  ///< that differs from the automatic method
};

/// Returns "automatic and exact differ: squared: 1/4 and 1/9", or who of them threw what; nullopt
/// if the answers are equal in every field that must not depend on the way. A case of unions needs
/// ways that answer about them. Throws Interrupted and std::bad_alloc.
std::optional<std::string> difference(const Case& pair, const Solver& x, const Solver& y, Monitor* monitor = nullptr);

/// A difference, on disk.
struct KeptDifference {
  Case pair;             ///< the smallest so far
  std::string sentence;  ///< the difference there
  std::string path;      ///< of the case file
};

/// Makes a case on which the ways differ smaller as `shrink` does, and writes the smallest so far
/// to `directory`/difference.case.json, from the beginning and at each step. If the difference
/// vanishes when the points are rounded to binary64, it keeps the case as it is. Unions lose the
/// pieces that the difference does not need. `sentence` is the difference. `stop` ends the search
/// early. Throws InputError if the file cannot be written.
KeptDifference keep_difference(const std::string& directory, const Case& pair, const std::string& sentence,
                               const Solver& x, const Solver& y, const std::function<bool()>& stop = {});

// ---- an endless stream of cases of all families, each given by the stream's seed and its number
// alone ----

/// Returns case `number` of the stream: the families take turns, size and seed are random. About
/// two in three have their points rounded, to binary64 or to binary32, unless a coordinate
/// overflows that; ".b64" or ".b32" behind the id says so. The same on every machine.
Case random_case(std::uint64_t seed, std::uint64_t number);

/// The same of unions of convex pieces: sizes are from 1 to most_random_pieces.
Case random_unions(std::uint64_t seed, std::uint64_t number);

// ---- two ways on a stream ----

struct StreamPlan {
  std::function<Case(std::uint64_t)> make;  ///< called from all threads
  std::uint64_t from = 0;                   ///< the first number
  std::optional<std::uint64_t> count;       ///< of cases; without end unless given
  unsigned jobs = 1;                        ///< threads; the caller's is one of them
  std::function<bool()> stop;               ///< asked before each case: true ends the stream; from one thread at a time
  std::function<void(std::uint64_t done)> report;  ///< called after each case, from one thread at a time; may be empty
};

struct StreamDifference {
  std::uint64_t number;
  Case pair;
  std::string sentence;
};

struct StreamResult {
  std::uint64_t end = 0;                  ///< on the cases from `from` to before `end` the ways agree
  std::optional<StreamDifference> first;  ///< on case `end` they differ
};

/// Compares case after case until the stream ends, is stopped, or a difference is found. The result
/// does not depend on the number of threads, except on how far a stopped stream came. Throws what
/// the ways throw that is no answer, as std::bad_alloc.
StreamResult compare_stream(const StreamPlan& plan, const Solver& x, const Solver& y);

}  // namespace fathom::harness
