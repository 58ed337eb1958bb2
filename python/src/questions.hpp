// SPDX-License-Identifier: GPL-3.0-or-later
// Other questions about two bodies, and files of cases.
#pragma once

#include <pybind11/pybind11.h>

namespace fathom::python {

/// ray, metric, approx, study, judge, Cases, ZstdLines.
void bind_questions(pybind11::module_& module);

}  // namespace fathom::python
