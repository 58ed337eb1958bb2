// SPDX-License-Identifier: GPL-3.0-or-later
// fathom golden generate | verify | export

#include "cli/commands/golden.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/args/help.hpp"
#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "kernels/messages.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::cli {
namespace {

constexpr ExitCode golden_refused = static_cast<ExitCode>(1);

/// Makes the missing shards of the request's part. Returns how many it made, and how many the
/// release has.
std::pair<std::size_t, std::size_t> make_shards(const GenerateRequest& request) {
  Progress progress;
  StopOnInterrupt interrupt;
  golden::GenerateOptions options{request.level, request.seed, request.folder, request.jobs, &interrupt, {}};
  options.report = [&](const golden::Done& done) { progress.count({done.recipes, done.of}, done.shard); };
  const golden::Generation generation(options);
  const std::vector<std::size_t> wanted = in_part(generation.unfinished(), request);
  generation.make(wanted);
  if (!request.is_part) generation.close();
  return {wanted.size(), generation.shards().size()};
}

ExitCode generate(const GenerateRequest& request) {
  const InterruptGuard interrupt_guard;
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit on file sizes then fails like one on a full disk
  const auto [made, all] = make_shards(request);
  print(fmt::format(
      "{}: {} of {} shards made; {}", request.folder, made, all,
      request.is_part ? fmt::format("part {}/{} is there", request.part, request.parts) : "the release is complete"));
  return fine;
}

std::string verified_line(const golden::Verified& verified, const VerifyRequest& request) {
  std::vector<std::string_view> agreed;
  for (const Method method : request.methods) agreed.push_back(name(method));
  return fmt::format("s VERIFIED {} version={} seed={} shards={} records={}{}{} {}", name_of(verified.level),
                     verified.version, verified.seed, verified.shards, verified.records,
                     agreed.empty() ? "" : " agreed=", fmt::join(agreed, ","), request.folder);
}

/// Returns which records are exported, and the form of the export.
golden::ExportRequest export_request(const Given& given) {
  golden::ExportRequest exported;
  exported.format = golden::find_export_format(given.text("--format")).value();
  exported.only = given.words("--only");
  exported.excluded = given.words("--exclude");
  exported.families = given.words("--family");
  exported.contacts = given.words("--contact");
  if (const auto binary = given.value("--exact-in")) exported.exact_in = *binary;
  if (const auto points = given.integer<std::uint64_t>("--max-points")) exported.most_points = *points;
  if (const auto count = given.integer<std::uint64_t>("--count")) exported.count = *count;
  exported.certificates = given.has("--certificates");
  return exported;
}

// ---- the words ----

std::vector<std::string> task_names() {
  std::vector<std::string> names;
  for (const CommandHelp& command : command_table)
    if (parent(command) == "golden") names.emplace_back(last_word(command));
  return names;
}

Arguments parse_golden(const std::vector<std::string>& words) {
  const std::vector<std::string> tasks = task_names();
  if (!words.empty() && std::ranges::find(tasks, words[0]) == tasks.end() && !words[0].starts_with('-'))
    return refusal(fmt::format("unknown task {} of golden (expected {}){}", kernels::shown(words[0]),
                               fmt::join(tasks, ", "), did_you_mean(words[0], tasks)),
                   "golden");
  Arguments arguments = read_words("golden", golden_options(), words);
  if (!arguments.given) return arguments;
  const Given& given = *arguments.given;
  const std::string& task = given.command;
  if (task == "golden") return refusal(fmt::format("golden expects a task: {}", fmt::join(tasks, ", ")), task);
  const bool generates = task == "golden generate";
  if (given.text(generates ? "--out" : "folder").empty())
    return refusal(generates ? "--out expects a folder" : task.substr(task.rfind(' ') + 1) + " expects a folder", task);
  if (const std::string fault = wrong_files(given, false); !fault.empty()) return refusal(fault, task);
  if (given.flag("--state") && !given.has("--method"))
    return refusal("--state says which methods agreed, and needs --method", task);
  return arguments;
}

}  // namespace

GenerateRequest::GenerateRequest(const Given& given)
    : level(golden::find_level(given.text("--level")).value()),
      seed(given.integer<std::uint64_t>("--seed").value_or(1)),
      folder(given.text("--out")),
      jobs(given.integer<unsigned>("--jobs").value_or(0)),
      is_part(given.has("--shard")) {
  std::tie(part, parts) = typed_part(given.value("--shard").value_or("1/1")).value();
}

VerifyRequest::VerifyRequest(const Given& given)
    : folder(given.text("folder")),
      jobs(given.integer<unsigned>("--jobs").value_or(0)),
      methods(typed_methods(given.words("--method"))),
      state(given.flag("--state")) {}

ExitCode export_golden(const Given& given) {
  StopOnInterrupt interrupt;
  const std::string folder = given.text("folder"), certificates = given.text("--certificates");
  std::optional<CertificateFile> proofs;
  if (!certificates.empty()) proofs.emplace(certificates, "file of certificates");
  const bool own = folder == "-" || (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder));
  const golden::ExportRequest request = export_request(given);
  const golden::Exported exported =
      own ? golden::export_own_cases(folder, request, &interrupt) : golden::export_release(folder, request, &interrupt);
  if (proofs) proofs->write(exported.certificates);
  print(exported.text.substr(0, exported.text.size() - 1));  // print() appends the last line end
  talk(fmt::format("{} of {} fitting records; of all {}, {} are beyond binary64, {} are excluded, {} have more points",
                   exported.chosen, exported.fitting, exported.records, exported.not_doubles, exported.excluded,
                   exported.too_large));
  return fine;
}

std::vector<std::size_t> in_part(const std::vector<std::size_t>& shards, const GenerateRequest& request) {
  std::vector<std::size_t> ours;
  for (const std::size_t shard : shards)
    if (shard % request.parts == request.part - 1) ours.push_back(shard);
  return ours;
}

ExitCode verify_golden(const VerifyRequest& request,
                       std::function<void(const std::vector<golden::ShardPlan>&, const golden::TakeShard&)> elsewhere) {
  const InterruptGuard interrupt_guard;
  golden::Verified verified;
  {
    Progress progress("records");
    StopOnInterrupt interrupt;
    golden::VerifyOptions options{request.methods, request.jobs, &interrupt, {}, std::move(elsewhere)};
    options.report = [&](std::size_t records, std::size_t of) { progress.count({records, of}); };
    verified = golden::verify(request.folder, options);
  }
  for (const golden::Refusal& refusal : verified.refusals)
    print(without_controls(fmt::format("s REFUSED {}: {}", refusal.place, refusal.reason)));
  if (!verified.refusals.empty()) return golden_refused;
  try {
    if (request.state) golden::state_agreement(request.folder, verified, request.methods);
  } catch (const golden::FileError& error) {
    talk(error.what());
    return internal_error;
  }
  print(verified_line(verified, request));
  return fine;
}

ExitCode carry_out_golden(const std::vector<std::string>& words, bool says_usage,
                          const std::function<ExitCode(const Given&)>& work) {
  const Arguments arguments = parse_golden(words);
  if (!arguments.given) return says_usage ? said(arguments) : arguments.code;
  try {
    return work(*arguments.given);
  } catch (const golden::FolderError& error) {
    talk(error.what());
    return bad_input;
  } catch (const golden::FileError& error) {
    talk(error.what());
    return arguments.given->command == "golden generate" ? internal_error : bad_input;
  }
}

ExitCode run_golden(const Given& given) {
  return carry_out_golden(given.rest, true, [](const Given& task) {
    if (task.command == "golden generate") return generate(GenerateRequest(task));
    return task.command == "golden verify" ? verify_golden(VerifyRequest(task)) : export_golden(task);
  });
}

}  // namespace fathom::cli
