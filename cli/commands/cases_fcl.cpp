// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/cases_fcl.hpp"

#include <fmt/format.h>

#include <iostream>
#include <iterator>

#include "cli/io/output.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/fcl_text.hpp"
#include "reference/files/file_io.hpp"

namespace fathom::cli {

ExitCode print_fcl_cases(const std::string& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "<stdin>" : path;
  const std::string text = standard ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : files::read_file(path);
  for (const files::FclFailure& failure : files::read_fcl_text(text, name)) {
    files::CaseText line{fmt::format("{}:{}", name, failure.line),
                         files::body_json(failure.first.body, failure.first.pose),
                         files::body_json(failure.second.body, failure.second.pose),
                         {{"fcl", name}},
                         failure.message,
                         true};
    print(files::case_json(line));
  }
  return fine;
}

}  // namespace fathom::cli
