/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A box that sinks into another one, from C: both are prepared once, and asked about in one pose after another. */
#include <fathom/fathom.h>
#include <stdio.h>

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

int main(void) {
  double corners[24], pose[12] = {1, 0, 0, 0.25, 0, 1, 0, 0.125, 0, 0, 1, 0};
  int i, status, closer;
  fathom_body* body;
  fathom_prepared* box;
  fathom_warm_start start = {0};

  for (i = 0; i < 24; ++i) corners[i] = i / 3 >> i % 3 & 1;
  if (fathom_body_from_points(corners, 8, &body) != FATHOM_OK) return failed();
  if (fathom_prepare(body, &box) != FATHOM_OK) return failed();
  fathom_body_free(body);

  for (i = 0; i < 3; ++i) {
    fathom_answer* answer;
    double depth;
    pose[11] = 1.25 - 0.25 * i;
    if (fathom_prepared_depth(box, pose, box, NULL, &start, NULL, &answer) != FATHOM_OK) return failed();
    if (fathom_answer_signed_depth(answer, &depth, NULL, NULL) != FATHOM_OK) return failed();
    printf("%s: %g\n", fathom_status_name(fathom_answer_status(answer)), depth);
    fathom_answer_free(answer);
  }
  if (fathom_prepared_overlap(box, pose, box, NULL, NULL, &status) != FATHOM_OK) return failed();
  if (fathom_prepared_closer_than(box, pose, box, NULL, 0.5, NULL, &closer) != FATHOM_OK) return failed();
  printf("%s, closer than 0.5: %d\n", fathom_status_name(status), closer);

  fathom_prepared_free(box);
  return 0;
}

//> disjoint: -0.25
//> touching: 0
//> penetrating: 0.25
//> penetrating, closer than 0.5: 1
