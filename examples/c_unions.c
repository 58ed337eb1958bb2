/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies that are not convex, from C: how far is a bar from leaving the slot of a block in the
 * shape of a U? */
#include <fathom/fathom.h>
#include <stdio.h>

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

/* A box between two corners, moved from the unit cube. */
static fathom_body* box(double x, double y, double z, double wide, double deep, double high) {
  const double cube[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  const double pose[12] = {wide, 0, 0, x, 0, deep, 0, y, 0, 0, high, z};
  fathom_body *unit, *result = NULL;
  if (fathom_body_from_points(cube, 8, &unit) != FATHOM_OK) return NULL;
  fathom_body_moved(unit, pose, &result);
  fathom_body_free(unit);
  return result;
}

static int print(const fathom_answer* answer) {
  double depth, deepest, hulls, way[3];
  size_t i, pieces[2];
  int clearance;

  if (fathom_answer_signed_depth(answer, &depth, NULL, NULL) != FATHOM_OK) return failed();
  printf("%s, depth %g\n", fathom_status_name(fathom_answer_status(answer)), depth);
  for (i = 0; i < fathom_answer_optima(answer); ++i) {
    if (fathom_answer_optimum(answer, i, NULL, way) != FATHOM_OK ||
        fathom_answer_clearance(answer, i, &clearance) != FATHOM_OK)
      return failed();
    printf("way (%g, %g, %g), %s\n", way[0], way[1], way[2], clearance ? "into a gap" : "an exact fit");
  }
  if (fathom_answer_deepest_pair(answer, &deepest, pieces) != FATHOM_OK ||
      fathom_answer_hulls(answer, &hulls) != FATHOM_OK)
    return failed();
  printf("deepest pair %g: pieces %d and %d; hulls %g\n", deepest, (int)pieces[0], (int)pieces[1], hulls);
  return 0;
}

/* Two tetrahedra, as tools for convex decomposition write them: a group for each piece. */
static int print_file(void) {
  FILE* file = fopen("c_unions.obj", "w");
  fathom_body* body;
  fathom_answer* answer;
  char* exactly;
  if (file == NULL) return 1;
  fputs("o one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\no two\nv 0 0 -1\nf 1 2 3 5\n", file);
  fclose(file);
  if (fathom_body_from_piece_files("c_unions.obj", FATHOM_BINARY64_DECIMALS, &body) != FATHOM_OK) return failed();
  remove("c_unions.obj");
  if (fathom_depth(body, body, NULL, &answer) != FATHOM_OK ||
      fathom_answer_exact(answer, FATHOM_SIGNED_DEPTH, &exactly) != FATHOM_OK)
    return failed();
  printf("two tetrahedra on themselves: %s\n", exactly);
  fathom_text_free(exactly);
  fathom_answer_free(answer);
  fathom_body_free(body);
  return 0;
}

int main(void) {
  fathom_body* pieces[3];
  fathom_body *bar, *block;
  fathom_answer* answer;
  int code, i;

  pieces[0] = box(0, 0, 0, 2, 4, 4);
  pieces[1] = box(4, 0, 0, 2, 4, 4);
  pieces[2] = box(2, 0, 0, 2, 4, 1);
  if (fathom_body_from_pieces(pieces, 3, &block) != FATHOM_OK) return failed();
  for (i = 0; i < 3; ++i) fathom_body_free(pieces[i]);
  bar = box(1, 1, 2, 2, 2, 4);
  if (fathom_depth(bar, block, NULL, &answer) != FATHOM_OK) return failed();
  code = print(answer) + print_file();

  fathom_answer_free(answer);
  fathom_body_free(block);
  fathom_body_free(bar);
  return code;
}

//> penetrating, depth 1
//> way (1, 0, 0), an exact fit
//> deepest pair 1: pieces 0 and 0; hulls 2
//> two tetrahedra on themselves: sqrt(1/2)
