// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a case, and two ways to find its answer that share as little as possible.
// Output  where they differ; and if they do, a smaller case on which they still do.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"

namespace fathom::harness {

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

/// What users get: the automatic method and its certificate, which the independent checker must accept as a proof of that very answer.
/// Throws std::logic_error otherwise. Answers about unions too, in the same way.
Solver solver_with_proof();

/// Two ways do not agree about a case. It is the program's own fault.
struct Disagreement : std::logic_error {
  Disagreement(Case about, Solver other, const std::string& sentence)
      : std::logic_error(sentence), pair(std::move(about)), second(std::move(other)) {}
  Case pair;
  Solver second;  ///< that differs from the automatic method
};

/// Returns "automatic and exact differ: squared: 1/4 and 1/9", or who of them threw what; nullopt if the answers are equal in every field
/// that must not depend on the way. A case of unions needs ways that answer about them. Throws Interrupted and std::bad_alloc.
std::optional<std::string> difference(const Case& pair, const Solver& x, const Solver& y, Monitor* monitor = nullptr);

/// A difference, on disk.
struct KeptDifference {
  Case pair;             ///< the smallest so far
  std::string sentence;  ///< the difference there
  std::string path;      ///< of the case file
};

/// Makes a case on which the ways differ smaller as `shrink` does, and writes the smallest so far to `directory`/difference.case.json, from
/// the beginning and at each step. If the difference vanishes when the points are rounded to binary64, it keeps the case as it is. Unions
/// lose the pieces that the difference does not need.
/// `sentence` is the difference. `stop` ends the search early. Throws InputError if the file cannot be written.
KeptDifference keep_difference(const std::string& directory, const Case& pair, const std::string& sentence, const Solver& x,
                               const Solver& y, const std::function<bool()>& stop = {});

}  // namespace fathom::harness
