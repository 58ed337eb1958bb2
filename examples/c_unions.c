// SPDX-License-Identifier: GPL-3.0-or-later
/* Bodies that are not convex, from C: how far is a bar from leaving the slot of a block in the
 * shape of a U? And a closed mesh as it is: what an L goes around, its convex pieces, and how far
 * a cube is from leaving its corner. */
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

static int of_pieces(void) {
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

static const double ell[36] = {0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0,
                               0, 0, 1, 2, 0, 1, 2, 1, 1, 1, 1, 1, 1, 2, 1, 0, 2, 1};
static const unsigned triangles[60] = {0,  2, 1,  0,  3,  2, 0,  4, 3, 0, 5,  4, 6,  7,  8, 6, 8, 9, 6, 9,
                                       10, 6, 10, 11, 0,  1, 7,  0, 7, 6, 1,  2, 8,  1,  8, 7, 2, 3, 9, 2,
                                       9,  8, 3,  4,  10, 3, 10, 9, 4, 5, 11, 4, 11, 10, 5, 0, 6, 5, 6, 11};

/* The solid of so many of these triangles, or NULL. */
static fathom_body* solid_of(size_t count) {
  fathom_body *points, *mesh = NULL, *solid = NULL;
  if (fathom_body_from_points(ell, 12, &points) != FATHOM_OK) return NULL;
  if (fathom_body_with_triangles(points, triangles, count, &mesh) == FATHOM_OK) fathom_body_solid(mesh, &solid);
  fathom_body_free(mesh);
  fathom_body_free(points);
  return solid;
}

static int print_pieces(const fathom_body* solid) {
  size_t pieces, points, i, k;
  double volume, at[3];
  fathom_body* piece;
  if (fathom_body_volume(solid, &volume, NULL) != FATHOM_OK || fathom_body_pieces(solid, &pieces) != FATHOM_OK)
    return failed();
  printf("volume %g, %d pieces\n", volume, (int)pieces);
  for (i = 0; i < pieces; ++i) {
    if (fathom_body_piece(solid, i, &piece) != FATHOM_OK || fathom_body_points(piece, &points) != FATHOM_OK)
      return failed();
    printf("piece %d:", (int)i);
    for (k = 0; k < points; ++k) {
      if (fathom_body_point(piece, k, at, NULL) != FATHOM_OK) return failed();
      printf(" (%g, %g, %g)", at[0], at[1], at[2]);
    }
    printf("\n");
    fathom_body_free(piece);
  }
  return 0;
}

static int of_a_mesh(void) {
  fathom_body *solid = solid_of(20), *cube;
  fathom_answer* answer;
  double depth;
  int code;

  if (solid == NULL) return failed();
  if (fathom_body_from_shape("box:half=1:1:1,at=1.75:1.75:0.5", FATHOM_BINARY64_DECIMALS, &cube) != FATHOM_OK)
    return failed();
  if (fathom_depth(cube, solid, NULL, &answer) != FATHOM_OK) return failed();
  if (fathom_answer_signed_depth(answer, &depth, NULL, NULL) != FATHOM_OK) return failed();
  code = print_pieces(solid);
  printf("%s, depth %g\n", fathom_status_name(fathom_answer_status(answer)), depth);
  if (solid_of(19) == NULL) printf("%s\n", fathom_last_error());

  fathom_answer_free(answer);
  fathom_body_free(cube);
  fathom_body_free(solid);
  return code;
}

int main(void) { return of_pieces() != 0 || of_a_mesh() != 0; }

//> penetrating, depth 1
//> way (1, 0, 0), an exact fit
//> deepest pair 1: pieces 0 and 0; hulls 2
//> two tetrahedra on themselves: sqrt(1/2)
//> volume 3, 2 pieces
//> piece 0: (0, 0, 0) (2, 1, 0) (2, 0, 0) (0, 0, 1) (2, 0, 1) (2, 1, 1) (0, 1, 0) (0, 1, 1)
//> piece 1: (1, 1, 0) (1, 2, 0) (0, 2, 0) (1, 1, 1) (1, 2, 1) (0, 2, 1) (0, 1, 0) (0, 1, 1)
//> penetrating, depth 0.353553
//> the mesh is not closed: 3 edges have more faces on one side than on the other, such as (0, 2, 1) -> (0, 0, 1). A solid has no hole in its surface
