// SPDX-License-Identifier: CC0-1.0
// g++ reproduce.cpp $(pkg-config --cflags --libs ccd) -o reproduce && ./reproduce
#include <ccd/ccd.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

struct Ball {
  ccd_vec3_t centre;
  double radius;
};

// As in libccd's own test suite.
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Ball* ball = static_cast<const Ball*>(object);
  ccdVec3Copy(point, direction);
  ccdVec3Scale(point, ball->radius / std::sqrt(ccdVec3Len2(direction)));
  ccdVec3Add(point, &ball->centre);
}

void centre(const void* object, ccd_vec3_t* point) { ccdVec3Copy(point, &static_cast<const Ball*>(object)->centre); }

int main() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  std::puts("libccd: two spheres of radius 1, the second moved");
  const double shifts[][3] = {{0.5, 0.5, 0.5}, {0.3, 0.2, 0.1}, {0, 0, 1}, {1.5, 0, 0}};
  for (const auto& s : shifts) {
    const Ball a{{{0, 0, 0}}, 1}, b{{{s[0], s[1], s[2]}}, 1};
    const double right = 2 - std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    std::printf("shift (%g %g %g): right is %.4f deep\n", s[0], s[1], s[2], right);
    for (const double tolerance : {1e-4, 1e-2}) {
      ccd.epa_tolerance = tolerance;
      ccd_real_t depth = -1;
      ccd_vec3_t direction, position;
      const bool meet = ccdGJKPenetration(&a, &b, &ccd, &depth, &direction, &position) == 0;
      std::printf("  ccdGJKPenetration, tolerance %g: ", tolerance);
      if (meet) std::printf("depth %.4f\n", depth);
      else std::puts("apart");
    }
    ccd_real_t depth = -1;
    ccd_vec3_t direction, position;
    ccdMPRPenetration(&a, &b, &ccd, &depth, &direction, &position);
    std::printf("  ccdMPRPenetration: depth %.4f\n", depth);
  }
}
