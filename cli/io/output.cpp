// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "cli/io/terminal.hpp"
#include "fathom/files.hpp"
#include "fathom/monitor.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t behind_first = 2;  // spaces before the further lines of a sentence

}  // namespace

void hold_standard_streams() {
  // From the lowest: open() takes the lowest number that is free.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void print(std::string_view text) {
  const std::string line = std::string(text) + '\n';
  if (std::fwrite(line.data(), 1, line.size(), stdout) != line.size() || std::fflush(stdout) != 0)
    throw OutputError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

std::string fault_text(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  return std::string("internal error: ") + error.what();
}

std::string without_controls(std::string_view text) {
  std::string result;
  bool behind_lead = false;  // of a character of two bytes, U+0080 to U+00BF
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool second = behind_lead && byte >= 0x80 && byte < 0xa0;
    if (second) result.replace(result.size() - 1, 1, "\\xc2");
    if (second || byte < 0x20 || byte == 0x7f) result += fmt::format("\\x{:02x}", byte);
    else result += c;
    behind_lead = byte == 0xc2;
  }
  return result;
}

void talk(std::string_view text) {
  std::string line = "fathom: ";
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    line += without_controls(text.substr(begin, end - begin)) + '\n';
    begin = end + 1;
  }
  line = folded(line, seen_columns(STDERR_FILENO), behind_first);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

ExitCode failed(std::string_view sentence, ExitCode code) {
  talk(sentence);
  return code;
}

ExitCode guarded(const std::function<ExitCode()>& run) {
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
