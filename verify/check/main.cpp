// SPDX-License-Identifier: Apache-2.0
// The program fathom-check.
#include "command_line.hpp"

int main(int argc, char** argv) { return fathom_check::command_line({argv + (argc > 0 ? 1 : 0), argv + argc}, "fathom-check"); }
