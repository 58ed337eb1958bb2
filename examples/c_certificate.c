/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A proof of an answer, from C, and what the independent checker says of it; about the same
 * bodies, and about others. */
#include <fathom/fathom.h>
#include <stdio.h>
#include <string.h>

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

int main(void) {
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

//> s VERIFIED penetrating depth_squared=3/16 optima=1 quarter
//> no: s REFUSED quarter:4: point 0 of a is not that of the case
//> no: s MALFORMED certificate:1: expected 'fathom-certificate' and a format: 1 to 5, found 'no certificate'
