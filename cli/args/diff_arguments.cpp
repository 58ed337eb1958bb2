// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/diff_arguments.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/args/help.hpp"
#include "cli/args/named_files.hpp"
#include "cli/args/parser_words.hpp"
#include "cli/args/words.hpp"
#include "cli/io/terminal.hpp"

namespace fathom::cli {
namespace {

/// The parser of the words, with the request that it fills in.
struct DiffParser {
  DiffRequest request;
  CLI::App app{"", "fathom certify diff"};

  DiffParser() {
    app.get_help_ptr()->description(help_meaning);
    app.add_option("reports", request.reports);
    app.add_flag("--json", request.json, "one JSON object, schema fathom/diff/1");
    names_file(app.add_option("--html", request.html, "write a page for a browser"), FileUse::written)->type_name("FILE");
  }
};

DiffArguments refusal(const std::string& sentence) { return {std::nullopt, sentence + "\nTry: fathom certify diff --help", bad_input}; }

}  // namespace

HelpPage diff_page_of_help() {
  DiffParser parser;
  return {diff_help, options_of(parser.app)};
}

DiffArguments parse_diff(const std::vector<std::string>& words) {
  DiffParser parser;
  if (const std::string fault = missing_value(words); !fault.empty()) return refusal(fault);
  try {
    parser.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, help_text(diff_page_of_help(), help_columns(STDOUT_FILENO)), fine};
  } catch (const CLI::ParseError& error) {
    return refusal(sentence(error, parser.app));
  }
  DiffRequest& request = parser.request;
  if (const std::string fault = empty_value(parser.app); !fault.empty()) return refusal(fault);
  if (request.reports.size() != 2)
    return refusal(fmt::format("certify diff expects two reports, the old and the new one, found {} argument{}", request.reports.size(),
                               request.reports.size() == 1 ? "" : "s"));
  if (const std::string fault = wrong_files(parser.app, false); !fault.empty()) return refusal(fault);
  if (request.html == "-") return refusal("--html writes a file, found - for standard output");
  request.command_line = "fathom certify diff " + shell_line(words);
  return {request, "", fine};
}

}  // namespace fathom::cli
