/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <fathom/fathom.h>
#include <stdio.h>

int main(void) {
  puts(fathom_version());
  return 0;
}
