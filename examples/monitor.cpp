// SPDX-License-Identifier: GPL-3.0-or-later
// Watching a long computation, and stopping it.
#include <fathom/depth.hpp>
#include <fathom/monitor.hpp>
#include <iostream>
#include <vector>

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

int main() {
  const std::vector<fathom::Point> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  Watch watch("hulls");
  fathom::Options options;
  options.method = fathom::Method::exact;
  options.monitor = &watch;
  try {
    fathom::penetration_depth(cube, cube, options);
  } catch (const fathom::Interrupted&) {
    std::cout << "stopped\n";
  }
}

//> hulls
//> stopped
