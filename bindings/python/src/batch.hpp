// SPDX-License-Identifier: GPL-3.0-or-later
// Many pairs on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <variant>
#include <vector>

#include "bindings/python/src/answers.hpp"

namespace fathom::python {

/// The answer about a pair, or what was wrong with it.
using MaybeAnswer = std::variant<std::exception_ptr, PairAnswer>;

/// Whether all pairs are answered, wrong ones by what was thrown; or the first that is wrong, by its place, ends the work and throws.
enum class Faults { returned, thrown };

/// Bodies to be asked about, or what was wrong with them.
using MaybeAsked = std::variant<std::exception_ptr, Asked>;

/// Answers all of them with so many threads, or with as many as the system gives. `done` counts them meanwhile. To be called without
/// Python's lock. Throws Interrupted if the monitor stopped the work, and only then.
std::vector<MaybeAnswer> answer_all(std::vector<MaybeAsked> pairs, const Question& question, unsigned threads, Faults faults,
                                    std::atomic<std::size_t>& done, Monitor& monitor);

/// depths.
void bind_batches(py::module_& module);

}  // namespace fathom::python
