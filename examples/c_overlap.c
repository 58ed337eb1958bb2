/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether two boxes overlap, and whether they are closer than a distance, from C: with the
 * numbers that prove it. Then one sinks into the other: prepared once, they are asked about in
 * one pose after another. */
#include <fathom/fathom.h>
#include <stdio.h>

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

int main(void) {
  double corners[24];
  const double pose[12] = {1, 0, 0, 1.5, 0, 1, 0, 0, 0, 0, 1, 0};
  double sinking[12] = {1, 0, 0, 0.25, 0, 1, 0, 0.125, 0, 0, 1, 0};
  int i, status, closer;
  char* proof;
  fathom_body *a, *b;
  fathom_prepared* box;
  fathom_warm_start start = {0};

  for (i = 0; i < 24; ++i) corners[i] = i / 3 >> i % 3 & 1;
  if (fathom_body_from_points(corners, 8, &a) != FATHOM_OK) return failed();
  if (fathom_body_moved(a, pose, &b) != FATHOM_OK) return failed();

  if (fathom_overlap(a, b, NULL, &status, &proof) != FATHOM_OK) return failed();
  printf("%s: %s", fathom_status_name(status), proof);
  fathom_text_free(proof);
  if (fathom_closer_than(a, b, 0.5, NULL, &closer, &proof) != FATHOM_OK) return failed();
  printf("closer than 0.5: %d: %s", closer, proof);
  fathom_text_free(proof);
  if (fathom_closer_than(a, b, 0.75, NULL, &closer, NULL) != FATHOM_OK) return failed();
  printf("closer than 0.75: %d\n", closer);

  fathom_body_free(b);
  if (fathom_prepare(a, &box) != FATHOM_OK) return failed();
  fathom_body_free(a);
  for (i = 0; i < 3; ++i) {
    fathom_answer* answer;
    double depth;
    sinking[11] = 1.25 - 0.25 * i;
    if (fathom_prepared_depth(box, sinking, box, NULL, &start, NULL, &answer) != FATHOM_OK) return failed();
    if (fathom_answer_signed_depth(answer, &depth, NULL, NULL) != FATHOM_OK) return failed();
    printf("%s: %g\n", fathom_status_name(fathom_answer_status(answer)), depth);
    fathom_answer_free(answer);
  }
  if (fathom_prepared_overlap(box, sinking, box, NULL, NULL, &status) != FATHOM_OK) return failed();
  if (fathom_prepared_closer_than(box, sinking, box, NULL, 0.5, NULL, &closer) != FATHOM_OK) return failed();
  printf("%s, closer than 0.5: %d\n", fathom_status_name(status), closer);

  fathom_prepared_free(box);
  return 0;
}

//> disjoint: normal -1 0 0
//> closer than 0.5: 0: normal -1 0 0
//> closer than 0.75: 1
//> disjoint: -0.25
//> touching: 0
//> penetrating: 0.25
//> penetrating, closer than 0.5: 1
