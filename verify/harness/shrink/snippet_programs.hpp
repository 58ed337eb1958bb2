// SPDX-License-Identifier: GPL-3.0-or-later
// The program around the points, one for each library. Not a door: that is snippet.hpp.
#pragma once

#include <optional>
#include <string>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// Defines `void answer(const char* label, const Body& a, const Body& b)`, which prints what the library says.
struct Program {
  std::string command;           ///< how to compile the file "case.cpp"
  std::string includes;          ///< lines
  std::string body;              ///< lines, after the definition of Body
  std::string opening, closing;  ///< of main
};

/// The calls of this subject's adapter, with the settings of its hello. Returns nullopt for a library without a program here.
std::optional<Program> program_for(const SubjectInfo& info);

}  // namespace fathom::harness
