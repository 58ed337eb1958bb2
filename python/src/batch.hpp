// SPDX-License-Identifier: GPL-3.0-or-later
// Many pairs on several threads.
#pragma once

#include <utility>
#include <vector>

#include "python/src/answer.hpp"

namespace fathom::python {

/// Answers all of them with so many threads. What goes wrong first, by the order of the pairs, is thrown. To be called without Python's
/// lock.
std::vector<PairAnswer> answer_all(std::vector<std::pair<Body, Body>> pairs, const Question& question, unsigned threads, Monitor& monitor);

}  // namespace fathom::python
