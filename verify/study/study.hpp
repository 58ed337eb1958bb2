// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fathom/study.hpp"
#include "kernels/context.hpp"

namespace fathom::studies {

/// The public function with a context, which counts the predicates of the search for coincidences.
Study study(kernels::Context& context, std::span<const Point> a, std::span<const Point> b, const StudyOptions& options = {});

}  // namespace fathom::studies
