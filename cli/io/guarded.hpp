// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of a whole program become one sentence and an exit code.
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <string>

#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/progress.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

/// Says the sentence and returns the code.
inline ExitCode failed(const std::string& sentence, ExitCode code) {
  talk(sentence);
  return code;
}

/// Returns what `run` returns. Does not throw.
inline ExitCode guarded(const std::function<ExitCode()>& run) {
  try {
    return run();
  } catch (const InputError& error) {
    return failed(error.what(), bad_input);
  } catch (const Interrupted&) {
    return failed("interrupted", interrupted);
  } catch (const std::filesystem::filesystem_error& error) {
    return failed(error.path1().string() + ": " + error.code().message(), bad_input);
  } catch (const OutputError& error) {
    return failed(error.what(), internal_error);
  } catch (const std::exception& error) {
    return failed(fault_text(error), internal_error);
  }
}

}  // namespace fathom::cli
