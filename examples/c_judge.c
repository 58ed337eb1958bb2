/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A wrong answer judged, from C: unit cubes, the second moved by 0.4. */
#include <fathom/fathom.h>
#include <stdio.h>

static fathom_body* cube(double x) {
  double points[24];
  fathom_body* body;
  int i;
  for (i = 0; i < 8; ++i) {
    points[3 * i] = x + (i & 1);
    points[3 * i + 1] = (i >> 1) & 1;
    points[3 * i + 2] = (i >> 2) & 1;
  }
  fathom_body_from_points(points, 8, &body);
  return body;
}

int main(void) {
  fathom_body *a = cube(0), *b = cube(0.4);
  fathom_claim claim;
  fathom_judgement judgement;
  char* sentence;
  int code;

  fathom_claim_init(&claim);
  claim.overlap = 1;
  claim.has_depth = 1;
  claim.depth = 1.0392;

  fathom_judgement_init(&judgement);
  code = fathom_judge(a, b, &claim, &judgement, &sentence);
  if (code == FATHOM_OK) printf("%s: %s\n", fathom_verdict_name(judgement.verdict), sentence);

  fathom_text_free(sentence);
  fathom_body_free(b);
  fathom_body_free(a);
  return code != FATHOM_OK || fathom_verdict_passes(judgement.verdict); /* it does not */
}

//> too-deep: too deep by 0.4392: 1.0392 is claimed, the depth is 0.6
