// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/arguments.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>
#include <unistd.h>

#include "cli/args/along_arguments.hpp"
#include "cli/args/approx_arguments.hpp"
#include "cli/args/cases_arguments.hpp"
#include "cli/args/certify_arguments.hpp"
#include "cli/args/help.hpp"
#include "cli/args/named_files.hpp"
#include "cli/args/parser.hpp"
#include "cli/args/parser_words.hpp"
#include "cli/args/pieces_arguments.hpp"
#include "cli/args/sweep_arguments.hpp"
#include "cli/args/words.hpp"
#include "cli/io/terminal.hpp"
#include "kernels/messages.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/files/file_io.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::cli {

extern const char* const built_commit;  ///< "" if the sources are at none: CMake writes it into a file of its own

namespace {

/// Returns whether the name is that of a mesh. Other names may be streams of cases.
bool is_mesh_name(const std::string& path) {
  constexpr std::string_view meshes[] = {"off", "obj", "ply", "stl", "xyz", "pts"};
  return std::find(std::begin(meshes), std::end(meshes), files::extension(path)) != std::end(meshes);
}

/// Returns whether the word names bodies or cases.
bool is_input(const std::string& word) {
  const std::string kind = files::extension(word);
  std::error_code fault;
  return word == "-" || is_mesh_name(word) || kind == "jsonl" || kind == "ndjson" || kind == "json" || files::is_shape_text(word) ||
         std::filesystem::is_regular_file(word, fault);
}

/// Returns the line that is probably meant if there are inputs and no command, as "; did you mean 'fathom depth a.obj b.obj'?", or "".
std::string line_with_command(const std::vector<std::string>& words) {
  std::vector<std::string> inputs;
  std::copy_if(words.begin(), words.end(), std::back_inserter(inputs), is_input);
  if (inputs.empty()) return "";
  const bool one_body = inputs.size() == 1 && (is_mesh_name(inputs[0]) || files::is_shape_text(inputs[0]));
  return fmt::format("; did you mean: fathom {} {}", one_body ? "width" : "depth", shell_line(words));
}

/// Returns a sentence if the words ask for what CLI11 would call unknown, or "".
std::string wrong_words(const std::vector<std::string>& words) {
  const std::string& command = words[0];
  const std::vector<std::string> names(commands.begin(), commands.end());
  const bool known = command.starts_with('-') || std::find(names.begin(), names.end(), command) != names.end();
  if (known) return missing_value(words);
  if (const std::string line = is_input(command) ? line_with_command(words) : ""; !line.empty())
    return fmt::format("expected a command, found the input {}{}", kernels::shown(command), line);
  return fmt::format("unknown command {} (expected {}){}", kernels::shown(command), fmt::join(commands, ", "),
                     did_you_mean(command, names));
}

Arguments refusal(const std::string& sentence, const std::string& command = "") {
  return {std::nullopt, fmt::format("{}\nTry: fathom {}--help", sentence, command.empty() ? "" : command + " "), bad_input};
}

Arguments no_command() {
  return refusal(fmt::format("expected a command: {}\nFor example: {}", fmt::join(commands, ", "), general_examples[0].line));
}

std::string version_text() {
  const std::string commit = *built_commit ? fmt::format("commit {}\n", built_commit) : "";
  return fmt::format("fathom {}\n{}golden data {}\nlicence GPL-3.0-or-later", FATHOM_VERSION, commit, golden::data_version);
}

/// The name as the user typed it.
std::string name(Command command) { return std::string(commands[static_cast<std::size_t>(command)]); }

/// Returns what is wrong with the number of inputs, or "".
std::string wrong_inputs(Request& request, const Texts& texts) {
  if (request.command == Command::cases) return texts.wrong_cases;
  if (!request.sweep.family.empty()) return "";
  if (request.command == Command::certify) return wrong_certify(request.certify, request.inputs);
  const std::vector<std::string>& inputs = request.inputs;
  const std::string found = fmt::format("found {} argument{}", inputs.size(), inputs.size() == 1 ? "" : "s");
  if (request.command == Command::width)
    return inputs.size() == 1 ? "" : "width expects one mesh, or one stream of cases (a .jsonl file, or - for standard input), " + found;
  const std::string expected =
      name(request.command) + " expects two meshes, or one stream of cases (a JSON Lines file, or - for standard input), ";
  if (inputs.empty()) return expected + found;
  if (inputs.size() == 1 && is_mesh_name(inputs[0])) return expected + "found the single mesh " + kernels::shown(inputs[0]);
  if (inputs.size() == 1 && files::is_shape_text(inputs[0])) return expected + "found the single shape " + kernels::shown(inputs[0]);
  if (inputs.size() == 2 && (inputs[0] == "-" || inputs[1] == "-")) return expected + "found - beside another input";
  return "";
}

/// Returns what is wrong with a request for a page, or "".
std::string wrong_page(const Request& request) {
  if (request.command != Command::explain) return "";
  if (request.page.empty()) return "explain writes a page: expected -o FILE, with the name of an HTML file";
  if (request.page == "-") return "-o writes a file, found - for standard output";
  return "";
}

/// Returns what does not go together in a request for a curve or a chart, or "".
std::string wrong_picture(const CLI::App& asked, Request& request) {
  if (request.svg == "-") return "--svg writes a file, found - for standard output";
  if (request.pieces) return wrong_pieces(asked, request);
  if (request.command == Command::depth) return wrong_along(asked, request);
  return request.command == Command::study ? wrong_sweep(asked, request) : "";
}

/// The request, unless its parts contradict each other.
Arguments completed(Request request, const Texts& texts) {
  const std::string command = name(request.command);
  if (const std::string fault = wrong_inputs(request, texts); !fault.empty()) return refusal(fault, command);
  if (!texts.wrong_picture.empty()) return refusal(texts.wrong_picture, command);
  if (!texts.wrong_files.empty()) return refusal(texts.wrong_files, command);
  if (request.case_id && request.inputs.size() == 2) return refusal("--case chooses a case of a stream, found two bodies", command);
  if (!texts.closest_lines.empty() && texts.method != "auto" && texts.method != "exact")
    return refusal("--closest-lines chooses the engine of --method exact, and cannot be combined with --method " + texts.method, command);
  if (request.embed_certificate && !request.json)
    return refusal("--embed-certificate adds a field to JSON results, and needs --json", command);
  if (request.certificate == "-")
    return refusal("--certificate writes files; --json --embed-certificate writes to standard output", command);
  if (request.html == "-") return refusal("--html writes a file; standard output has the answers", command);
  const bool asks_exact =
      texts.method != "auto" || !texts.closest_lines.empty() || !request.certificate.empty() || request.embed_certificate;
  if (const std::string fault = wrong_page(request); !fault.empty()) return refusal(fault, command);
  if (const std::string fault = wrong_approximation(request, asks_exact); !fault.empty()) return refusal(fault, command);
  if (request.exact && request.json) return refusal("--exact is about text: JSON has every number exactly, and rounded beside it", command);
  if (request.csv && request.json) return refusal("--csv and --json are two forms of one answer: choose one", command);
  if (request.csv && request.all) return refusal("--all lists coincidences, and cannot be combined with --csv, which counts them", command);
  request.decimals = texts.exact_decimals ? Decimals::exact : Decimals::binary64;
  if (texts.method == "exact") request.method = Method::exact;
  if (texts.method == "naive") request.method = Method::naive;
  request.shallow = texts.method == "shallow";
  for (std::size_t i = 0; i < engine_names.size(); ++i)
    if (texts.closest_lines == engine_names[i]) request.closest_lines = static_cast<ClosestLines>(i);
  return {std::move(request), "", fine};
}

/// The page of a command, or of fathom itself.
HelpPage page_of(Parser& parser, CLI::App* command) {
  if (command == nullptr) return {general_help, options_of(parser.app), {std::begin(command_table), std::end(command_table)}};
  const auto help = std::ranges::find(command_table, command->get_name(), &CommandHelp::name);
  HelpPage page{*help, options_of(*command)};
  if (help->name == "certify") page.commands = {diff_help}, page.takes_input = true;
  return page;
}

}  // namespace

std::vector<HelpPage> help_pages() {
  Parser parser;
  std::vector<HelpPage> pages = {page_of(parser, nullptr)};
  for (CLI::App* const command : parser.commands) pages.push_back(page_of(parser, command));
  return pages;
}

Arguments parse_arguments(int argc, const char* const* argv) {
  Parser parser;
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty()) return no_command();
  if (const std::string fault = wrong_words(words); !fault.empty()) return refusal(fault);
  try {
    parser.app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, help_text(page_of(parser, parser.asked()), help_columns(STDOUT_FILENO)), fine};
  } catch (const CLI::CallForVersion&) {
    return {std::nullopt, version_text(), fine};
  } catch (const CLI::ParseError& error) {
    CLI::App* const asked = parser.asked();
    return refusal(sentence(error, parser.app, asked) + (asked ? "" : line_with_command(words)), asked ? asked->get_name() : "");
  }
  CLI::App* const asked = parser.asked();
  if (asked == nullptr) return no_command();
  Request& request = parser.request;
  request.command = static_cast<Command>(std::ranges::find(parser.commands, asked) - parser.commands.begin());
  if (request.command == Command::certify) request.certify.command_line = command_line(argc, argv);
  if (!request.html.empty()) request.command_line = command_line(argc, argv);
  if (const std::string fault = empty_value(*asked); !fault.empty()) return refusal(fault, name(request.command));
  if (request.command == Command::cases) parser.texts.wrong_cases = wrong_cases(*asked, request.cases, request.inputs);
  parser.texts.wrong_picture = wrong_picture(*asked, request);
  const bool stream = request.inputs.size() == 1 && !request.case_id;  // of width both are possible: it has one output
  parser.texts.wrong_files = wrong_files(*asked, stream);
  return completed(request, parser.texts);
}

}  // namespace fathom::cli
