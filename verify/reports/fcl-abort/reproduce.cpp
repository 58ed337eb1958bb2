// SPDX-License-Identifier: CC0-1.0
// g++ reproduce.cpp $(pkg-config --cflags --libs fcl eigen3 ccd) -std=c++17 -o reproduce && ./reproduce
#include <fcl/fcl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

using Corners = std::vector<fcl::Vector3d>;

/// A tetrahedron, its faces counter-clockwise from outside.
fcl::Convexd tetrahedron(const Corners& p) {
  auto faces = std::make_shared<std::vector<int>>();
  const int triples[][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
  for (const auto& [i, j, k, other] : triples) {
    const bool inside = (p[j] - p[i]).cross(p[k] - p[i]).dot(p[other] - p[i]) > 0;
    faces->insert(faces->end(), {3, i, inside ? k : j, inside ? j : k});
  }
  return {std::make_shared<Corners>(p), 4, faces, true};
}

/// fcl::distance, signed, in a process of its own, as it may end that.
void signed_distance(const char* name, const fcl::CollisionGeometryd& a, const fcl::CollisionGeometryd& b,
                     double tolerance) {
  std::printf("fcl::distance, signed, %s, tolerance %g: ", name, tolerance);
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stderr);
    fcl::DistanceRequestd request(true, true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.distance_tolerance = tolerance;
    fcl::DistanceResultd result;
    fcl::distance(&a, fcl::Transform3d::Identity(), &b, fcl::Transform3d::Identity(), request, result);
    std::printf("%.6f\n", result.min_distance);
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) std::printf("the process ends by signal %d\n", WTERMSIG(status));
}

int main() {
  const fcl::Convexd a = tetrahedron({{0, 0, 0}, {1, 0, 0}, {-1, 0, 1}, {3, 0.15625, -0.8421052694320679}});
  const fcl::Convexd b =
      tetrahedron({{4, 1.46875, -1.526315689086914}, {4.5, -0.421875, -1.4210524559020996}, {0, 0, 0}, {-1, 0, 1}});
  std::printf("FCL %s: two tetrahedra; right is %.6f\n", FCL_VERSION,
              -std::sqrt(558050281477472161. / 3891353261181445025.));
  for (const double tolerance : {1e-6, 1e-4}) {
    signed_distance("A, B", a, b, tolerance);
    signed_distance("B, A", b, a, tolerance);
  }
}
