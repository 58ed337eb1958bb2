/* SPDX-License-Identifier: CC0-1.0 */
/* A golden case of fathom, and whether an answer to it is right. C89 and C++. It stands at the head
 * of each file that `fathom golden export --format c` writes.
 *
 * For a vector u, h(u) is the greatest <u,b> less the least <u,a>, over the points b of B and a of
 * A; its separating distance is h(u)/|u|. Moved that far along u, A lies behind a plane across u
 * and B before it. The least separating distance of all directions is the signed depth: of bodies
 * that overlap the penetration depth, of bodies that touch 0, of bodies that are apart minus their
 * distance. */
#ifndef FATHOM_GOLDEN_H
#define FATHOM_GOLDEN_H

#include <float.h>
#include <math.h>
#include <stddef.h>

#if defined(__cplusplus)
#define FATHOM_GOLDEN_FUNCTION inline
#elif defined(__GNUC__)
#define FATHOM_GOLDEN_FUNCTION static __attribute__((unused))
#else
#define FATHOM_GOLDEN_FUNCTION static
#endif

typedef enum fathom_golden_status {
  FATHOM_GOLDEN_PENETRATING,
  FATHOM_GOLDEN_TOUCHING,
  FATHOM_GOLDEN_DISJOINT
} fathom_golden_status;

/* The bodies are the convex hulls of the points. Points and directions lie one behind the other: x
 * y z x y z ..., or in the plane x y x y ... */
typedef struct fathom_golden_case {
  const char *name;
  fathom_golden_status status;
  double signed_depth;      /* correctly rounded to nearest */
  const char *squared;      /* its square, exact: "2" or "1/3"; NULL if that is longer than a C89 string may be (509 characters) */
  const char *flags;        /* what is special about the case, separated by blanks */
  double size;              /* the longest side of the bodies' boxes, correctly rounded */
  double largest;           /* the largest magnitude of a coordinate */
  const double *a;          /* exact */
  size_t a_count;           /* of points */
  const double *b;
  size_t b_count;
  const double *directions; /* unit vectors, rounded: all whose separating distance is the depth. Of bodies that touch one whose is 0; of bodies that
                             * are apart that of the distance, from B to A */
  size_t direction_count;
  /* Of cases of contacts, else NULL. For each direction: the corners, on A, of all points where the
   * bodies touch once A is moved that way, rounded, one patch behind the other; a point has one, a
   * segment two. */
  const double *corners;
  const size_t *corner_counts; /* of each of these patches */
  /* Of these, where the signed depth is smooth, else NULL: six numbers, rounded. A moves with v + w
   * x p at its points p: the first three times v and the others times w are its rate. */
  const double *gradient;
  int dimension; /* 3, or 2 of bodies of the plane */
} fathom_golden_case;

/* How wrong an answer may be: by the larger of relative * depth (or distance) and absolute * size.
 */
typedef struct fathom_golden_tolerance {
  double relative, absolute;
} fathom_golden_tolerance;

/* The greatest <u,p> of the points, which have three coordinates; in the plane two, and u has a
 * third, 0. */
FATHOM_GOLDEN_FUNCTION double fathom_golden_support(const double *points, size_t count, int dimension, const double u[3])
{
  double greatest = -HUGE_VAL;
  size_t i;
  for (i = 0; i < count; ++i) {
    const double *p = points + (size_t)dimension * i;
    const double value = u[0] * p[0] + u[1] * p[1] + (dimension == 3 ? u[2] * p[2] : 0);
    if (value > greatest) greatest = value;
  }
  return greatest;
}

/* The separating distance of a direction of any length, which has as many numbers as a point;
 * HUGE_VAL if it is zero, infinite or NaN. It is off by less than 2^-47 of the largest coordinate
 * (and 2^-1068). */
FATHOM_GOLDEN_FUNCTION double fathom_golden_separating_distance(const fathom_golden_case *golden, const double *direction)
{
  double u[3] = {0, 0, 0}, minus_u[3] = {0, 0, 0}, longest = 0;
  int i;
  for (i = 0; i < golden->dimension; ++i) {
    if (!(fabs(direction[i]) <= DBL_MAX)) return HUGE_VAL;
    if (fabs(direction[i]) > longest) longest = fabs(direction[i]);
  }
  if (longest == 0) return HUGE_VAL;
  for (i = 0; i < golden->dimension; ++i) {
    u[i] = direction[i] / longest / 8; /* an eighth, so that no sum overflows */
    minus_u[i] = -u[i];
  }
  return (fathom_golden_support(golden->b, golden->b_count, golden->dimension, u) +
          fathom_golden_support(golden->a, golden->a_count, golden->dimension, minus_u)) /
         sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

/* By how much an answer may be off: the tolerance, and what rounding costs it and the separating
 * distance. */
FATHOM_GOLDEN_FUNCTION double fathom_golden_allowance(const fathom_golden_case *golden, fathom_golden_tolerance tolerance)
{
  const double relative = tolerance.relative * fabs(golden->signed_depth), absolute = tolerance.absolute * golden->size;
  return (relative > absolute ? relative : absolute) + 32 * DBL_EPSILON * golden->largest + 64 * DBL_EPSILON * DBL_MIN;
}

/* Whether "A and B overlap by `depth`; A gets free along `direction`" is right: neither the depth
 * nor the separating distance of the direction is off by more than the allowance. Any direction
 * that is good enough is right, not only the best. A distance is a depth below 0. The direction may
 * have any length; it may be NULL if none is claimed. */
FATHOM_GOLDEN_FUNCTION int fathom_golden_accept(const fathom_golden_case *golden, const double *direction, double depth,
                                                fathom_golden_tolerance tolerance)
{
  const double allowed = fathom_golden_allowance(golden, tolerance);
  if (!(fabs(depth - golden->signed_depth) <= allowed)) return 0;
  return direction == NULL || fathom_golden_separating_distance(golden, direction) - golden->signed_depth <= allowed;
}

/* Whether "A and B do not overlap" is right, without a distance. */
FATHOM_GOLDEN_FUNCTION int fathom_golden_accept_apart(const fathom_golden_case *golden, fathom_golden_tolerance tolerance)
{
  return golden->signed_depth <= fathom_golden_allowance(golden, tolerance);
}

#endif
