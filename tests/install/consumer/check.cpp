// SPDX-License-Identifier: GPL-3.0-or-later
#include <fathom/check.hpp>

int main() { return fathom_check::verify("no certificate").accepted() ? 1 : 0; }
