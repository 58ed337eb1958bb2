// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/nightly/two_ways.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <random>
#include <thread>

#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::nightly {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int agreed = 0, differed = 1, wrong_arguments = 2, failed = 3, interrupted = 130;

struct Wanted {
  std::uint64_t seed = 0, from = 0;
  std::optional<std::uint64_t> count;
  std::optional<Clock::duration> until;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string keep = "differences";
  bool unions = false, small_world = false;
};

/// "90s", "10min", "8h".
std::optional<Clock::duration> time_of(std::string_view text) {
  unsigned long amount = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
  if (error != std::errc() || amount > 1'000'000) return std::nullopt;
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (unit == "s") return std::chrono::seconds(amount);
  if (unit == "min") return std::chrono::minutes(amount);
  if (unit == "h") return std::chrono::hours(amount);
  return std::nullopt;
}

std::string check_time(const std::string& text) {
  return time_of(text) ? "" : "expected a time such as 90s, 10min or 8h, found '" + text + "'";
}

/// Digits alone: CLI11 would take -1 for the largest number.
std::string check_number(const std::string& text) {
  const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? "" : "expected an integer from 0 to 2^64 - 1, found '" + text + "'";
}

void add_options(CLI::App& app, Wanted& wanted) {
  const auto add_number = [&app](const char* name, auto& number, const char* meaning) {
    app.add_option(name, number, meaning)->check(CLI::Validator(check_number, "", ""))->type_name("N");
  };
  add_number("--seed", wanted.seed, "of the stream; a new one unless given");
  add_number("--from", wanted.from, "number of the first case; 0 unless given");
  add_number("--cases", wanted.count, "end after so many cases");
  app.add_option_function<std::string>(
         "--until", [&](const std::string& text) { wanted.until = time_of(text); }, "or after this time")
      ->check(CLI::Validator(check_time, "", ""))
      ->type_name("10min");
  app.add_option("--jobs", wanted.jobs, "threads; as many as there are cores unless given")
      ->check(CLI::Range(1U, 1024U))
      ->type_name("N");
  app.add_option("--keep", wanted.keep, "the folder for a case with a difference; 'differences' unless given")
      ->type_name("DIR");
  app.add_flag("--unions", wanted.unions, "cases of unions alone");
  app.add_flag("--small-world", wanted.small_world,
               "every pair of tetrahedra with corners in {0, 1, 2}^3 instead, in order, the second way by the hull of "
               "all vertex differences")
      ->excludes("--unions");
}

/// Every fifth case is one of unions.
Case case_of(const Wanted& wanted, std::uint64_t number) {
  constexpr std::uint64_t turn = 5;
  if (wanted.small_world) return families::small_case(number);
  if (wanted.unions) return harness::random_unions(wanted.seed, number);
  const std::uint64_t round = number / turn, place = number % turn;
  if (place + 1 == turn) return harness::random_unions(wanted.seed, round);
  return harness::random_case(wanted.seed, round * (turn - 1) + place);
}

std::size_t size_of(const Body& body) { return body.pieces ? body.pieces->size() : body.points.size(); }

harness::StreamResult compare(const Wanted& wanted, cli::Progress& progress, const harness::Solver& x,
                              const harness::Solver& y) {
  const Clock::time_point begin = Clock::now();
  harness::StreamPlan plan;
  plan.make = [&](std::uint64_t number) { return case_of(wanted, number); };
  plan.from = wanted.from;
  plan.count = wanted.count;
  if (wanted.small_world) {
    const std::uint64_t size = families::small_world_size(), rest = size - std::min(size, wanted.from);
    plan.count = std::min(rest, wanted.count.value_or(rest));
  }
  plan.jobs = wanted.jobs;
  plan.stop = [&] { return progress.stopped() || (wanted.until && Clock::now() - begin >= *wanted.until); };
  plan.report = [&](std::uint64_t done) { progress.report(fmt::format("{} cases agree", done), -1); };
  return harness::compare_stream(plan, x, y);
}

int run(const Wanted& wanted, const harness::Solver& x, const harness::Solver& y) {
  const cli::InterruptGuard interrupt_guard;
  cli::talk(
      fmt::format("seed {}, from case {}", wanted.seed, wanted.from));  // first, so that a killed run can be made again
  cli::Progress progress;
  const harness::StreamResult result = compare(wanted, progress, x, y);
  progress.clear();
  const std::string goes_on =
      fmt::format("goes on: --seed {} --from {}{}", wanted.seed, result.end + (result.first ? 1 : 0),
                  wanted.unions        ? " --unions"
                  : wanted.small_world ? " --small-world"
                                       : "");
  if (!result.first) {
    cli::print(fmt::format("seed {}, cases {} to {}: {} and {} agree in every field; {}", wanted.seed, wanted.from,
                           result.end, x.name, y.name, goes_on));
    return progress.stopped() ? interrupted : agreed;
  }
  cli::print(
      fmt::format("seed {}, case {}, {}: {}", wanted.seed, result.end, result.first->pair.id, result.first->sentence));
  progress.report("making it smaller", -1);
  const auto stop = [&] { return progress.stopped(); };
  const harness::KeptDifference kept =
      harness::keep_difference(wanted.keep, result.first->pair, result.first->sentence, x, y, stop);
  progress.clear();
  cli::print(fmt::format("kept as {}, {} and {} {}: {}; {}", kept.path, size_of(kept.pair.a), size_of(kept.pair.b),
                         kept.pair.a.pieces ? "pieces" : "points", kept.sentence, goes_on));
  return differed;
}

}  // namespace

int two_ways(int argc, char** argv, const harness::Solver& x, const harness::Solver& y) {
  cli::install_signal_handlers();
  Wanted wanted;
  wanted.seed = std::random_device()();
  CLI::App app(
      fmt::format(
          "Random cases of all families, of unions too, by {} and by {}, every field compared. The first difference is "
          "made small and kept.",
          x.name, y.name),
      "fathom-two-ways");
  add_options(app, wanted);
  try {
    app.parse(argc, argv);
    return run(wanted, x, wanted.small_world ? harness::solver_by(Method::naive) : y);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? agreed : wrong_arguments;
  } catch (const std::exception& error) {
    cli::talk(error.what());
    return failed;
  }
}

}  // namespace fathom::nightly
