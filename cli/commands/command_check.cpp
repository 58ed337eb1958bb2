// SPDX-License-Identifier: GPL-3.0-or-later
// fathom check [--proved] [--threads N] CERTIFICATES...   hands over to the independent checkers, which have a parser and a command line of
// their own.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include "cli/args/help_page.hpp"
#include "cli/args/threads.hpp"
#include "cli/args/words.hpp"
#include "cli/commands/check_page.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/proved_checker.hpp"
#include "cli/io/in_order.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/terminal.hpp"
#include "kernels/messages.hpp"
#include "verify/check/command_line.hpp"
#include "verify/check/run.hpp"

namespace fathom::cli {
namespace {

struct UsageFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Replaces this process by the checker that was extracted from the Coq development; returns only if there is none, beside this program or
/// on the path.
ExitCode become_proved(const std::vector<std::string>& words) {
  become(proved_program, words);
  talk(proved_program_is_missing());
  return internal_error;
}

/// Compares with cases and results first, which the proved checker cannot read; then it must accept what passes.
ExitCode compare_and_prove(const std::vector<std::string>& words, bool width) {
  ProvedChecker proved(width);
  const int code = fathom_check::command_line(words, "fathom check", &proved);
  return proved.failed() || !std::cout ? internal_error : static_cast<ExitCode>(code);
}

/// Lends the checker this program's threads.
class Threads : public fathom_check::Workers {
 public:
  explicit Threads(unsigned threads) : threads_(threads) {}
  void run(const std::function<std::optional<fathom_check::Piece>()>& next) override {
    using fathom_check::Piece;
    const auto next_piece = [&] {
      std::optional<Piece> piece = next();
      return piece ? std::make_shared<Piece>(*std::move(piece)) : nullptr;
    };
    in_order<Piece>(
        threads_, next_piece, [](const Piece& piece) { piece.work(); }, [](const Piece& piece) { piece.report(); });
  }

 private:
  unsigned threads_;
};

/// Takes "--threads N" out of the words. Throws UsageFault.
std::optional<unsigned> take_threads(std::vector<std::string>& words) {
  const auto option = std::find_if(words.begin(), std::find(words.begin(), words.end(), "--"),
                                   [](const std::string& word) { return word == "--threads" || word.starts_with("--threads="); });
  if (option == words.end() || *option == "--") return std::nullopt;
  const bool joined = *option != "--threads";
  if (!joined && option + 1 == words.end()) throw UsageFault("--threads expects a number");
  const std::string text = joined ? option->substr(std::string_view("--threads=").size()) : *(option + 1);
  words.erase(option, option + (joined ? 1 : 2));
  const std::optional<unsigned> threads = threads_of(text);
  if (!threads) throw UsageFault("--threads: " + expected_threads(text));
  return threads;
}

/// Throws UsageFault for an option that is misspelt; other unknown ones are the checker's to refuse.
void refuse_misspelt(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const OptionHelp& option : check_page().options) names.insert(names.end(), option.names.begin(), option.names.end());
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    if (words[i] == "--case" || words[i] == "--results") ++i;  // a file may have any name
    else if (words[i].starts_with("--") && std::find(names.begin(), names.end(), words[i]) == names.end())
      if (const std::string meant = did_you_mean(words[i], names); !meant.empty())
        throw UsageFault("unknown option " + kernels::shown(words[i]) + meant);
  }
}

ExitCode check(std::vector<std::string> words) {
  const auto asks_for_help = [&words] {
    const auto files = std::find(words.begin(), words.end(), "--");
    return std::any_of(words.begin(), files, [](const std::string& word) { return word == "--help" || word == "-h"; });
  };
  if (asks_for_help()) {
    print(help_text(check_page(), help_columns(STDOUT_FILENO)));
    return fine;
  }
  const std::optional<unsigned> threads = take_threads(words);
  refuse_misspelt(words);
  const auto files = std::find(words.begin(), words.end(), "--");
  const auto has = [&](const char* option) { return std::find(words.begin(), files, option) != files; };
  const auto proved = std::find(words.begin(), files, "--proved");
  if (proved == files) {
    Threads workers(threads.value_or(usual_threads()));
    const int code = fathom_check::command_line(words, "fathom check", nullptr, &workers);
    return std::cout ? static_cast<ExitCode>(code) : internal_error;  // fathom-check, which has no code for internal errors, returns 2
  }
  if (threads) throw UsageFault("--proved checks one certificate after the other, and cannot be combined with --threads");
  const bool compares = has("--case") || has("--results") || has("--echo"), width = has("--width");
  words.erase(proved);
  return compares ? compare_and_prove(words, width) : become_proved(words);
}

}  // namespace

ExitCode run_check(std::vector<std::string> words) try { return check(std::move(words)); } catch (const UsageFault& fault) {
  talk(std::string(fault.what()) + "\nTry: fathom check --help");
  return bad_input;
}

}  // namespace fathom::cli
