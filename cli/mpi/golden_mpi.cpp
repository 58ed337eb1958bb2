// SPDX-License-Identifier: GPL-3.0-or-later
// golden generate and golden verify by shards. All ranks must see the same folder. Each shard is made, or proved, by one process as without
// MPI, so bytes and verdicts are the same. Rank 0 alone checks the pages of a release.
#include <fmt/format.h>

#include <charconv>
#include <csignal>
#include <memory>
#include <optional>

#include "cli/commands/command.hpp"
#include "cli/commands/golden.hpp"
#include "cli/io/output.hpp"
#include "cli/io/packed.hpp"
#include "cli/mpi/verbs.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::cli {
namespace {

std::size_t number_in(const std::string& task) {
  std::size_t number = 0;
  std::from_chars(task.data(), task.data() + task.size(), number);
  return number;
}

golden::GenerateOptions options_of(const GoldenRequest& request, unsigned jobs) {
  return {request.level, request.seed, request.folder, jobs, {}, {}};
}

Handle maker(std::shared_ptr<const golden::Generation> generation) {
  return [generation](const std::string& task) {
    const std::size_t number = number_in(task);
    generation->make({&number, 1});
    return std::string();
  };
}

ExitCode generate(const Processes& world, const GoldenRequest& request, unsigned jobs) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error like a full disk
  if (world.rank() > 0) {
    follow(world, [&] { return maker(std::make_shared<golden::Generation>(options_of(request, jobs))); });
    return fine;
  }
  std::shared_ptr<golden::Generation> generation;
  Ranks ranks(world, [&](const std::string& task) { return maker(generation)(task); });
  std::size_t made = 0;
  ranks.serve([&] {
    generation = std::make_shared<golden::Generation>(options_of(request, jobs));
    const std::vector<std::size_t> wanted = in_part(generation->unfinished(), request);
    in_order_by_ranks(
        ranks, wanted.size(), [&](std::size_t i) { return std::to_string(wanted[i]); },
        [&](std::size_t i) { return generation->shards()[wanted[i]].name; }, [](std::size_t, const std::string&) { return true; });
    if (!request.is_part) generation->close();
    made = wanted.size();
  });
  print(fmt::format("{}: {} of {} shards made by {} processes; {}", request.folder, made, generation->shards().size(), world.size(),
                    request.is_part ? "the part is there" : "the release is complete"));
  return fine;
}

/// The records that were proved; then, if the shard is refused, place and reason.
Handle prover(const GoldenRequest& request, unsigned jobs) {
  golden::VerifyOptions options;
  options.methods = request.methods;
  options.jobs = jobs;
  return [verifier = std::make_shared<golden::ShardVerifier>(request.folder, options)](const std::string& task) {
    const golden::ShardResult result = verifier->verify(number_in(task));
    std::vector<std::string> words = {std::to_string(result.records)};
    if (result.refusal) words.insert(words.end(), {result.refusal->place, result.refusal->reason});
    return packed(words);
  };
}

golden::ShardResult result_in(const std::string& answer) {
  const std::vector<std::string> words = unpacked(answer);
  golden::ShardResult result{number_in(words.at(0)), std::nullopt};
  if (words.size() > 1) result.refusal = {words.at(1), words.at(2)};
  return result;
}

ExitCode verify(const Processes& world, const GoldenRequest& request, unsigned jobs) {
  if (world.rank() > 0) {
    follow(world, [&] { return prover(request, jobs); });
    return fine;
  }
  Handle own;  // once the release's pages are known to be good
  Ranks ranks(world, [&](const std::string& task) { return own(task); });
  ExitCode code = internal_error;
  ranks.serve([&] {
    code = verify_golden(request, [&](const std::vector<golden::ShardPlan>& shards, const golden::TakeShard& take) {
      own = prover(request, jobs);
      in_order_by_ranks(
          ranks, shards.size(), [](std::size_t i) { return std::to_string(i); }, [&](std::size_t i) { return shards[i].name; },
          [&](std::size_t i, const std::string& answer) { return take(i, result_in(answer)); });
    });
  });
  return code;
}

}  // namespace

ExitCode golden_by_ranks(const Processes& world, const std::vector<std::string>& words) {
  return carry_out_golden(words, world.rank() == 0, [&](const GoldenRequest& request) {
    if (request.what == GoldenRequest::What::exporting) return world.rank() == 0 ? export_golden(request) : fine;
    const unsigned jobs = request.jobs ? request.jobs : usual_jobs();
    return request.what == GoldenRequest::What::generate ? generate(world, request, jobs) : verify(world, request, jobs);
  });
}

}  // namespace fathom::cli
