// SPDX-License-Identifier: GPL-3.0-or-later
// The words of `fathom certify diff --help`.
#pragma once

#include <string_view>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

inline constexpr Example diff_examples[] = {
    {"fathom certify --replay replies.jsonl --report after.jsonl cases.jsonl", "a report of a second version; the first is verdicts.jsonl"},
    {"fathom certify diff verdicts.jsonl after.jsonl", "which cases changed their verdict, and whose error changed most"},
    {"fathom certify diff --html diff.html verdicts.jsonl after.jsonl", "and the same as a page"},
    {"fathom certify diff --json verdicts.jsonl after.jsonl", "as one JSON object"},
};

inline constexpr ExitMeaning diff_exits[] = {
    {0, "no case that did not fail before fails now"},
    {1, "some do"},
    {2, "usage, or a file that is no report"},
    {3, "internal error, out of memory, or output that cannot be written"},
    {130, "interrupted"},
};

inline constexpr std::string_view diff_notes[] = {
    "Reports are what certify --report writes, of two versions of a subject, of one with other settings, or of two subjects. Cases are "
    "told "
    "apart by their ids. Errors are in parts of the largest coordinate of a pair.",
};

inline constexpr CommandHelp diff_help = {
    "certify diff", "What changed between two reports.", "fathom certify diff [OPTIONS] OLD NEW", diff_examples, diff_exits, diff_notes};

}  // namespace fathom::cli
