// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages of two bodies and of two unions have in common: what stands around their sections.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fathom::page {

/// The parts of a page; all markup but `data`.
struct PageParts {
  std::string version;                                                  ///< of fathom; text
  std::string command;                                                  ///< whose numbers the page shows; text
  std::string answer, subtitle;                                         ///< the heading and what is below it
  std::vector<std::string> notes;                                       ///< warnings; texts
  std::vector<std::pair<std::string_view, std::string_view>> sections;  ///< ids and names
  std::string main, left_out;                                           ///< the sections, and what is left out
  std::vector<std::pair<std::string_view, std::string>> data;           ///< blocks of JSON by their ids
};

/// The page, with its style, its script and its policy.
std::string assembled(const PageParts& parts);

/// A still picture with a caption, which is markup; empty if there is no picture.
std::string figure(const std::string& svg, std::string_view caption);

/// Sentences as a section of its own; empty if there are none.
std::string left_out_section(const std::vector<std::string>& sentences);

}  // namespace fathom::page
