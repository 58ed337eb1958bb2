// SPDX-License-Identifier: GPL-3.0-or-later
// mpirun -np N fathom COMMAND ...   is replaced by this program where the processes share a
// command: golden generate, golden verify, certify, and depth on a stream. What they do not share
// rank 0 does alone. Every rank calls the same function with the same words; rank 0 alone prints.
// It is a program of its own so that fathom itself starts without MPI.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/commands/certify.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/commands/golden.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/progress.hpp"
#include "cli/mpi/ranks.hpp"
#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"
#include "reference/files/cases.hpp"
#include "reference/solve/depth.hpp"
#include "verify/golden/release/release.hpp"
#include "verify/harness/journal.hpp"

namespace fathom::cli {
namespace {

/// Returns the default number of threads of each process: the cores of this machine, divided by the
/// processes on it.
unsigned usual_jobs() {
  const char* const ours = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const unsigned processes = ours ? static_cast<unsigned>(std::max(1, std::atoi(ours))) : 1;
  return std::max(1U, std::thread::hardware_concurrency() / processes);
}

// certify: rank 0 reads the cases and writes the reports; every rank has a subject of its own, and
// examines the cases that it is given.

using harness::Examiner;

// The first word of an answer: the kind of error, or `examined`.
constexpr const char *examined = "examined", *subject_failed = "subject", *disagrees = "disagreement",
                     *faulty = "fault";

/// Returns the handler of tasks; it starts the subject with the first case.
Handle examiner(const CertifyRequest& request) {
  return [&request, asked = std::make_shared<std::optional<Examiner>>()](const std::string& task) {
    try {
      if (!*asked) asked->emplace(subject_of(request), examiner_settings(request));
      const std::vector<std::string> words = unpacked(task);
      harness::Outcome outcome = (*asked)->examine(parse_case(words.at(0), "case").value(), std::stol(words.at(1)));
      outcome.fit = 0;  // in the case's own unit the answer keeps all its digits
      return packed({examined, harness::outcome_line(outcome), hello_text((*asked)->info())});
    } catch (const harness::SubjectError& error) {
      return packed({subject_failed, error.what()});
    } catch (const harness::Disagreement& error) {
      return packed({disagrees, error.what(), error.second.name});
    } catch (const std::logic_error& error) {
      return packed({faulty, error.what()});
    }
  };
}

/// Returns the outcome in an answer, or throws the error in it.
harness::Outcome outcome_in(const std::string& answer, const Case& pair, long exponent, const std::string& hello) {
  const std::vector<std::string> words = unpacked(answer);
  if (words.at(0) == subject_failed) throw harness::SubjectError(words.at(1));
  if (words.at(0) == disagrees)
    throw harness::Disagreement(pair, harness::solver_by(solve::second_method(words.at(2)).value()), words.at(1));
  if (words.at(0) == faulty) throw std::logic_error(words.at(1));
  if (words.at(2) != hello)
    throw harness::SubjectError("the subject says something else of itself each time that it is started");
  harness::Outcome outcome = harness::read_outcome(words.at(1)).value();
  outcome.fit = exponent;
  return outcome;
}

ExitCode certify_by_ranks(const Processes& world, const CertifyRequest& request) {
  if (world.rank() > 0) {
    follow(world, [&request] { return examiner(request); });
    return fine;
  }
  install_signal_handlers();
  Ranks ranks(world, examiner(request));
  ExitCode code = internal_error;
  ranks.serve([&] {
    const auto examine = [&](const Case& pair, long exponent, const std::string& hello) {
      return outcome_in(ranks.ask(packed({files::case_json(pair), std::to_string(exponent)}), "case " + pair.id), pair,
                        exponent, hello);
    };
    code = certify(request, {ranks.count(), examine});
  });
  return code;
}

// depth on a stream: rank 0 reads the texts of the cases and prints the replies, in order; every
// rank reads and answers blocks of cases.

ExitCode depth_by_ranks(const Processes& world, const DepthRequest& request) {
  StreamWork work = stream_work(request, exact_replies(request));
  const Handle answer = [&](const std::string& block) { return answer_block(block, request.inputs[0], work); };
  if (world.rank() > 0) {
    follow(world, [&] { return answer; });
    return fine;
  }
  install_signal_handlers();
  Ranks ranks(world, answer);
  work.threads = ranks.count();
  work.elsewhere = [&](const std::string& block, const std::string& name) { return ranks.ask(block, name); };
  ExitCode code = internal_error;
  ranks.serve([&] { code = for_each_case(request.inputs[0], work); });
  return code;
}

// golden generate and golden verify by shards. All ranks must see the same folder. Each shard is
// made, or proved, by one process as without MPI, so bytes and verdicts are the same. Rank 0 alone
// checks the pages of a release.

std::size_t number_in(const std::string& task) {
  std::size_t number = 0;
  std::from_chars(task.data(), task.data() + task.size(), number);
  return number;
}

golden::GenerateOptions options_of(const GenerateRequest& request, unsigned jobs) {
  return {request.level, request.seed, request.folder, jobs, {}, {}};
}

Handle maker(std::shared_ptr<const golden::Generation> generation) {
  return [generation](const std::string& task) {
    const std::size_t number = number_in(task);
    generation->make({&number, 1});
    return std::string();
  };
}

ExitCode generate(const Processes& world, const GenerateRequest& request, unsigned jobs) {
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
        [&](std::size_t i) { return generation->shards()[wanted[i]].name; },
        [](std::size_t, const std::string&) { return true; });
    if (!request.is_part) generation->close();
    made = wanted.size();
  });
  print(fmt::format("{}: {} of {} shards made by {} processes; {}", request.folder, made, generation->shards().size(),
                    world.size(), request.is_part ? "the part is there" : "the release is complete"));
  return fine;
}

/// Returns the handler of tasks; its answers hold the number of records that were proved and, if
/// the shard is refused, place and reason.
Handle prover(const VerifyRequest& request, unsigned jobs) {
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

ExitCode verify(const Processes& world, const VerifyRequest& request, unsigned jobs) {
  if (world.rank() > 0) {
    follow(world, [&] { return prover(request, jobs); });
    return fine;
  }
  Handle own;  // set when the release's pages have been accepted
  Ranks ranks(world, [&](const std::string& task) { return own(task); });
  ExitCode code = internal_error;
  ranks.serve([&] {
    code = verify_golden(request, [&](const std::vector<golden::ShardPlan>& shards, const golden::TakeShard& take) {
      own = prover(request, jobs);
      in_order_by_ranks(
          ranks, shards.size(), [](std::size_t i) { return std::to_string(i); },
          [&](std::size_t i) { return shards[i].name; },
          [&](std::size_t i, const std::string& answer) { return take(i, result_in(answer)); });
    });
  });
  return code;
}

ExitCode golden_by_ranks(const Processes& world, const std::vector<std::string>& words) {
  return carry_out_golden(words, world.rank() == 0, [&](const Given& given) {
    if (given.command == "golden export") return world.rank() == 0 ? export_golden(given) : fine;
    const unsigned jobs = given.integer<unsigned>("--jobs").value_or(usual_jobs());
    return given.command == "golden generate" ? generate(world, GenerateRequest(given), jobs)
                                              : verify(world, VerifyRequest(given), jobs);
  });
}

ExitCode run(const Processes& world, const std::vector<std::string>& words) {
  const Arguments arguments = parse_arguments(words);
  const bool leads = world.rank() == 0;
  if (!arguments.given) return leads ? said(arguments) : arguments.code;
  const Given& given = *arguments.given;
  if (given.command == "golden") return golden_by_ranks(world, given.rest);
  if (given.command == "certify" && !given.has("--replay") && !given.has("--claims") && !given.flag("--list-adapters"))
    return certify_by_ranks(world, CertifyRequest(given));
  // Certificates go to files, one after another: rank 0 alone keeps their order.
  if (given.command == "depth" && !given.has("--along") && !given.has("--certificate"))
    if (const DepthRequest request(given); is_stream(request)) return depth_by_ranks(world, request);
  return leads ? run_command(given) : fine;
}

}  // namespace
}  // namespace fathom::cli

int main(int argc, char** argv) {
  using namespace fathom::cli;
  guard_memory();
  const fathom::kernels::DefaultFloatEnvironment environment;
  hold_standard_streams();
  const Processes processes(argc, argv);
  unsetenv("OMPI_COMM_WORLD_SIZE");  // otherwise programs started from here would join the job
  return guarded([&] { return run(processes, {argv + std::min(argc, 1), argv + argc}); });
}
