// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/golden_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <tuple>

#include "cli/args/arguments.hpp"
#include "cli/args/help.hpp"
#include "cli/args/help_page.hpp"
#include "cli/args/values.hpp"
#include "cli/args/words.hpp"
#include "cli/io/terminal.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::uint64_t most_parts = 1'000'000;

/// `task`: "generate", or "" for the command itself.
GoldenArguments refusal(const std::string& sentence, const std::string& task = "") {
  return {std::nullopt, fmt::format("{}\nTry: fathom golden {}--help", sentence, task.empty() ? "" : task + " "),
          bad_input};
}

std::vector<std::string> task_names() {
  std::vector<std::string> names;
  for (const CommandHelp& command : command_table)
    if (parent(command) == "golden") names.emplace_back(last_word(command));
  return names;
}

GoldenRequest request_of(const Given& given, const std::string& task) {
  using What = GoldenRequest::What;
  GoldenRequest request;
  request.what = task == "generate" ? What::generate : task == "verify" ? What::verify : What::exporting;
  if (const auto level = given.value("--level")) request.level = golden::find_level(*level).value();
  if (const auto seed = given.value("--seed")) request.seed = typed_integer(*seed).value();
  request.folder = given.text(request.what == What::generate ? "--out" : "folder");
  if (const auto jobs = given.value("--jobs")) request.jobs = typed_threads(*jobs).value();
  if (const auto part = given.value("--shard")) {
    std::tie(request.part, request.parts) = typed_part(*part).value();
    request.is_part = true;
  }
  request.methods = second_methods(given);
  request.state = given.flag("--state");
  golden::ExportRequest& exported = request.exported;
  if (const auto format = given.value("--format")) exported.format = golden::find_export_format(*format).value();
  exported.only = given.words("--only");
  exported.excluded = given.words("--exclude");
  exported.families = given.words("--family");
  exported.contacts = given.words("--contact");
  if (const auto binary = given.value("--exact-in")) exported.exact_in = *binary;
  if (const auto points = given.value("--max-points")) exported.most_points = typed_integer(*points).value();
  if (const auto count = given.value("--count")) exported.count = typed_integer(*count).value();
  exported.certificates = given.has("--certificates");
  request.certificates = given.text("--certificates");
  return request;
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> typed_part(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto parts = typed_integer(text.substr(std::min(slash + 1, text.size())), 1, most_parts);
  const auto part = parts ? typed_integer(text.substr(0, slash), 1, *parts) : std::nullopt;
  return part ? std::optional(std::pair<std::size_t, std::size_t>(*part, *parts)) : std::nullopt;
}

GoldenArguments parse_golden(const std::vector<std::string>& words) {
  const std::vector<std::string> tasks = task_names();
  if (!words.empty() && std::ranges::find(tasks, words[0]) == tasks.end() && !words[0].starts_with('-'))
    return refusal(fmt::format("unknown task {} of golden (expected {}){}", kernels::shown(words[0]),
                               fmt::join(tasks, ", "), did_you_mean(words[0], tasks)));
  if (const std::string fault = missing_value(words); !fault.empty()) return refusal(fault);
  const Given given = read_words("golden", golden_options(), words);
  const std::string task = given.command == "golden" ? "" : given.command.substr(given.command.rfind(' ') + 1);
  if (given.kind == Given::Kind::help)
    return {std::nullopt, help_text(page_of(given.command, golden_options()), help_columns(STDOUT_FILENO)), fine};
  if (given.kind == Given::Kind::refused) return refusal(given.fault, task);
  if (task.empty()) return refusal(fmt::format("golden expects a task: {}", fmt::join(tasks, ", ")));
  const GoldenRequest request = request_of(given, task);
  if (request.folder.empty())
    return refusal(task == "generate" ? "--out expects a folder" : task + " expects a folder", task);
  if (const std::string fault = wrong_files(given, false); !fault.empty()) return refusal(fault, task);
  if (request.state && request.methods.empty())
    return refusal("--state says which methods agreed, and needs --method", "verify");
  return {request, "", fine};
}

}  // namespace fathom::cli
