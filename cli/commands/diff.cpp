// SPDX-License-Identifier: GPL-3.0-or-later
// fathom certify diff OLD NEW

#include "verify/harness/report/diff.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "cli/args/given.hpp"
#include "cli/args/help_page.hpp"
#include "cli/args/words.hpp"
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

ExitCode refused(const std::string& sentence) {
  return failed(sentence + "\nTry: fathom certify diff --help", bad_input);
}

}  // namespace

ExitCode run_diff(const std::vector<std::string>& words) {
  if (const std::string fault = missing_value(words); !fault.empty()) return refused(fault);
  const Given given = read_words("certify diff", common_options(), words);
  if (given.kind == Given::Kind::help) {
    print(help_text(page_of(given.command, common_options()), help_columns(STDOUT_FILENO)));
    return fine;
  }
  if (given.kind == Given::Kind::refused) return refused(given.fault);
  if (const std::string fault = empty_value(given); !fault.empty()) return refused(fault);
  const DiffRequest request{given.inputs(), given.flag("--json"), given.text("--html"),
                            "fathom certify diff " + shell_line(words)};
  if (request.reports.size() != 2)
    return refused(fmt::format("certify diff expects two reports, the old and the new one, found {} argument{}",
                               request.reports.size(), request.reports.size() == 1 ? "" : "s"));
  if (const std::string fault = wrong_files(given, false); !fault.empty()) return refused(fault);
  if (request.html == "-") return refused("--html writes a file, found - for standard output");
  return compare(request);
}

}  // namespace fathom::cli
