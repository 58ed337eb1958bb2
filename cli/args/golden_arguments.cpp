// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/golden_arguments.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tuple>
#include <unistd.h>

#include "cli/args/export_arguments.hpp"
#include "cli/args/help.hpp"
#include "cli/args/named_files.hpp"
#include "cli/args/parser_words.hpp"
#include "cli/args/second_method.hpp"
#include "cli/args/threads.hpp"
#include "cli/args/words.hpp"
#include "cli/io/terminal.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::uint64_t most_parts = 1'000'000;

/// An integer in plain digits.
std::optional<std::uint64_t> integer(std::string_view text, std::uint64_t low, std::uint64_t high) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc() && end == text.data() + text.size() && value >= low && value <= high;
  return good ? std::optional(value) : std::nullopt;
}

CLI::Validator integer_from(std::uint64_t low, std::uint64_t high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    const std::string highest = high == UINT64_MAX ? "2^64 - 1" : std::to_string(high);
    return integer(text, low, high) ? "" : fmt::format("expected an integer from {} to {}, found {}", low, highest, kernels::shown(text));
  };
  return CLI::Validator(check, "", "");
}

std::string check_level(const std::string& text) {
  return golden::find_level(text) ? "" : fmt::format("expected L0, L1, L2, L3, P0, P1 or U0, found {}", kernels::shown(text));
}

/// "i/n".
std::optional<std::pair<std::size_t, std::size_t>> part_of(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto parts = integer(text.substr(std::min(slash + 1, text.size())), 1, most_parts);
  const auto part = parts ? integer(text.substr(0, slash), 1, *parts) : std::nullopt;
  return part ? std::optional(std::pair<std::size_t, std::size_t>(*part, *parts)) : std::nullopt;
}

std::string check_part(const std::string& text) {
  return part_of(text) ? "" : fmt::format("expected i/n with 1 <= i <= n, found {}", kernels::shown(text));
}

void add_jobs(CLI::App& app, GoldenRequest& request) {
  app.add_option_function<std::string>(
         "--jobs", [&request](const std::string& text) { request.jobs = *threads_of(text); },
         "threads; as many as there are cores unless given")
      ->check(check_threads)
      ->type_name("N");
}

void add_generate_options(CLI::App& app, GoldenRequest& request) {
  app.add_option_function<std::string>(
         "--level", [&request](const std::string& text) { request.level = *golden::find_level(text); },
         "L0, L1, L2 or L3, of polytopes: hundreds of records, about ten thousand,\nover a hundred thousand, about ten million; P0 or P1, "
         "of shapes: about a\nthousand, about ten thousand; each holds the shards of those below it;\nU0, of unions of convex pieces: "
         "hundreds")
      ->check(one_of({"L0", "L1", "L2", "L3", "P0", "P1", "U0"}, check_level))
      ->type_name("LEVEL")
      ->required();
  app.add_option_function<std::string>(
         "--seed", [&request](const std::string& text) { request.seed = *integer(text, 0, UINT64_MAX); }, "of the families; 1 unless given")
      ->check(integer_from(0, UINT64_MAX))
      ->type_name("N");
  names_file(app.add_option_function<std::string>(
                 "--out", [&request](const std::string& text) { request.folder = text; }, "the folder, made if need be"),
             FileUse::folder)
      ->type_name("DIR")
      ->required();
  app.add_option_function<std::string>(
         "--shard",
         [&request](const std::string& text) {
           std::tie(request.part, request.parts) = *part_of(text);
           request.is_part = true;
         },
         "make every n-th shard only, from the i-th on, and leave it to a last run\nwithout --shard to complete the release")
      ->check(check_part)
      ->type_name("I/N");
  add_jobs(app, request);
}

void add_folder(CLI::App& app, GoldenRequest& request) {
  app.add_option_function<std::string>("folder", [&request](const std::string& path) { request.folder = path; });
}

void add_verify_options(CLI::App& app, GoldenRequest& request) {
  add_folder(app, request);
  add_second_method(app, request.methods,
                    "compute every record again by exact (AGHRS's pipeline) or naive (the hull\nof all vertex differences) too, and "
                    "compare every field; may be repeated");
  app.add_flag("--state", request.state, "once all agree, write agreement.json into the folder, which says so");
  add_jobs(app, request);
}

/// The words about `fathom golden` or, if it is one of the tasks, about that.
const CommandHelp& help_of(const std::string& task) {
  const std::string name = task == "fathom golden" ? "golden" : "golden " + task;
  return *std::ranges::find(golden_table, name, &CommandHelp::name);
}

/// The parser of the words, with the request that it fills in.
struct GoldenParser {
  GoldenRequest request;
  CLI::App app{"", "fathom golden"};
  CLI::App *generate, *verify, *exporting;

  GoldenParser() {
    app.get_help_ptr()->description(help_meaning);
    app.require_subcommand(0, 1);
    generate = add_task("generate");
    verify = add_task("verify");
    exporting = add_task("export");
    add_generate_options(*generate, request);
    add_verify_options(*verify, request);
    add_folder(*exporting, request);
    add_export_options(*exporting, request.exported, request.certificates);
  }

  CLI::App* add_task(const std::string& name) {
    CLI::App* const task = app.add_subcommand(name, "");
    task->get_help_ptr()->description(help_meaning);
    return task;
  }
  [[nodiscard]] CLI::App* asked() const {
    const std::vector<CLI::App*> parsed = app.get_subcommands();
    return parsed.empty() ? nullptr : parsed.front();
  }
  HelpPage page_of(CLI::App& task) {
    std::vector<CommandHelp> tasks;
    if (&task == &app) tasks.assign(std::begin(golden_table) + 1, std::end(golden_table));
    return {help_of(task.get_name()), options_of(task), tasks};
  }
};

GoldenArguments refusal(const std::string& sentence, const std::string& command = "") {
  return {std::nullopt, fmt::format("{}\nTry: fathom golden {}--help", sentence, command.empty() ? "" : command + " "), bad_input};
}

}  // namespace

std::vector<HelpPage> golden_pages() {
  GoldenParser parser;
  std::vector<HelpPage> pages = {parser.page_of(parser.app)};
  for (CLI::App* const task : parser.app.get_subcommands({})) pages.push_back(parser.page_of(*task));
  return pages;
}

GoldenArguments parse_golden(const std::vector<std::string>& words) {
  GoldenParser parser;
  GoldenRequest& request = parser.request;
  std::vector<std::string> tasks;
  for (const CLI::App* const task : parser.app.get_subcommands({})) tasks.push_back(task->get_name());
  if (!words.empty() && std::ranges::find(tasks, words[0]) == tasks.end() && !words[0].starts_with('-'))
    return refusal(fmt::format("unknown task {} of golden (expected {}){}", kernels::shown(words[0]), fmt::join(tasks, ", "),
                               did_you_mean(words[0], tasks)));
  if (const std::string fault = missing_value(words); !fault.empty()) return refusal(fault);
  try {
    parser.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, help_text(parser.page_of(parser.asked() ? *parser.asked() : parser.app), help_columns(STDOUT_FILENO)), fine};
  } catch (const CLI::ParseError& error) {
    return refusal(sentence(error, parser.app, parser.asked()), parser.asked() ? parser.asked()->get_name() : "");
  }
  if (!parser.asked()) return refusal(fmt::format("golden expects a task: {}", fmt::join(tasks, ", ")));
  const std::string task = parser.asked()->get_name();
  if (request.folder.empty()) return refusal(parser.generate->parsed() ? "--out expects a folder" : task + " expects a folder", task);
  if (const std::string fault = wrong_files(*parser.asked(), false); !fault.empty()) return refusal(fault, task);
  if (request.state && request.methods.empty()) return refusal("--state says which methods agreed, and needs --method", "verify");
  request.what = parser.generate->parsed() ? GoldenRequest::What::generate
                 : parser.verify->parsed() ? GoldenRequest::What::verify
                                           : GoldenRequest::What::exporting;
  return {request, "", fine};
}

}  // namespace fathom::cli
