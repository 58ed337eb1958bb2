/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies of the plane from C: a square, and a disc that overlaps its side. */
#include <fathom/fathom.h>
#include <stdio.h>

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

int main(void) {
  const double corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
  double direction[3], way[3];
  char* depth;
  fathom_body *square, *ball, *disc;
  fathom_answer* answer;

  if (fathom_body_from_plane_points(corners, 4, &square) != FATHOM_OK) return failed();
  if (fathom_body_from_shape("sphere:r=1,at=7/4:0:0", FATHOM_EXACT_DECIMALS, &ball) != FATHOM_OK) return failed();
  if (fathom_body_in_plane(ball, &disc) != FATHOM_OK) return failed();

  if (fathom_depth(square, disc, NULL, &answer) != FATHOM_OK) return failed();
  if (fathom_answer_exact(answer, FATHOM_SIGNED_DEPTH, &depth) != FATHOM_OK) return failed();
  if (fathom_answer_optimum(answer, 0, direction, way) != FATHOM_OK) return failed();
  printf("%s: %s, along %g %g, by %g %g\n", fathom_status_name(fathom_answer_status(answer)), depth, direction[0],
         direction[1], way[0], way[1]);
  fathom_answer_free(answer);
  fathom_text_free(depth);

  /* The ball is one of space. */
  if (fathom_depth(square, ball, NULL, &answer) == FATHOM_BAD_INPUT) printf("%s\n", fathom_last_error());

  fathom_body_free(disc);
  fathom_body_free(ball);
  fathom_body_free(square);
  return 0;
}

//> penetrating: 1/4, along -1 0, by -0.25 0
//> a body of the plane and one of space are given: both must be of one of them
