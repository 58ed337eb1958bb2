/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A closed mesh as it is, from C: what an L goes around, its convex pieces, and how far a cube
 * is from leaving its corner. */
#include <fathom/fathom.h>
#include <stdio.h>

static const double ell[36] = {0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0,
                               0, 0, 1, 2, 0, 1, 2, 1, 1, 1, 1, 1, 1, 2, 1, 0, 2, 1};
static const unsigned triangles[60] = {0,  2, 1,  0,  3,  2, 0,  4, 3, 0, 5,  4, 6,  7,  8, 6, 8, 9, 6, 9,
                                       10, 6, 10, 11, 0,  1, 7,  0, 7, 6, 1,  2, 8,  1,  8, 7, 2, 3, 9, 2,
                                       9,  8, 3,  4,  10, 3, 10, 9, 4, 5, 11, 4, 11, 10, 5, 0, 6, 5, 6, 11};

static int failed(void) {
  printf("%s\n", fathom_last_error());
  return 1;
}

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

int main(void) {
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

//> volume 3, 2 pieces
//> piece 0: (0, 0, 0) (2, 1, 0) (2, 0, 0) (0, 0, 1) (2, 0, 1) (2, 1, 1) (0, 1, 0) (0, 1, 1)
//> piece 1: (1, 1, 0) (1, 2, 0) (0, 2, 0) (1, 1, 1) (1, 2, 1) (0, 2, 1) (0, 1, 0) (0, 1, 1)
//> penetrating, depth 0.353553
//> the mesh is not closed: 3 edges have more faces on one side than on the other, such as (0, 2, 1) -> (0, 0, 1). A solid has no hole in its surface
