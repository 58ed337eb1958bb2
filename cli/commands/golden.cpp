// SPDX-License-Identifier: GPL-3.0-or-later
// fathom golden generate | verify | export

#include "cli/commands/golden.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

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
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "kernels/messages.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/release/release.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::cli {
namespace {

// ---- the options ----

std::string wrong_level(const std::string& text) {
  return unless(golden::find_level(text).has_value(), "L0, L1, L2, L3, P0, P1, U0, C0 or F0", text);
}
std::string wrong_part(const std::string& text) {
  return unless(typed_part(text).has_value(), "i/n with 1 <= i <= n", text);
}
std::string wrong_format(const std::string& text) {
  return unless(golden::find_export_format(text).has_value(), "c, csv, json or rust", text);
}
std::string wrong_positive(const std::string& text) {
  return unless(typed_integer(text, 1).has_value(), "a positive integer", text);
}
std::string wrong_binary(const std::string& text) {
  return unless(text == "binary32" || text == "binary64", "binary32 or binary64", text);
}

/// Returns a sentence on the first word of the list that is unknown, with a suggestion, or "".
std::string wrong_words(const std::string& list, const std::vector<std::string>& known, std::string_view expected) {
  for (const std::string& word : words_of(list)) {
    const bool pattern = word.find_first_of("*?[") != word.npos;
    const auto same = [&](const std::string& other) {
      return pattern ? ::fnmatch(word.c_str(), other.c_str(), 0) == 0 : word == other;
    };
    if (std::ranges::any_of(known, same)) continue;
    const auto meant =
        std::ranges::find_if(known, [&word](const std::string& other) { return kernels::is_near(word, other); });
    return fmt::format("expected {}, found {}{}", expected, kernels::shown(word),
                       meant == known.end() ? fmt::format(" (there are {})", fmt::join(known, ", "))
                                            : fmt::format(" (did you mean {}?)", *meant));
  }
  return "";
}

/// Returns the kinds of contact that facets of P have, and its edges in the plane: of two vertices
/// only where bodies do not overlap.
std::vector<std::string> kinds_of_contact() {
  std::vector<std::string> known;
  for (int kind = 0; kind <= static_cast<int>(ContactKind::edge_vertex); ++kind)
    if (static_cast<ContactKind>(kind) != ContactKind::vertex_vertex)
      known.emplace_back(name(static_cast<ContactKind>(kind)));
  return known;
}

std::string wrong_flags(const std::string& list) {
  return wrong_words(list, golden::words_of_cases(), "flags of golden data, or a status");
}
std::string wrong_families(const std::string& list) {
  return wrong_words(list, golden::groups_of_releases(), "families, catalogue or real");
}
std::string wrong_contacts(const std::string& list) {
  return wrong_words(list, kinds_of_contact(), "kinds of contact");
}

std::vector<Option> make_table() {
  const Values flags{wrong_flags, golden::words_of_cases()};
  return {
      {"golden generate",
       "--level",
       "LEVEL",
       "L0, L1, L2 or L3, of polytopes: hundreds of records, about ten thousand,\nover a hundred thousand, about ten "
       "million; P0 or P1, of "
       "shapes: about a\nthousand, about ten thousand; each holds the shards of those below it;\nU0, of unions of "
       "convex pieces: hundreds; C0, with where the bodies touch: hundreds;\nF0, of bodies of the plane: hundreds",
       {wrong_level, {"L0", "L1", "L2", "L3", "P0", "P1", "U0", "C0", "F0"}},
       FileUse::none,
       Repeats::never,
       true},
      {"golden generate", "--seed", "N", "of the families; 1 unless given", {wrong_integer<0, UINT64_MAX>}},
      {"golden generate", "--out", "DIR", "the folder, made if need be", {}, FileUse::folder, Repeats::never, true},
      {"golden generate",
       "--shard",
       "I/N",
       "make every n-th shard only, from the i-th on, and leave it to a last run\nwithout --shard to complete the "
       "release",
       {wrong_part}},
      {"golden verify,golden export", "folder", "", ""},
      {"golden verify",
       "--method",
       "NAME",
       "compute every record again by exact (AGHRS's pipeline) or naive (the hull\nof all vertex differences) too, and "
       "compare every "
       "field; "
       "may be repeated",
       {wrong_second_method, {"exact", "naive"}},
       FileUse::none,
       Repeats::each},
      {"golden verify", "--state", "", "once all agree, write agreement.json into the folder, which says so"},
      {"golden generate,golden verify",
       "--jobs",
       "N",
       "threads; as many as there are cores unless given",
       {wrong_threads}},
      {"golden export",
       "--format",
       "FORMAT",
       "c (C89 and C++), rust, json or csv",
       {wrong_format, {"c", "csv", "json", "rust"}},
       FileUse::none,
       Repeats::never,
       true},
      {"golden export", "--only", "FLAGS", "take only records with one of these flags, as for --exclude", flags,
       FileUse::none, Repeats::lists},
      {"golden export", "--exclude", "FLAGS",
       "leave out records with one of these flags, separated by commas:\nflat_a, ties, ..., or their first word: flat, "
       "huge; or of a\n"
       "status: penetrating, touching, disjoint",
       flags, FileUse::none, Repeats::lists},
      {"golden export",
       "--family",
       "NAMES",
       "take only records of these families, separated by commas:\nfar_boxes, 'touching_*', ..., catalogue, real",
       {wrong_families, golden::groups_of_releases()},
       FileUse::none,
       Repeats::lists},
      {"golden export",
       "--contact",
       "KINDS",
       "take only records with a shortest way out of one of these kinds:\nedge-edge, facet-vertex (of A, of B), ...",
       {wrong_contacts, kinds_of_contact()},
       FileUse::none,
       Repeats::lists},
      {"golden export",
       "--exact-in",
       "FORMAT",
       "take only points that are numbers of binary32, or of binary64, as all\nare",
       {wrong_binary, {"binary32", "binary64"}}},
      {"golden export", "--max-points", "N", "leave out records with more points in a body", {wrong_positive}},
      {"golden export",
       "--count",
       "N",
       "so many of the others, spread evenly over the families; all unless\ngiven",
       {wrong_positive}},
      {"golden export",
       "--certificates",
       "FILE",
       "write the certificates of all cases in the export to this file",
       {},
       FileUse::written},
  };
}

// ---- the tasks ----

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

std::span<const Option> golden_options() {
  static const std::vector<Option> table = make_table();
  return table;
}

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
