/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where two bodies touch, from C: the corners of the patch, and how the depth changes as one of
 * them moves. */
#include <fathom/fathom.h>
#include <stdio.h>
#include <string.h>

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

static int print_patches(const fathom_answer* answer) {
  size_t patches, corners, i, k;
  double a[3], b[3], size;

  if (fathom_answer_patches(answer, &patches) != FATHOM_OK) return failed();
  for (i = 0; i < patches; ++i) {
    if (fathom_answer_patch(answer, i, &corners, NULL, &size, NULL, NULL) != FATHOM_OK) return failed();
    printf("patch %d of size %g\n", (int)i, size);
    for (k = 0; k < corners; ++k) {
      if (fathom_answer_patch_corner(answer, i, k, a, b) != FATHOM_OK) return failed();
      printf("(%g, %g, %g) comes to (%g, %g, %g)\n", a[0], a[1], a[2], b[0], b[1], b[2]);
    }
  }
  return 0;
}

static int print_rates(const fathom_answer* answer) {
  const double falling[6] = {0, 0, -1, 0, 0, 0}, turning[6] = {0, 0, 0, 1, 0, 0};
  double v[3], w[3], rate;
  int smooth;
  char* text;

  if (fathom_answer_smooth(answer, &smooth) != FATHOM_OK) return failed();
  if (fathom_answer_gradient(answer, v, w) == FATHOM_OK)
    printf("gradient (%g, %g, %g) by v, (%g, %g, %g) by w\n", v[0], v[1], v[2], w[0], w[1], w[2]);
  else printf("%s\n", fathom_last_error());
  if (fathom_answer_derivative(answer, falling, NULL, &rate, NULL) != FATHOM_OK) return failed();
  printf("smooth: %d; falling, %g", smooth, rate);
  if (fathom_answer_derivative(answer, turning, falling, &rate, &text) != FATHOM_OK) return failed();
  printf("; turning while B falls, %g, exactly %s\n", rate, text);
  fathom_text_free(text);
  if (fathom_answer_manifold_json(answer, "shown", turning, NULL, &text) != FATHOM_OK) return failed();
  printf("as JSON %.26s\n", strstr(text, "\"manifold\""));
  fathom_text_free(text);
  return 0;
}

/* One body on a block whose top is the plane z = 0. */
static int tell(const char* shape) {
  fathom_body *a, *b;
  fathom_answer* answer;
  int code;

  if (fathom_body_from_shape(shape, FATHOM_EXACT_DECIMALS, &a) != FATHOM_OK) return failed();
  if (fathom_body_from_shape("box:half=2:2:1,at=0:0:-1", FATHOM_EXACT_DECIMALS, &b) != FATHOM_OK) return failed();
  if (fathom_depth(a, b, NULL, &answer) != FATHOM_OK) return failed();
  code = print_patches(answer) || print_rates(answer);
  fathom_answer_free(answer);
  fathom_body_free(b);
  fathom_body_free(a);
  return code;
}

int main(void) { return tell("box:half=1:2:1,at=2:0.5:0.75") || tell("sphere:r=1,at=1:0.5:0.75"); }

//> patch 0 of size 3.5
//> (1, -1.5, -0.25) comes to (1, -1.5, 0)
//> (2, -1.5, -0.25) comes to (2, -1.5, 0)
//> (2, 2, -0.25) comes to (2, 2, 0)
//> (1, 2, -0.25) comes to (1, 2, 0)
//> the signed depth is not smooth: extended
//> smooth: 0; falling, 1; turning while B falls, 0.5, exactly 1/2
//> as JSON "manifold":{"patches":[{"r
//> patch 0 of size 0
//> (1, 0.5, -0.25) comes to (1, 0.5, 0)
//> gradient (0, 0, -1) by v, (-0.5, 1, 0) by w
//> smooth: 1; falling, 1; turning while B falls, -1.5, exactly -3/2
//> as JSON "manifold":{"patches":[{"r
