// SPDX-License-Identifier: GPL-3.0-or-later
// fathom certify diff OLD NEW

#include "verify/harness/report/diff.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/terminal.hpp"

namespace fathom::cli {
namespace {

constexpr ExitCode newly_failing = static_cast<ExitCode>(1);
constexpr std::size_t indent = 4;

struct DiffRequest {
  std::vector<std::string> reports;  ///< the old one and the new one
  bool json = false;
  std::string html;          ///< a path; empty: not wanted
  std::string command_line;  ///< quoted for a shell
};

ExitCode compare(const DiffRequest& request) {
  const harness::ReportFile before = harness::read_report(request.reports[0]),
                            after = harness::read_report(request.reports[1]);
  const harness::ReportDiff diff = harness::diff(before, after);
  if (!request.html.empty())
    CertificateFile(request.html, "page")
        .write(harness::diff_page(before, after, diff, FATHOM_VERSION, request.command_line));
  if (request.json) print(harness::diff_json(before, after, diff));
  else
    for (const std::string& line : harness::diff_text(before, after, diff)) print(fitted(line, indent));
  return diff.newly_failing.empty() ? fine : newly_failing;
}

}  // namespace

ExitCode run_diff(const Given& given) {
  return compare({given.inputs(), given.flag("--json"), given.text("--html"), given.command_line});
}

}  // namespace fathom::cli
