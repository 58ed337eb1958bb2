/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A C program that has a wrong answer judged: unit cubes, the second moved by 0.4. */
#include <fathom/judge.h>
#include <stdio.h>

static void cube(double x, double points[24]) {
  int i;
  for (i = 0; i < 8; ++i) {
    points[3 * i] = x + (i & 1);
    points[3 * i + 1] = (i >> 1) & 1;
    points[3 * i + 2] = (i >> 2) & 1;
  }
}

int main(void) {
  double a[24], b[24];
  char sentence[1000];
  fathom_claim claim;
  fathom_judgement judgement;
  cube(0, a);
  cube(0.4, b);
  fathom_claim_init(&claim);
  fathom_judgement_init(&judgement);
  claim.a = a;
  claim.a_count = 8;
  claim.b = b;
  claim.b_count = 8;
  claim.overlap = 1;
  claim.has_depth = 1;
  claim.depth = 1.0392;
  if (fathom_judge(&claim, &judgement, sentence, sizeof sentence) != FATHOM_JUDGED) return 1;
  printf("%s: %s\n", fathom_verdict_name(judgement.verdict), sentence);
  return fathom_verdict_passes(judgement.verdict); /* it does not */
}

//> too-deep: too deep by 0.4392: 1.0392 is claimed, the depth is 0.6
