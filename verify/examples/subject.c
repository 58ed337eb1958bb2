// SPDX-License-Identifier: Apache-2.0
// A subject in about forty lines of C: tries the directions across every two differences of points,
// and keeps the least way out. Any direction shows a way out, so it is never too shallow but for
// rounding. See verify/PROTOCOL.md.
//
// cc -O2 subject.c -lm
#define _GNU_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double point[2][1000][3], way[3], depth;  // of A and B; the best direction, and how far along it A must go
static int count[2];

static void read_body(int body, char* at) {
  at = strstr(at, "[[") + 1;
  for (count[body] = 0; *at == '[' && count[body] < 1000; at += at[1] == ',' ? 2 : 1, ++count[body])
    for (int i = 0; i < 3; ++i) point[body][count[body]][i] = strtod(at + 1, &at);
}

static void try_across(const double* p, const double* q, const double* r, const double* s) {
  const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]}, e[3] = {r[0] - s[0], r[1] - s[1], r[2] - s[2]};
  double u[3] = {d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]}, most_b = -INFINITY,
         least_a = INFINITY;
  const double length = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  for (int i = 0; i < 3; ++i) u[i] /= length;
  for (int k = 0; k < count[0]; ++k)
    least_a = fmin(least_a, u[0] * point[0][k][0] + u[1] * point[0][k][1] + u[2] * point[0][k][2]);
  for (int k = 0; k < count[1]; ++k)
    most_b = fmax(most_b, u[0] * point[1][k][0] + u[1] * point[1][k][1] + u[2] * point[1][k][2]);
  if (length > 0 && most_b - least_a < depth) depth = most_b - least_a, memcpy(way, u, sizeof way);
}

int main(void) {
  char* line = NULL;
  size_t size = 0;
  while (getline(&line, &size, stdin) > 0 && !strstr(line, "\"stop\"")) {
    if (strstr(line, "\"type\":\"run\"")) {
      read_body(0, strstr(line, "\"a\":")), read_body(1, strstr(line, "\"b\":")), depth = INFINITY;
      for (int kind = 0; kind < 3; ++kind)  // both differences of A; both of B; one of each
        for (int i = 0, one = kind == 1, other = kind > 0; i < count[one]; ++i)
          for (int j = 0; j < count[one]; ++j)
            for (int k = 0; k < count[other]; ++k)
              for (int l = 0; l < count[other]; ++l)
                try_across(point[one][i], point[one][j], point[other][k], point[other][l]);
      printf("{\"type\":\"reply\",\"id\":%ld,\"overlap\":%s,\"depth\":%.17g,\"direction\":[%.17g,%.17g,%.17g]}\n",
             strtol(strstr(line, "\"id\":\"") + 6, NULL, 10), depth > 0 ? "true" : "false", fmax(depth, 0), way[0],
             way[1], way[2]);
    } else {
      puts(
          "{\"type\":\"hello\",\"protocol\":\"fathom/subject/"
          "1\",\"name\":\"example-c\",\"version\":\"1\",\"precision\":\"binary64\","
          "\"conventions\":{\"touching\":\"either\",\"depth\":\"positive\",\"moves\":\"a\",\"unit\":true}}");
    }
    fflush(stdout);
  }
}
