/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies from C: exact numbers, shapes, meshes, poses, cases, links of robots, the plane; and what
 * is said of those that are none. */
#include <fathom/fathom.h>
#include <stdio.h>

/* Prints the answer about two bodies, or why there is none; frees both. */
static void answer_about(fathom_body* a, fathom_body* b) {
  fathom_answer* answer = NULL;
  char *exactly = NULL, *json = NULL, *dents = NULL;
  if (fathom_depth(a, b, NULL, &answer) != FATHOM_OK ||
      fathom_answer_exact(answer, FATHOM_SIGNED_DEPTH, &exactly) != FATHOM_OK ||
      fathom_answer_json(answer, "example", &json) != FATHOM_OK) {
    printf("%s\n", fathom_last_error());
  } else {
    printf("%s, signed depth %s; all in JSON: %.27s...\n", fathom_status_name(fathom_answer_status(answer)), exactly,
           json);
  }
  if (fathom_answer_dents(answer, &dents) == FATHOM_OK) printf("about the convex hulls: %s\n", dents);
  fathom_text_free(dents);
  fathom_text_free(json);
  fathom_text_free(exactly);
  fathom_answer_free(answer);
  fathom_body_free(b);
  fathom_body_free(a);
}

int main(void) {
  const char* const triangle[9] = {"0", "0", "1/3", "1", "0", "1/3", "0", "1", "1/3"};
  const double square[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
  fathom_body *a, *b, *pill, *ball;
  FILE* file;

  /* A triangle of thirds, and a ball of radius exactly 1/10 that touches it. */
  fathom_body_from_numbers(triangle, 3, &a);
  fathom_body_from_shape("sphere:r=0.1,at=1/4:1/4:13/30", FATHOM_EXACT_DECIMALS, &b);
  answer_about(a, b);

  /* Two capsules beside each other. */
  fathom_body_from_shape("capsule:r=1/2,h=1", FATHOM_EXACT_DECIMALS, &pill);
  fathom_body_posed(pill, "xyz=1,1,0 rpy=0,0,90deg", FATHOM_EXACT_DECIMALS, &b);
  answer_about(pill, b);

  /* A mesh without a face against a shape of a case. */
  if ((file = fopen("c_bodies.off", "w")) == NULL) return 1;
  fputs("OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n", file);
  fclose(file);
  fathom_bodies_from_case(
      "{\"a\": {\"vertices\": [[0, 0, 0]]}, \"b\": {\"shape\": \"box\", \"half\": [0.25, 0.25, 0.25]}}", &a, &b);
  fathom_body_free(a);
  fathom_body_from_mesh("c_bodies.off", FATHOM_BINARY64_DECIMALS, &a);
  remove("c_bodies.off");
  answer_about(a, b);

  /* A link of a robot, where a joint puts it. */
  if ((file = fopen("c_bodies.urdf", "w")) == NULL) return 1;
  fputs(
      "<robot name='r'><link name='base'/><link name='slide'><collision><geometry><box size='2 2 2'/></geometry>"
      "</collision></link><joint name='lift' type='prismatic'><parent link='base'/><child link='slide'/>"
      "<axis xyz='0 0 1'/><limit lower='0' upper='2'/></joint></robot>",
      file);
  fclose(file);
  fathom_body_read("c_bodies.urdf#slide", FATHOM_HULL, "lift=3/2", NULL, 0, FATHOM_EXACT_DECIMALS, &a);
  remove("c_bodies.urdf");
  fathom_body_read("sphere:r=1", FATHOM_HULL, NULL, NULL, 0, FATHOM_EXACT_DECIMALS, &b);
  answer_about(a, b);

  /* Bodies of the plane: a square, and a disc that overlaps its side; the ball is one of space. */
  fathom_body_from_shape("sphere:r=1,at=7/4:0:0", FATHOM_EXACT_DECIMALS, &ball);
  fathom_body_from_plane_points(square, 4, &a);
  fathom_body_in_plane(ball, &b);
  answer_about(a, b);
  fathom_body_from_shape("plane:box:half=1:1", FATHOM_EXACT_DECIMALS, &a);
  answer_about(a, ball);

  /* What is none is NULL, and the reason is kept. */
  if (fathom_body_from_shape("sphere:r=-1", FATHOM_EXACT_DECIMALS, &a) == FATHOM_BAD_INPUT)
    printf("%s\n", fathom_last_error());
  return a == NULL ? 0 : 1;
}

//> touching, signed depth 0; all in JSON: {"schema":"fathom/result/2"...
//> disjoint, signed depth -sqrt(2)+1; all in JSON: {"schema":"fathom/result/2"...
//> penetrating, signed depth 1/4; all in JSON: {"schema":"fathom/result/2"...
//> about the convex hulls: A is open
//> penetrating, signed depth 1/2; all in JSON: {"schema":"fathom/result/2"...
//> penetrating, signed depth 1/4; all in JSON: {"schema":"fathom/result/2"...
//> a body of the plane and one of space are given: both must be of one of them
//> sphere:r=-1: the radius of a sphere is not positive: -1
