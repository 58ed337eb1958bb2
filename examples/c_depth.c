// SPDX-License-Identifier: GPL-3.0-or-later
/* How deep two boxes of doubles overlap, from C: the shortest way out, where they meet, and the
 * same exactly. Then a proof of an answer, and what the independent checker says of it; about the
 * same bodies, and about others. */
#include <fathom/fathom.h>
#include <stdio.h>
#include <string.h>

/* The corners of a box between two corners. */
static void box(double x, double y, double z, double side, double corners[24]) {
  int i;
  for (i = 0; i < 8; ++i) {
    corners[3 * i] = x + (i & 1 ? side : 0);
    corners[3 * i + 1] = y + (i & 2 ? side : 0);
    corners[3 * i + 2] = z + (i & 4 ? side : 0);
  }
}

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

static int print_exactly(const fathom_answer* answer) {
  char* text;
  if (fathom_answer_exact(answer, FATHOM_SIGNED_DEPTH, &text) != FATHOM_OK) return failed();
  printf("exactly %s\n", text);
  fathom_text_free(text);
  return 0;
}

static int print(const fathom_answer* answer) {
  double depth, low, high, direction[3], translation[3], on_a[3], on_b[3];
  size_t i;

  if (fathom_answer_signed_depth(answer, &depth, &low, &high) != FATHOM_OK) return failed();
  printf("%s, %.17g, between %.17g and %.17g\n", fathom_status_name(fathom_answer_status(answer)), depth, low, high);
  if (fathom_answer_direction(answer, direction) != FATHOM_OK ||
      fathom_answer_translation(answer, translation) != FATHOM_OK)
    return failed();
  printf("along (%g, %g, %g): move A by (%g, %g, %g)\n", direction[0], direction[1], direction[2], translation[0],
         translation[1], translation[2]);
  if (fathom_answer_witness(answer, on_a, on_b) != FATHOM_OK) return failed();
  printf("so that (%g, %g, %g) comes to (%g, %g, %g)\n", on_a[0], on_a[1], on_a[2], on_b[0], on_b[1], on_b[2]);
  for (i = 0; i < fathom_answer_optima(answer); ++i) {
    if (fathom_answer_optimum(answer, i, NULL, translation) != FATHOM_OK) return failed();
    printf("way %d: (%g, %g, %g)\n", (int)i, translation[0], translation[1], translation[2]);
  }
  return print_exactly(answer);
}

/* Asked now and then: a program may look at the clock, or at a button, and end the work by 1. */
static int go_on(void* caller) {
  *(int*)caller = 1;
  return 0;
}

static int boxes(void) {
  double corners[24];
  const double pose[12] = {1, 0, 0, 0.75, 0, 1, 0, 0.75, 0, 0, 1, 0.25};
  int code, asked = 0;
  fathom_options options;
  fathom_body *a, *b;
  fathom_answer* answer;

  printf("fathom %.1s\n", fathom_version());
  box(0, 0, 0, 1, corners);
  if (fathom_body_from_points(corners, 8, &a) != FATHOM_OK) return failed();
  if (fathom_body_moved(a, pose, &b) != FATHOM_OK) return failed();

  fathom_options_init(&options);
  options.stop = go_on;
  options.caller = &asked;
  if (fathom_depth(a, b, &options, &answer) != FATHOM_OK) return failed();
  code = print(answer);

  fathom_answer_free(answer);
  fathom_body_free(b);
  fathom_body_free(a);
  return code;
}

static void check(const char* certificate, const fathom_body* a, const fathom_body* b) {
  int outcome;
  char* line;
  if (fathom_check_certificate(certificate, strlen(certificate), a, b, &outcome, &line) != FATHOM_OK) {
    printf("%s\n", fathom_last_error());
    return;
  }
  printf("%s%s\n", outcome == FATHOM_VERIFIED ? "" : "no: ", line);
  fathom_text_free(line);
}

static int proof(void) {
  const double tetrahedron[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const double quarter[12] = {1, 0, 0, 0.25, 0, 1, 0, 0, 0, 0, 1, 0};
  fathom_body *a, *b;
  fathom_answer* answer;
  char* certificate;
  if (fathom_body_from_points(tetrahedron, 4, &a) != FATHOM_OK || fathom_body_moved(a, quarter, &b) != FATHOM_OK ||
      fathom_depth(a, b, NULL, &answer) != FATHOM_OK ||
      fathom_answer_certificate(answer, "quarter", NULL, &certificate) != FATHOM_OK) {
    printf("%s\n", fathom_last_error());
    return 1;
  }

  check(certificate, a, b);
  check(certificate, b, a);
  check("no certificate\n", NULL, NULL);

  fathom_text_free(certificate);
  fathom_answer_free(answer);
  fathom_body_free(b);
  fathom_body_free(a);
  return 0;
}

int main(void) { return boxes() != 0 || proof() != 0; }

//> fathom 0
//> penetrating, 0.25, between 0.25 and 0.25
//> along (-1, 0, 0): move A by (-0.25, 0, 0)
//> so that (1, 0.75, 0.5) comes to (0.75, 0.75, 0.5)
//> way 0: (-0.25, 0, 0)
//> way 1: (0, -0.25, 0)
//> exactly 1/4
//> s VERIFIED penetrating depth_squared=3/16 optima=1 quarter
//> no: s REFUSED quarter:4: point 0 of a is not that of the case
//> no: s MALFORMED certificate:1: expected 'fathom-certificate' and a format: 1 to 6, found 'no certificate'
