// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answer to a case, for bodies of any kinds, in the requested form: as text, and as a
// picture.
//                                                                            [docs/command_line.md]
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/output/text_rows.hpp"
#include "fathom/files.hpp"
#include "reference/output/answer_json.hpp"
#include "view/picture/scene.hpp"

namespace fathom::cli {

using output::AboutBodies;
using output::AnsweredCase;
using text::Json;

/// Returns several lines, without the last newline.
std::string answer_block(const AnsweredCase& answered, const AnswerForm& form);

/// Returns one line, which begins with the id, without its newline.
std::string answer_line(const AnsweredCase& answered, const AnswerForm& form);

/// Returns the scene of two bodies and their answer, which must be complete; with their patches, if
/// requested.
picture::PairScene answer_scene(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form);

/// Returns an SVG file of the case and its answer, which must be complete, with the answer's
/// numbers as text below.
std::string answer_picture(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form);

}  // namespace fathom::cli
