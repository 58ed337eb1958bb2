// SPDX-License-Identifier: GPL-3.0-or-later
// A case of a stream on its way from its text to its answer, and between processes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/io/case_stream.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "fathom/files.hpp"
#include "reference/files/cases.hpp"

namespace fathom::cli {

/// What there is to say of a case beside its answer. The first of a kind is said, later ones are counted.
enum class NoteKind { field, pose, sizes, dents };
inline constexpr std::array<std::string_view, 4> later_notes = {"fields that look misspelt", "poses that are no rotations",
                                                                "bodies of very different sizes", "meshes that are not convex"};
struct StreamNote {
  NoteKind kind;
  std::string text;
};

/// A case on its way.
struct Passage {
  std::size_t number = 0;  ///< of cases before it
  files::UnreadCase text;
  std::optional<Working> working;
  bool answered = false;

  std::string id;
  CaseReply reply;
  std::optional<InputError> fault;  ///< in place of the reply
  ExitCode code = fine;
  std::optional<std::string> hull_note;  ///< if none was said when it was answered
  std::vector<StreamNote> notes;
  bool perhaps_inner = false;
};

/// Appends what was found about the case to texts that are packed.
void pack_answer(std::string& all, const Passage& passage);

/// Reads that back.
void take_answer(const std::string& text, Passage& passage);

}  // namespace fathom::cli
