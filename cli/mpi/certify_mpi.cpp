// SPDX-License-Identifier: GPL-3.0-or-later
// Rank 0 reads the cases and writes the reports; every rank has a subject of its own, and examines the cases that it is given.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/certify.hpp"
#include "cli/io/packed.hpp"
#include "cli/io/progress.hpp"
#include "cli/mpi/verbs.hpp"
#include "fathom/files.hpp"
#include "reference/files/case_json.hpp"
#include "reference/solve/disagreement.hpp"
#include "verify/harness/journal.hpp"

namespace fathom::cli {
namespace {

using harness::Examiner;

// How an answer begins: which error it is, or none.
constexpr const char *examined = "examined", *subject_failed = "subject", *disagrees = "disagreement", *faulty = "fault";

/// Starts the subject with the first case.
Handle examiner(const Request& request) {
  return [&request, asked = std::make_shared<std::optional<Examiner>>()](const std::string& task) {
    try {
      if (!*asked) asked->emplace(subject_of(request.certify), examiner_settings(request.certify));
      const std::vector<std::string> words = unpacked(task);
      harness::Outcome outcome = (*asked)->examine(parse_case(words.at(0), "case").value(), std::stol(words.at(1)));
      outcome.fit = 0;  // in its own unit the answer keeps all its digits
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

/// The outcome in an answer, or the error.
harness::Outcome outcome_in(const std::string& answer, const Case& pair, long exponent, const std::string& hello) {
  const std::vector<std::string> words = unpacked(answer);
  if (words.at(0) == subject_failed) throw harness::SubjectError(words.at(1));
  if (words.at(0) == disagrees)
    throw harness::Disagreement(pair, harness::solver_by(solve::second_method(words.at(2)).value()), words.at(1));
  if (words.at(0) == faulty) throw std::logic_error(words.at(1));
  if (words.at(2) != hello) throw harness::SubjectError("the subject says something else of itself each time that it is started");
  harness::Outcome outcome = harness::read_outcome(words.at(1)).value();
  outcome.fit = exponent;
  return outcome;
}

}  // namespace

ExitCode certify_by_ranks(const Processes& world, const Request& request) {
  if (world.rank() > 0) {
    follow(world, [&request] { return examiner(request); });
    return fine;
  }
  install_signal_handlers();
  Ranks ranks(world, examiner(request));
  ExitCode code = internal_error;
  ranks.serve([&] {
    const auto examine = [&](const Case& pair, long exponent, const std::string& hello) {
      return outcome_in(ranks.ask(packed({files::case_json(pair), std::to_string(exponent)}), "case " + pair.id), pair, exponent, hello);
    };
    code = certify(request, {ranks.count(), examine});
  });
  return code;
}

}  // namespace fathom::cli
