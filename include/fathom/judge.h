/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fathom::judge for C99 and everything that can call C: is this an answer to that pair of convex bodies, and if not, how wrong is it?
 * The definitions are those of verify/judge/VERDICTS.md. No call throws, prints or keeps anything; all of them may run at once in many threads. */
#ifndef FATHOM_JUDGE_H
#define FATHOM_JUDGE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Verdicts, in order of rank; their numbers never change. The first five, and FATHOM_NOT_INVARIANT and FATHOM_UNSUPPORTED, come from
 * harnesses only. */
enum {
  FATHOM_CRASH = 0,
  FATHOM_TIME_OUT = 1,
  FATHOM_SILENT = 2,
  FATHOM_GARBAGE = 3,
  FATHOM_FAILED = 4,
  FATHOM_NAN = 5,
  FATHOM_FALSE_SEPARATION = 6,
  FATHOM_FALSE_OVERLAP = 7,
  FATHOM_NOT_A_DIRECTION = 8,
  FATHOM_WRONG_SIGN = 9,
  FATHOM_TOO_DEEP = 10,
  FATHOM_TOO_SHALLOW = 11,
  FATHOM_NOT_SEPARATING = 12,
  FATHOM_INCONSISTENT = 13,
  FATHOM_WITNESS_OFF = 14,
  FATHOM_NOT_INVARIANT = 15,
  FATHOM_UNSUPPORTED = 16,
  FATHOM_TOUCHING_BY_CONVENTION = 17, /* a pass */
  FATHOM_PASS = 18
};

/* Where the bodies are in truth. */
enum { FATHOM_PENETRATING = 0, FATHOM_TOUCHING = 1, FATHOM_DISJOINT = 2 };

/* The best class that a right depth is in. */
enum {
  FATHOM_NO_CLASS = -1,
  FATHOM_CORRECTLY_ROUNDED = 0,
  FATHOM_4_ULP = 1,
  FATHOM_16_U_R = 2,
  FATHOM_MILLIONTH = 3,
  FATHOM_WITHIN_TOLERANCE = 4
};

enum { FATHOM_BINARY64 = 0, FATHOM_BINARY32 = 1 };
enum { FATHOM_TOUCHING_EITHER = 0, FATHOM_TOUCHING_IS_OVERLAP = 1, FATHOM_TOUCHING_IS_APART = 2 };

/* What fathom_judge returns. */
enum { FATHOM_JUDGED = 0, FATHOM_BAD_ARGUMENT = 1, FATHOM_OUT_OF_MEMORY = 2, FATHOM_FAULT = 3 };

/* Two bodies, the conventions of the implementation, how wrong it may be, and its answer. fathom_claim_init sets all of it: no points,
 * the conventions and the tolerance of the members' comments, and the answer that the bodies are apart. */
typedef struct fathom_claim {
  size_t size; /* sizeof(fathom_claim), set by fathom_claim_init */

  const double *a; /* x y z x y z ..., finite; stands for the convex hull */
  size_t a_count;  /* of points, at least 1 */
  const double *b; /* the same of the other body */
  size_t b_count;  /* of points, at least 1 */

  int precision;      /* FATHOM_BINARY64; with FATHOM_BINARY32 the points are rounded first */
  int touching;       /* FATHOM_TOUCHING_EITHER: what bodies that touch count as */
  int depth_negative; /* 0: whether overlapping bodies have depths below 0 */
  int moves_b;        /* 0: whether |depth| * direction moves B away, not A */
  int not_unit;       /* 0: whether directions need not have length 1 */

  /* What rounding costs is allowed besides, see "the slack" in VERDICTS.md: of correctly rounded numbers, or of numbers off by tol_ulps. */
  double tol_relative; /* 1e-3, of the depth. Each of the three is taken as the exact value of its double; none may be negative */
  double tol_absolute; /* 1e-6, of the longest side of the bodies' boxes */
  double tol_ulps;     /* 0; a whole number up to 1e9 */

  int overlap; /* 0: whether the answer is that the bodies overlap */
  int has_depth, has_direction, has_witness_a, has_witness_b; /* 0: whether it has them */
  double depth;                      /* of the overlap */
  double direction[3];               /* in which a body moves apart */
  double witness_a[3], witness_b[3]; /* b - a is the translation that moves A away */
} fathom_claim;

/* Numbers that do not exist, as the error of a depth that was not claimed, are NaN; numbers beyond binary64 infinite. All are correctly
 * rounded to nearest. */
typedef struct fathom_judgement {
  size_t size; /* sizeof(fathom_judgement), set by fathom_judgement_init */

  int verdict;       /* FATHOM_PASS, ... */
  unsigned findings; /* everything that is wrong: bit 1u << FATHOM_TOO_DEEP, ... */
  int accuracy;      /* of a pass with a depth; else FATHOM_NO_CLASS */
  int status;        /* the truth: FATHOM_PENETRATING, ... */
  double true_depth;    /* 0 unless penetrating */
  double true_distance; /* 0 unless disjoint */

  double error, error_ulps, error_relative, error_u_r; /* claimed less true depth */
  double price;         /* where a plane across the claimed direction separates; below 0 where the bodies are apart */
  double travel;        /* the shortest way along it after which the interiors are disjoint */
  double inconsistency; /* the claimed depth less the price */
  double overlap_left;  /* travel less the claimed depth, if that is positive */
  double witness_a_distance, witness_b_distance; /* from their bodies; 0 inside */
  double witness_gap;   /* length of (b - a) - translation; without a direction | |b - a| - depth | */
} fathom_judgement;
/* Sets all members, as the comments on the structures say. */
void fathom_claim_init(fathom_claim *claim);
void fathom_judgement_init(fathom_judgement *judgement);

/* Judges. The sentence for people is copied to `sentence`, cut to capacity - 1 bytes and a zero; it may be NULL with capacity 0.
 * Anything but FATHOM_JUDGED leaves the judgement as fathom_judgement_init does and gives a reason as the sentence. */
int fathom_judge(const fathom_claim *claim, fathom_judgement *judgement, char *sentence, size_t capacity);

/* "too-deep"; NULL for a number that is no verdict. */
const char *fathom_verdict_name(int verdict);
/* Whether a verdict is a pass: FATHOM_PASS, or FATHOM_TOUCHING_BY_CONVENTION. */
int fathom_verdict_passes(int verdict);

#ifdef __cplusplus
}
#endif

#endif
