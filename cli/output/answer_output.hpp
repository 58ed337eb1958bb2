// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answer to a case, of bodies of any kinds, as it is asked for: as text for people, and
// as a picture.
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

/// Several lines, without the last newline.
std::string answer_block(const AnsweredCase& answered, const AnswerForm& form);

/// One line, which begins with the id, without its newline.
std::string answer_line(const AnsweredCase& answered, const AnswerForm& form);

/// What a picture of two bodies and their answer, which is complete, shows: their patches too, if
/// they are asked for.
picture::PairScene answer_scene(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form);

/// An SVG file of the case and its answer, which is complete, with the numbers of the text below.
std::string answer_picture(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form);

}  // namespace fathom::cli
