// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of `fathom`, and of `fathom-depth`: parses the arguments, runs the command, and turns errors into one sentence and an exit code.
#include <exception>
#include <string>
#include <string_view>

#include "cli/args/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/memory.hpp"
#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"

namespace {

using namespace fathom::cli;

/// Commands with a command line of their own.
bool parses_itself(std::string_view command) { return command == "check" || command == "golden"; }

ExitCode failed(const std::string& sentence, ExitCode code) {
  talk(sentence);
  return code;
}

ExitCode run(int argc, char** argv) {
  try {
    if (argc > 1 && parses_itself(argv[1])) return run_command(argv[1], {argv + 2, argv + argc});
    const Arguments arguments = parse_arguments(argc, argv);
    if (!arguments.request) {
      if (arguments.code != fine) return failed(arguments.text, arguments.code);
      print(arguments.text);
      return fine;
    }
    return run_command(*arguments.request);
  } catch (const fathom::InputError& error) {
    return failed(error.what(), bad_input);
  } catch (const fathom::Interrupted&) {
    return failed("interrupted", interrupted);
  } catch (const OutputError& error) {
    return failed(error.what(), internal_error);
  } catch (const std::exception& error) {
    return failed(fault_text(error), internal_error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  guard_memory();
  const fathom::kernels::DefaultFloatEnvironment environment;  // a shared library may have changed it; threads inherit it
  hold_standard_streams();
  install_signal_handlers();
  return run(argc, argv);
}
