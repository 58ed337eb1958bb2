// SPDX-License-Identifier: Apache-2.0
// The program fathom-check.
#include <fcntl.h>
#include <unistd.h>

#include "run.hpp"

/// A certificate must not be opened in the place of a standard stream that is closed. What is
/// opened there instead is as unusable.
static void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char** argv) {
  hold_standard_streams();
  return fathom_check::command_line({argv + (argc > 0 ? 1 : 0), argv + argc}, "fathom-check");
}
