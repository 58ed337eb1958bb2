// SPDX-License-Identifier: GPL-3.0-or-later
// Other questions about two bodies; files of cases, and families.
#pragma once

#include <pybind11/pybind11.h>

namespace fathom::python {

/// ray, metric, approx, study, judge.
void bind_questions(pybind11::module_& module);

/// Cases, ZstdLines, parse_case; families.
void bind_files(pybind11::module_& module);

}  // namespace fathom::python
