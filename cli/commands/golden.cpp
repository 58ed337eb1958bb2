// SPDX-License-Identifier: GPL-3.0-or-later
// fathom golden generate | verify | export

#include "cli/commands/golden.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::cli {
namespace {

constexpr ExitCode refused = static_cast<ExitCode>(1);

/// Makes the missing shards of the request's part. Returns their number, and that of the release.
std::pair<std::size_t, std::size_t> make_shards(const GoldenRequest& request) {
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

ExitCode generate(const GoldenRequest& request) {
  const Working working;
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error like a full disk
  const auto [made, all] = make_shards(request);
  print(fmt::format(
      "{}: {} of {} shards made; {}", request.folder, made, all,
      request.is_part ? fmt::format("part {}/{} is there", request.part, request.parts) : "the release is complete"));
  return fine;
}

std::string verified_line(const golden::Verified& verified, const GoldenRequest& request) {
  std::vector<std::string_view> agreed;
  for (const Method method : request.methods) agreed.push_back(name(method));
  return fmt::format("s VERIFIED {} version={} seed={} shards={} records={}{}{} {}", name_of(verified.level),
                     verified.version, verified.seed, verified.shards, verified.records,
                     agreed.empty() ? "" : " agreed=", fmt::join(agreed, ","), request.folder);
}

}  // namespace

ExitCode export_golden(const GoldenRequest& request) {
  StopOnInterrupt interrupt;
  std::optional<CertificateFile> proofs;
  if (!request.certificates.empty()) proofs.emplace(request.certificates, "file of certificates");
  const bool own = request.folder == "-" ||
                   (std::filesystem::exists(request.folder) && !std::filesystem::is_directory(request.folder));
  const golden::Exported exported = own ? golden::export_own_cases(request.folder, request.exported, &interrupt)
                                        : golden::export_release(request.folder, request.exported, &interrupt);
  if (proofs) proofs->write(exported.certificates);
  print(exported.text.substr(0, exported.text.size() - 1));  // print ends the last line
  talk(fmt::format("{} of {} fitting records; of all {}, {} are beyond binary64, {} are excluded, {} have more points",
                   exported.chosen, exported.fitting, exported.records, exported.not_doubles, exported.excluded,
                   exported.too_large));
  return fine;
}

std::vector<std::size_t> in_part(const std::vector<std::size_t>& shards, const GoldenRequest& request) {
  std::vector<std::size_t> ours;
  for (const std::size_t shard : shards)
    if (shard % request.parts == request.part - 1) ours.push_back(shard);
  return ours;
}

ExitCode verify_golden(const GoldenRequest& request,
                       std::function<void(const std::vector<golden::ShardPlan>&, const golden::TakeShard&)> elsewhere) {
  const Working working;
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
  if (!verified.refusals.empty()) return refused;
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
                          const std::function<ExitCode(const GoldenRequest&)>& work) {
  const GoldenArguments arguments = parse_golden(words);
  if (!arguments.request) {
    if (says_usage) arguments.code == fine ? print(arguments.text) : talk(arguments.text);
    return arguments.code;
  }
  const bool generates = arguments.request->what == GoldenRequest::What::generate;
  try {
    return work(*arguments.request);
  } catch (const golden::FolderError& error) {
    talk(error.what());
    return bad_input;
  } catch (const golden::FileError& error) {
    talk(error.what());
    return generates ? internal_error : bad_input;
  }
}

ExitCode run_golden(const std::vector<std::string>& words) {
  return carry_out_golden(words, true, [](const GoldenRequest& request) {
    switch (request.what) {
      case GoldenRequest::What::generate: return generate(request);
      case GoldenRequest::What::verify: return verify_golden(request);
      case GoldenRequest::What::exporting: break;
    }
    return export_golden(request);
  });
}

}  // namespace fathom::cli
