// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer holds: bodies penetrate, touch or are disjoint. An octahedron is moved into a unit
// cube. Then a computation is watched, and stopped: it has no answer.
#include <fathom/depth.hpp>
#include <fathom/monitor.hpp>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using fathom::Point;

const std::vector<Point> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

std::vector<Point> octahedron(const mpq_class& x) {
  const mpq_class half(1, 2);
  return {{x + half, half, half}, {x - half, half, half}, {x, 1, half}, {x, 0, half}, {x, half, 1}, {x, half, 0}};
}

void tell(const mpq_class& x) {
  const std::vector<Point> body = octahedron(x);
  const fathom::Depth depth = fathom::penetration_depth(body, cube);
  std::cout << "at " << x << ": " << fathom::name(depth.status());
  if (const fathom::Penetration* penetration = depth.penetration()) {
    const fathom::Optimum& first = penetration->optima.front();
    std::cout << ", depth^2 = " << penetration->squared() << ", shortest ways out: " << penetration->optima.size()
              << ", the first of kind " << fathom::name(first.contact.kind);
    std::cout << ", from corner " << depth.contact()->a.front() << " at x = " << depth.witness()->a.x
              << " to x = " << depth.witness()->b.x;
    if (const auto next = fathom::second_nearest_squared(body, cube, *penetration))
      std::cout << ", the next facet^2 = " << *next;
  } else if (const fathom::Touch* touch = depth.touch()) {
    std::cout << " in (" << touch->point.x << ", " << touch->point.y << ", " << touch->point.z << ")";
  } else {
    std::cout << ", distance^2 = " << depth.distance()->squared;
  }
  std::cout << ", signed " << fathom::signed_square(depth) << "; moved by x = " << depth.contact_translation().x
            << " they touch at x = " << depth.contact_points().b.x << "\n";
}

/// Prints the stages as they begin; stops when the last of them is reached.
class Watch : public fathom::Monitor {
 public:
  explicit Watch(std::string last) : last_(std::move(last)) {}
  void report(std::string_view stage, double) override {
    if (stage == stage_) return;
    stage_ = stage;
    std::cout << stage << "\n";
  }
  bool stopped() override { return stage_ == last_; }

 private:
  std::string stage_, last_;
};

void stop_at(const std::string& stage) {
  Watch watch(stage);
  fathom::Options options;
  options.method = fathom::Method::exact;
  options.monitor = &watch;
  try {
    fathom::penetration_depth(cube, cube, options);
  } catch (const fathom::Interrupted&) {
    std::cout << "stopped\n";
  }
}

int main() {
  tell(2);
  tell(mpq_class(3, 2));
  tell(mpq_class(5, 4));
  tell(mpq_class(1, 2));
  fathom::Options two;
  two.optima = 2;
  const fathom::Depth ties = fathom::penetration_depth(cube, cube, two);
  std::cout << "the cube in itself: " << ties.optima_count() << " ways out, " << ties.optima().size()
            << " of them listed\n";
  std::cout << (fathom::status_named("touching") == fathom::Status::touching) << "\n";  // the words can be read back
  stop_at("hulls");
}

//> at 2: disjoint, distance^2 = 1/4, signed -1/4; moved by x = -1/2 they touch at x = 1
//> at 3/2: touching in (1, 1/2, 1/2), signed 0; moved by x = 0 they touch at x = 1
//> at 5/4: penetrating, depth^2 = 1/16, shortest ways out: 1, the first of kind vertex-facet, from corner 1 at x = 3/4 to x = 1, the next facet^2 = 9/32, signed 1/16; moved by x = 1/4 they touch at x = 1
//> at 1/2: penetrating, depth^2 = 1, shortest ways out: 6, the first of kind vertex-facet, from corner 0 at x = 1 to x = 0, the next facet^2 = 9/8, signed 1; moved by x = -1 they touch at x = 0
//> the cube in itself: 6 ways out, 2 of them listed
//> 1
//> hulls
//> stopped
