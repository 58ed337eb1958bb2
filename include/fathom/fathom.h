/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file
 * fathom for C, and for every language that can call C: the exact penetration depth of two bodies,
 * convex ones or unions of convex pieces, certificates and their checker, and the judge of other
 * implementations. C99 and C++; the library is libfathom-c.so.1.
 *
 * Bodies and answers are handles: they are made by one function, never change after that, may be
 * used by many threads at once, and end with fathom_body_free or fathom_answer_free. An answer does
 * not need the bodies that it is about.
 *
 * A function that can fail returns FATHOM_OK or another of these codes, and then fathom_last_error
 * says why. What it was to make is NULL after a failure, numbers are left as they were. A null
 * pointer where something is needed is answered with FATHOM_BAD_INPUT. No exception leaves the
 * library, it prints nothing, and it may be called in any floating-point environment, which is the
 * caller's again afterwards. Texts are UTF-8 and end with a zero; those that a function makes end
 * with fathom_text_free.
 *
 * Every symbol has the version FATHOM_1, within which no function and no struct changes. New
 * functions may join them.
 *
 * All doubles that come out are correctly rounded to nearest, unless something else is said.
 */
#ifndef FATHOM_FATHOM_H
#define FATHOM_FATHOM_H

#include <stddef.h>

#if defined(__GNUC__)
#define FATHOM_API __attribute__((visibility("default")))
#else
#define FATHOM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- codes, messages, texts ---- */

/** What functions return. */
enum {
  FATHOM_OK = 0,
  FATHOM_BAD_INPUT = 1,     /**< an argument, a text or a file is not what was expected */
  FATHOM_OUT_OF_MEMORY = 2, /**< memory that GMP cannot get ends the process, as in every program that uses GMP */
  FATHOM_INTERNAL = 3,      /**< a fault of fathom: please report it */
  FATHOM_INTERRUPTED = 4,   /**< fathom_options::stop said so */
  FATHOM_ABSENT = 5         /**< the answer has no such part, as a translation where only bounds are known */
};

/** The version of the library, as "0.1.0". */
FATHOM_API const char* fathom_version(void);

/** Why the last function that this thread called failed, as one sentence: "cube.off:12: expected a
 * vertex index below 8, found '9'". Empty after FATHOM_OK. It stands until this thread calls the
 * next function that returns a code. Never NULL; at most 1023 bytes. */
FATHOM_API const char* fathom_last_error(void);

/** Ends a text that a function has made. NULL is allowed. */
FATHOM_API void fathom_text_free(char* text);

/* ---- bodies ---- */

/** A convex body: the hull of points, or a shape that is none, as a capsule; or a union of convex
 * pieces, which need not be convex. */
typedef struct fathom_body fathom_body;

/** What a decimal in a text stands for. Integers, ratios "22/7" and hexadecimal floats are exact in
 * any case. */
enum {
  FATHOM_BINARY64_DECIMALS = 0, /**< the nearest binary64, which is what other programs read */
  FATHOM_EXACT_DECIMALS = 1     /**< its own value: 0.1 is 1/10 */
};

/** Makes the hull of `count` points, x y z x y z ..., from 1 to 2^31 of them. The doubles are taken
 * exactly, and have to be finite. */
FATHOM_API int fathom_body_from_points(const double* xyz, size_t count, fathom_body** body);

/** The same of exact numbers: 3 * count texts, each an integer, a ratio "1/3", a decimal "0.1",
 * which is 1/10, or a hexadecimal float. */
FATHOM_API int fathom_body_from_numbers(const char* const* xyz, size_t count, fathom_body** body);

/** Makes the convex polygon of `count` points of the plane, x y x y ..., as fathom_body_from_points
 * does. Bodies of the plane are asked about together, and by no function that says "of space". In
 * their answers every z is 0, and contacts are those of vertices and edges. */
FATHOM_API int fathom_body_from_plane_points(const double* xy, size_t count, fathom_body** body);

/** Makes the body of the plane that a body is whose z are all 0: points and radii stay, a sphere is
 * a circle, a half-space a half-plane. FATHOM_BAD_INPUT of other bodies. */
FATHOM_API int fathom_body_in_plane(const fathom_body* body, fathom_body** plane);

/** Makes a shape of its short form, as the command line takes it: "sphere:r=1",
 * "capsule:r=0.1,h=0.5,at=1:2:3", "box:half=1:2:3,margin=1/10"; tapered_capsule, cylinder, cone,
 * frustum, ellipsoid and halfspace too; and of the plane "plane:circle:r=1". docs/shapes.md and
 * docs/plane.md list their fields. */
FATHOM_API int fathom_body_from_shape(const char* shape, int decimals, fathom_body** body);

/** Reads the file of a mesh: OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF, or points alone; "a.glb#name"
 * is one mesh of several. Its hull is the body: whether the mesh is another one,
 * fathom_answer_dents tells. */
FATHOM_API int fathom_body_from_mesh(const char* path, int decimals, fathom_body** body);

/** What a mesh of a file stands for. */
enum {
  FATHOM_HULL = 0,   /**< its convex hull */
  FATHOM_PIECES = 1, /**< the union of the groups of its file, or of the files of a folder */
  FATHOM_SOLID = 2   /**< what it goes around, if it is closed */
};

/** Makes the body that a word of the command line stands for: a file, of a mesh or of the plane; a
 * link of a robot in URDF, "arm.urdf#hand", where the robot puts it; a shape in its short form.
 * `joints` has the values of joints, in radians and lengths, "shoulder=1/2,elbow=-0.3"; NULL for
 * none. `package_paths` are `count` folders for meshes that are named package://NAME/FILE. An angle
 * is turned by an exact rotation less than 2^-45 rad off. docs/robots.md says what is read. */
FATHOM_API int fathom_body_read(const char* input, int meshes, const char* joints, const char* const* package_paths, size_t count, int decimals, fathom_body** body);

/** Makes the union of `count` convex pieces, from 1 to 2^31, each a body: the hull of points.
 * They may overlap, abut and repeat: where two meet in a common face there is no gap. A piece
 * without interior is refused by fathom_depth, with its number, from 0. The handles of the pieces
 * stay as they are, and may end before the union does. */
FATHOM_API int fathom_body_from_pieces(fathom_body* const* pieces, size_t count, fathom_body** body);

/** Reads the union of the pieces in an OBJ file, one for each object or group with faces; or in a
 * folder, one for each mesh file there, in the natural order of names. So tools for convex
 * decomposition write them. */
FATHOM_API int fathom_body_from_piece_files(const char* path, int decimals, fathom_body** body);

/** Makes a mesh of the points of a body, the hull of points, and `count` triangles, from 1 to 2^31,
 * each of them three indices of points, counter-clockwise from outside. Alone it stands for its
 * hull, as that of a file does. FATHOM_ABSENT of a body that is not the hull of points. */
FATHOM_API int fathom_body_with_triangles(const fathom_body* points, const unsigned* corners, size_t count, fathom_body** mesh);

/** Makes the solid of a closed mesh, which need not be convex and may have cavities: what it goes
 * around, as a union of convex pieces that tile it exactly. The mesh is one of a file or of
 * fathom_body_with_triangles. One that bounds no solid, as it is open or crosses itself, is refused
 * with a sentence that names a place. */
FATHOM_API int fathom_body_solid(const fathom_body* mesh, fathom_body** solid);

/** Sets the volume of a solid: what its mesh goes around several times counts once. `exact` gets it
 * as a fraction in lowest terms. Each may be NULL. FATHOM_ABSENT of other bodies. */
FATHOM_API int fathom_body_volume(const fathom_body* solid, double* volume, char** exact);

/** Sets how many pieces a union, or a solid, is made of. FATHOM_ABSENT of other bodies. */
FATHOM_API int fathom_body_pieces(const fathom_body* body, size_t* count);

/** Makes one of them a body: the hull of its corners. FATHOM_ABSENT of bodies without pieces. */
FATHOM_API int fathom_body_piece(const fathom_body* body, size_t index, fathom_body** piece);

/** Sets how many points a body has that is the hull of points. FATHOM_ABSENT of other bodies. */
FATHOM_API int fathom_body_points(const fathom_body* body, size_t* count);

/** Sets one of them; `exact` gets its three coordinates in lowest terms, joined by blanks. Each may
 * be NULL. FATHOM_ABSENT of other bodies. */
FATHOM_API int fathom_body_point(const fathom_body* body, size_t index, double point[3], char** exact);

/** Makes both bodies of a case as JSON, schema fathom/case/1: {"a": {"vertices": [[0, 0, 0], ...]},
 * "b": {"shape": "sphere", "radius": 1}}. JSON numbers are binary64, texts exact; hulls with
 * margins, sums and triangles are given in this way, and "pieces" make a union. Both are made, or
 * none. */
FATHOM_API int fathom_bodies_from_case(const char* json, fathom_body** a, fathom_body** b);

/** Makes the body where a pose puts it, exactly: x goes to M x + t for the three rows of four
 * numbers (M | t). M need not be a rotation, but regular for shapes. The radius of a shape is a
 * length in the world, and stays. A union is moved as a whole. */
FATHOM_API int fathom_body_moved(const fathom_body* body, const double pose[12], fathom_body** moved);

/** The same of a pose as text, as the option --pose-a takes it: twelve or sixteen numbers, or
 * "xyz=1,2,3 quat=W,X,Y,Z", with xyzw=X,Y,Z,W or rpy=0,0,90deg instead of quat; of bodies of the
 * plane six numbers, or "xy=1,2 half_angle=1/3". The rotation of a quaternion is exact, whatever
 * its length. */
FATHOM_API int fathom_body_posed(const fathom_body* body, const char* pose, int decimals, fathom_body** moved);

/** Ends a body. NULL is allowed. */
FATHOM_API void fathom_body_free(fathom_body* body);

/* ---- depth ---- */

/** Where two bodies are. */
enum {
  FATHOM_PENETRATING = 0,
  FATHOM_TOUCHING = 1,
  FATHOM_DISJOINT = 2,
  FATHOM_UNDECIDED = 3 /**< of curved shapes, whose bounds leave it open */
};

/** "penetrating", "touching", "disjoint", "undecided"; NULL for other numbers. */
FATHOM_API const char* fathom_status_name(int status);

/** Asked now and then, on the thread that called the library, whether the work is to end: anything
 * but 0 ends it. It has to return. */
typedef int fathom_stop(void* caller);

/** How to find an answer. fathom_options_init sets all of it. */
typedef struct fathom_options {
  size_t size;       /**< sizeof(fathom_options), set by fathom_options_init */
  size_t optima;     /**< 0, for all: how many shortest ways out are listed at most */
  unsigned bits;     /**< 40: bounds are found to 2^-bits of the value or of the bodies' extent; at most 1000 */
  fathom_stop* stop; /**< NULL: nobody is asked */
  void* caller;      /**< what `stop` gets */
  int patches;       /**< 0; else a certificate proves contact patches too, where these can be proved */
} fathom_options;
/** Sets all members, as their comments say. */
FATHOM_API void fathom_options_init(fathom_options* options);

/** The answer about two bodies. The signed depth is their depth if they penetrate, 0 if they touch,
 * minus their distance if they are disjoint. It is exact for polytopes, unions of them, spheres and
 * capsules, everything rounded among them, and half-spaces; bounds are proved for curved shapes. */
typedef struct fathom_answer fathom_answer;

/** Finds the answer about A and B. `options` may be NULL. If a body is a union of pieces, the other
 * is one too, or the hull of points, which is one piece: A moved by t and B overlap if their
 * interiors have a common point, and a path to the shortest t for which they do not is not asked
 * for. A search about unions that `stop` ends returns FATHOM_OK, and an answer with bounds alone,
 * once these are known. */
FATHOM_API int fathom_depth(const fathom_body* a, const fathom_body* b, const fathom_options* options, fathom_answer** answer);

/** Sets where A and B are, FATHOM_PENETRATING and so on: of hulls of points without their depth.
 * `options` may be NULL; of it `bits`, `stop` and `caller` are read.
 * `proof`, unless it is NULL, gets lines of exact numbers that prove it, for hulls of points alone:
 * "common X Y Z", a point of both, unless they are disjoint; "normal X Y Z", a direction n with
 * max_b <n,b> - min_a <n,a> at most 0, unless they penetrate; of those that do "around I J ...",
 * indices of points a_I and b_J whose differences b_J - a_I have the origin in the interior of
 * their hull. */
FATHOM_API int fathom_overlap(const fathom_body* a, const fathom_body* b, const fathom_options* options, int* status, char** proof);

/** Sets whether a point of A and a point of B are less than `distance` apart, which is taken
 * exactly and has to be above 0: 1, 0, or -1 where bounds of curved shapes leave it open. The other
 * arguments are those of fathom_overlap. The proof is "points X Y Z X Y Z", such a point of A and
 * of B, or "normal X Y Z" with max_b <n,b> - min_a <n,a> <= -distance |n|. */
FATHOM_API int fathom_closer_than(const fathom_body* a, const fathom_body* b, double distance, const fathom_options* options, int* closer,
                                  char** proof);

/* Prepared bodies: many questions about the same hulls, in other poses. */

/** A body that is the hull of points, prepared once for any number of poses. It does not need that
 * body. */
typedef struct fathom_prepared fathom_prepared;

/** Prepares a body of space, which must be the hull of points. */
FATHOM_API int fathom_prepare(const fathom_body* body, fathom_prepared** prepared);

/** Where a search begins: `count` differences b - a, at most 8, of the points a[i] of A and b[i] of
 * B. Begin with all members 0, and hand it to one call after another about a pair that moves: each
 * leaves here what it has ended with. No answer depends on it. */
typedef struct fathom_warm_start {
  size_t count;  /**< of the differences */
  unsigned a[8]; /**< indices of points of A */
  unsigned b[8]; /**< indices of points of B */
} fathom_warm_start;

/** Finds the answer that fathom_depth finds about fathom_body_moved(a, pose_a) and
 * fathom_body_moved(b, pose_b), sooner. A pose may be NULL: the body stays where it is. So may
 * `start` and `options`, of which `bits` is not read. */
FATHOM_API int fathom_prepared_depth(const fathom_prepared* a, const double pose_a[12], const fathom_prepared* b, const double pose_b[12],
                                     fathom_warm_start* start, const fathom_options* options, fathom_answer** answer);

/** The same of fathom_overlap, without a proof. */
FATHOM_API int fathom_prepared_overlap(const fathom_prepared* a, const double pose_a[12], const fathom_prepared* b, const double pose_b[12],
                                       const fathom_options* options, int* status);

/** The same of fathom_closer_than, without a proof. */
FATHOM_API int fathom_prepared_closer_than(const fathom_prepared* a, const double pose_a[12], const fathom_prepared* b,
                                           const double pose_b[12], double distance, const fathom_options* options, int* closer);

/** Ends a prepared body. NULL is allowed. */
FATHOM_API void fathom_prepared_free(fathom_prepared* prepared);

/** Ends an answer. NULL is allowed. */
FATHOM_API void fathom_answer_free(fathom_answer* answer);

/** FATHOM_PENETRATING and so on; -1 for NULL. */
FATHOM_API int fathom_answer_status(const fathom_answer* answer);

/** Sets the signed depth: to nearest, NaN if bounds leave that open; and bounds, rounded outward,
 * which are equal if and only if it is known and a double. Each pointer may be NULL. */
FATHOM_API int fathom_answer_signed_depth(const fathom_answer* answer, double* nearest, double* low, double* high);

/** Sets the unit vector of the direction in which A leaves B soonest, or in which B is farthest
 * away. FATHOM_ABSENT of unions that touch.
 * */
FATHOM_API int fathom_answer_direction(const fathom_answer* answer, double direction[3]);

/** Sets the shortest translation of A after which the bodies touch: out of B if they penetrate,
 * towards it if they are disjoint. */
FATHOM_API int fathom_answer_translation(const fathom_answer* answer, double translation[3]);

/** Sets a point of A and a point of B with b - a = the translation: a pair of nearest points if the
 * bodies are disjoint. FATHOM_ABSENT of unions that are not. */
FATHOM_API int fathom_answer_witness(const fathom_answer* answer, double a[3], double b[3]);

/** How many shortest ways out are listed: 0 unless the bodies penetrate, and where only bounds are
 * known. */
FATHOM_API size_t fathom_answer_optima(const fathom_answer* answer);

/** Sets the unit vector and the translation of one of them; each may be NULL. The first is that of
 * the functions above. */
FATHOM_API int fathom_answer_optimum(const fathom_answer* answer, size_t index, double direction[3], double translation[3]);

/** Sets whether translations as near as one likes to one of these ways out leave a gap between the
 * bodies: 1, or 0 for an exact fit, as that of a key in a slot of its own width. Always 1 of convex
 * bodies. */
FATHOM_API int fathom_answer_clearance(const fathom_answer* answer, size_t index, int* clearance);

/** Of unions, sets the depth of the deepest pair of a piece of A and a piece of B, which is at most
 * that of the unions, and the numbers of the two, the first of several; 0 if no two overlap. Of a
 * search that was stopped, of those that it came to. Each pointer may be NULL. */
FATHOM_API int fathom_answer_deepest_pair(const fathom_answer* answer, double* depth, size_t pieces[2]);

/** Of unions, sets the depth of their convex hulls, which is at least that of the unions. */
FATHOM_API int fathom_answer_hulls(const fathom_answer* answer, double* depth);

/** Makes the sentence that tells which bodies, or pieces of them, are meshes that are not convex,
 * or are open: the answer is about their hulls. "A is not convex, its hull is 33 % larger, its
 * deepest point 1 inside the hull; piece 2 of B (\"lid\") is open". FATHOM_ABSENT if no such mesh
 * is known. */
FATHOM_API int fathom_answer_dents(const fathom_answer* answer, char** text);

/* Where bodies touch: found by the first of these functions, which fathom_options::stop does not
 * end. Each is FATHOM_ABSENT where it is left out, by a word: "curved", a core is neither a
 * polytope nor a half-space; "incomplete", the search was stopped; "too-large", a core against a
 * half-space is a sum of too many points. */

/** Sets how many patches there are: one after each way out that is listed; one of bodies that touch
 * or are apart; of unions one for each two pieces that touch after a way out, or that are nearest.
 * A patch is the set of all contact points: a point, a segment or a convex polygon. */
FATHOM_API int fathom_answer_patches(const fathom_answer* answer, size_t* count);

/** Sets what is known of a patch: how many corners it has, 1 of a point, 2 of a segment; the unit
 * vector along which A leaves; the length of a segment, or the area of a polygon; which way out it
 * belongs to; of unions the piece of A and the piece of B that touch, else 0 and 0. Each pointer
 * may be NULL. */
FATHOM_API int fathom_answer_patch(const fathom_answer* answer, size_t patch, size_t* corners, double direction[3], double* size,
                                   size_t* optimum, size_t pieces[2]);

/** Sets a corner of a patch, as a point of A and one of B with b - a = the translation: those of a
 * polygon are counter-clockwise seen from the tip of the direction. Each may be NULL. */
FATHOM_API int fathom_answer_patch_corner(const fathom_answer* answer, size_t patch, size_t corner, double a[3], double b[3]);

/** Sets whether the signed depth is differentiable by the poses of the bodies. FATHOM_ABSENT of
 * unions. */
FATHOM_API int fathom_answer_smooth(const fathom_answer* answer, int* smooth);

/** Sets the gradient by A's pose: while points p of A move with v' + w' x p, about the origin of
 * the world, the signed depth changes at the rate <v, v'> + <w, w'>. That by B's pose is minus it.
 * FATHOM_ABSENT unless the signed depth is smooth: the reason names what it is not for, "ties",
 * several ways out; "extended", a patch is more than a point; "cone", the cores touch and more than
 * one plane separates them. Each may be NULL. */
FATHOM_API int fathom_answer_gradient(const fathom_answer* answer, double v[3], double w[3]);

/** Sets the derivative of the signed depth while the points p of each body begin to move with v + w
 * x p, for its twist v, w; NULL for a body at rest. It is the one-sided one, whether the depth is
 * smooth or not. `exact` gets it as fathom_answer_exact does; it and `rate` may be NULL. Further
 * words where it is left out: "unlisted", not all ways out are listed; "touching", of unions;
 * "exact-fit", unions turn, and a way out has no clearance; "many-planes", unions turn, and pieces
 * that touch after a way out have more than one plane between them. Twists of bodies of the plane
 * must not leave it. */
FATHOM_API int fathom_answer_derivative(const fathom_answer* answer, const double twist_a[6], const double twist_b[6], double* rate,
                                        char** exact);

/** Makes the line of fathom_answer_json with the field "manifold", as `fathom depth --json --patch`
 * prints it, and unless both twists are NULL with "derivative", as with --twist and --twist-b.
 * Where something is left out, the fields say why. */
FATHOM_API int fathom_answer_manifold_json(const fathom_answer* answer, const char* id, const double twist_a[6], const double twist_b[6],
                                           char** text);

/** What fathom_answer_exact tells. */
enum {
  FATHOM_SIGNED_DEPTH = 0, /**< a number; "[LOW,HIGH]", two numbers, where only bounds are known */
  FATHOM_DIRECTION = 1,    /**< three integers without a common factor, not of unit length */
  FATHOM_TRANSLATION = 2,  /**< three numbers, and so are the points */
  FATHOM_WITNESS_A = 3,
  FATHOM_WITNESS_B = 4,
  FATHOM_DEEPEST_PAIR = 5, /**< of unions: the depth of the deepest pair of pieces */
  FATHOM_HULLS = 6         /**< of unions: the depth of their hulls */
};

/** Makes the text of an exact quantity: numbers in lowest terms, joined by blanks, each "3/5", or
 * "sqrt(2)", "-sqrt(1/3)", or a sum of both, "sqrt(2)-1/2". */
FATHOM_API int fathom_answer_exact(const fathom_answer* answer, int quantity, char** text);

/** Makes one line of JSON with everything that is known, schema fathom/result/2, as `fathom depth
 * --json` prints it. `id` names the case, and may be NULL. Of unions the schema is fathom/union/1.
 */
FATHOM_API int fathom_answer_json(const fathom_answer* answer, const char* id, char** text);

/** Makes a certificate: a text that proves the answer, for fathom_check_certificate and other
 * checkers. `id` and `options` may be NULL; of the options it reads `stop`, `caller` and `patches`.
 * Patches of unions are not proved, and curved shapes have none: then it is as without them.
 * FATHOM_ABSENT of a text beyond the limits of FORMAT.md, as with numbers of more than 100,000
 * digits, which every checker would refuse to read. */
FATHOM_API int fathom_answer_certificate(const fathom_answer* answer, const char* id, const fathom_options* options, char** text);

/* ---- certificates ---- */

/** What a checker finds. */
enum {
  FATHOM_VERIFIED = 0,
  FATHOM_REFUSED = 1,  /**< well written, and no proof of what it says */
  FATHOM_MALFORMED = 2 /**< no certificate */
};

/** Checks whether a text of `length` bytes, at most 2^31, is a proof, by a checker that shares
 * nothing with what makes certificates. What acceptance proves is written in FORMAT.md. With both
 * bodies, hulls of points or unions of them, it is refused too unless it is about the same points
 * in the same order; without them, NULL, it is taken on its own, as a proof about solids must be,
 * which holds their meshes. `line` gets what the checker
 * prints, "s VERIFIED penetrating depth_squared=9/25 certificate", or the line and the reason; it
 * may be NULL. FATHOM_OK says that the text was checked, not that it is a proof. */
FATHOM_API int fathom_check_certificate(const char* certificate, size_t length, const fathom_body* a, const fathom_body* b, int* outcome,
                                        char** line);

/* ---- the judge ---- */

/** Verdicts, in order of rank up to FATHOM_VERDICT_PASS; those of distances stand behind
 * FATHOM_VERDICT_TOO_SHALLOW, those of contacts behind FATHOM_VERDICT_WITNESS_OFF, and that of a
 * derivative behind these. Their numbers never change. The first five,
 * FATHOM_VERDICT_NOT_INVARIANT and FATHOM_VERDICT_UNSUPPORTED
 * come from harnesses only. VERDICTS.md defines them. */
enum {
  FATHOM_VERDICT_CRASH = 0,
  FATHOM_VERDICT_TIME_OUT = 1,
  FATHOM_VERDICT_SILENT = 2,
  FATHOM_VERDICT_GARBAGE = 3,
  FATHOM_VERDICT_FAILED = 4,
  FATHOM_VERDICT_NAN = 5,
  FATHOM_VERDICT_FALSE_SEPARATION = 6,
  FATHOM_VERDICT_FALSE_OVERLAP = 7,
  FATHOM_VERDICT_NOT_A_DIRECTION = 8,
  FATHOM_VERDICT_WRONG_SIGN = 9,
  FATHOM_VERDICT_TOO_DEEP = 10,
  FATHOM_VERDICT_TOO_SHALLOW = 11,
  FATHOM_VERDICT_NOT_SEPARATING = 12,
  FATHOM_VERDICT_INCONSISTENT = 13,
  FATHOM_VERDICT_WITNESS_OFF = 14,
  FATHOM_VERDICT_NOT_INVARIANT = 15,
  FATHOM_VERDICT_UNSUPPORTED = 16,
  FATHOM_VERDICT_TOUCHING_BY_CONVENTION = 17, /**< a pass */
  FATHOM_VERDICT_PASS = 18,
  FATHOM_VERDICT_TOO_FAR = 19, /**< of a distance */
  FATHOM_VERDICT_TOO_NEAR = 20,
  FATHOM_VERDICT_CONTACT_OUTSIDE = 21, /**< of contacts */
  FATHOM_VERDICT_CONTACT_TOO_DEEP = 22,
  FATHOM_VERDICT_CONTACT_TOO_SHALLOW = 23,
  FATHOM_VERDICT_MISSES_EXTENT = 24,
  FATHOM_VERDICT_TIPS = 25, /**< never alone */
  FATHOM_VERDICT_WRONG_DERIVATIVE = 26
};

/** The best class that a right depth is in. */
enum {
  FATHOM_NO_CLASS = -1,
  FATHOM_CORRECTLY_ROUNDED = 0,
  FATHOM_4_ULP = 1,
  FATHOM_16_U_R = 2,
  FATHOM_MILLIONTH = 3,
  FATHOM_WITHIN_TOLERANCE = 4
};

enum { FATHOM_SAME_PRECISION = -1, FATHOM_BINARY64 = 0, FATHOM_BINARY32 = 1 };
enum { FATHOM_TOUCHING_EITHER = 0, FATHOM_TOUCHING_IS_OVERLAP = 1, FATHOM_TOUCHING_IS_APART = 2 };

/** Depths that are too deep pass if they are the separating distance of their direction, where the
 * policy allows it: "the claim class and the policy" in VERDICTS.md. */
enum { FATHOM_POLICY_DECLARED = 0, FATHOM_POLICY_MINIMUM = 1, FATHOM_POLICY_SEPARATING = 2, FATHOM_POLICY_WITHIN = 3 };

/** An implementation's conventions, how wrong it may be, and its answer. fathom_claim_init sets all
 * of it: the conventions and the tolerance of the members' comments, and the answer that the bodies
 * are apart. */
typedef struct fathom_claim {
  size_t size; /**< sizeof(fathom_claim), set by fathom_claim_init */

  int precision; /**< FATHOM_BINARY64; with FATHOM_BINARY32 points are rounded first, and the numbers of shapes are taken as they are */
  int touching;  /**< FATHOM_TOUCHING_EITHER: what bodies that touch count as */
  int depth_negative; /**< 0: whether overlapping bodies have depths below 0 */
  int moves_b;        /**< 0: whether |depth| * direction moves B away, not A */
  int not_unit;       /**< 0: whether directions need not have length 1 */

  /* What rounding costs is allowed besides, see "the slack" in VERDICTS.md: of correctly rounded
   * numbers, or of numbers off by tol_ulps. */
  double tol_relative; /**< 1e-3, of the depth. Each of the three is taken as the exact value of its double; none may be negative */
  double tol_absolute; /**< 1e-6, of the longest side of the bodies' boxes */
  double tol_ulps;     /**< 0; a whole number up to 1e9 */

  int overlap;         /**< 0: whether the answer is that the bodies overlap */
  int has_depth, has_direction, has_witness_a, has_witness_b; /**< 0: whether it has them */
  double depth;        /**< of the overlap */
  double direction[3]; /**< in which a body moves apart */
  double witness_a[3], witness_b[3]; /**< b - a is the translation that moves A away */

  int answers;        /**< FATHOM_SAME_PRECISION: that of the answer's numbers, where `precision` is that of points alone */
  int separating;     /**< 0: whether a depth with a direction claims no shortest translation, but a length that separates along it */
  int policy;         /**< FATHOM_POLICY_DECLARED, that is, by `separating`: which longer translations pass */
  double policy_most; /**< 0, for FATHOM_POLICY_WITHIN: the separating distance may be (1 + policy_most) depths; not negative */
  int has_distance;   /**< 0: of bodies that are said to be apart. Direction and witness points then are those of the distance */
  double distance;    /**< at least 0 */
  size_t contact_count;            /**< 0; at most 2^31: the contacts of a manifold, read beside a depth */
  const double* contact_positions; /**< x, y, z of each: points of both bodies. They are read during the call */
  const double* contact_depths;    /**< of each, or NULL; the largest is the depth of the answer */
  int has_manifold;      /**< 0: whether the contacts reach as far as the bodies touch, by its own word; what follows is read beside it */
  size_t most_contacts;  /**< 0, for any number: how many an answer has at most; of 1, no extent is asked */
  double contact_margin; /**< 0: how much less deep than the answer contacts without a depth may be; not negative */
  int has_patch_slack;   /**< 0: whether contacts are held against the patch with a slack, not against the exact one */
  double patch_slack;    /**< that length: they are to reach all lines along which the bodies overlap by the depth less it; not negative */
  int has_derivative;    /**< 0: whether the answer tells how fast the signed depth grows as the bodies begin to move */
  double derivative;     /**< that rate, more being deeper whatever the conventions */
  double twist_a[6], twist_b[6]; /**< 0, at rest; v and w: the body's point p begins to move with the velocity v + w x p; finite */
} fathom_claim;

/** Numbers that do not exist, as the error of a depth that was not claimed, are NaN; numbers beyond
 * binary64 infinite. Pairs `low`, `high` are rounded outward: equal if and only if the number is
 * known and a double. */
typedef struct fathom_judgement {
  size_t size; /**< sizeof(fathom_judgement), set by fathom_judgement_init */

  int verdict;                                              /**< FATHOM_VERDICT_PASS and so on */
  unsigned findings;                                        /**< everything that is wrong: bit 1u << FATHOM_VERDICT_TOO_DEEP, ... */
  int accuracy;                                             /**< of a pass with a depth or a distance; else FATHOM_NO_CLASS */
  int status;                                               /**< FATHOM_PENETRATING and so on: the truth */
  double signed_depth, signed_depth_low, signed_depth_high; /**< the truth, as fathom_answer_signed_depth gives it */

  double error, error_ulps, error_relative, error_u_r; /**< claimed less true depth or distance; of bounds, the least that they allow */
  /** along the claimed direction, until a plane across it separates; below 0 where the bodies are
   * apart */
  double separating_distance_low, separating_distance_high;
  double exit_distance; /**< the shortest way along it after which the interiors are disjoint; NaN of shapes */
  double inconsistency; /**< the claimed depth less the separating distance */
  double overlap_left;  /**< exit distance less the claimed depth, if that is positive */
  double witness_a_low, witness_a_high, witness_b_low, witness_b_high; /**< distances from their bodies; 0 inside */
  double witness_gap; /**< length of (b - a) - translation; without a direction | |b - a| - depth | */

  int excess_allowed;     /**< whether the depth would be too deep, but for the policy */
  double relative_excess; /**< separating distance / depth - 1 */
  double contact_a_low, contact_a_high, contact_b_low, contact_b_high; /**< distances of the farthest contacts; 0 inside */
  double deepest; /**< the largest depth of a contact less the claimed depth */

  /* Of unions that overlap. They have no separating distance and no exit distance: overlap_left is
   * the depth after the claimed translation. */
  double deepest_pair;      /**< the depth of the deepest pair of pieces */
  size_t deepest_pieces[2]; /**< a piece of A and one of B, from 0: the first pair that has it */
  double hulls;             /**< the depth of the unions' hulls */
  double deeper_than_pair;  /**< their depth over that of the deepest pair, at least 1 */
  double deeper;            /**< their depth over the claimed one, if that is above 0 */

  /* Of contacts of hulls of points, with patch_slack: of the patch with it. */
  double extent_missed;  /**< how far its corners are from the hull of the contacts, at most */
  double extent_covered; /**< the share of its area, or length, in that hull; NaN of a point */

  /* Of a claimed derivative. NaN where the true one is not told: fathom_answer_derivative says
   * why. */
  double derivative;       /**< the true rate */
  double derivative_error; /**< the claimed rate less the true one */
} fathom_judgement;
/** Sets all members, as their comments say. */
FATHOM_API void fathom_claim_init(fathom_claim* claim);
FATHOM_API void fathom_judgement_init(fathom_judgement* judgement);

/** Judges an answer about A and B, bodies of any kinds that fathom_depth takes: of two of the plane
 * no z of the claim is read, but for twists, which must not leave it. `sentence` gets what is
 * wrong, for people: "too deep by 0.4392: 1.0392 is claimed, the depth is 0.6". It may be NULL.
 * After a failure the judgement is as fathom_judgement_init leaves it. */
FATHOM_API int fathom_judge(const fathom_body* a, const fathom_body* b, const fathom_claim* claim, fathom_judgement* judgement,
                            char** sentence);

/** "too-deep"; NULL for a number that is no verdict. */
FATHOM_API const char* fathom_verdict_name(int verdict);
/** Whether a verdict is a pass: FATHOM_VERDICT_PASS, or FATHOM_VERDICT_TOUCHING_BY_CONVENTION. */
FATHOM_API int fathom_verdict_passes(int verdict);

#ifdef __cplusplus
}
#endif

#endif
