// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bodies of an answer touch, and how their signed depth changes while they move.

#include <cstddef>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/c/boundary.hpp"
#include "fathom/numbers.hpp"
#include "fathom/patch.hpp"
#include "reference/output/answer_json.hpp"
#include "reference/rounded/coordinates.hpp"

namespace fathom::c {

const output::Manifold& LaterManifold::of(const fathom_answer& asked) {
  const std::lock_guard<std::mutex> alone(lock_);
  if (!found_) found_ = output::manifold_of(*asked.a, *asked.b, asked.answer, std::nullopt);
  return *found_;
}

namespace {

const output::Manifold& manifold_in(const fathom_answer* answer) {
  require(answer, "answer");
  return answer->manifold->of(*answer);
}

[[noreturn]] void refuse_left_out(LeftOut reason) { throw Absence("left out: " + std::string(name(reason))); }

const std::vector<Patch>& patches_in(const fathom_answer* answer) {
  const ContactGeometry& geometry = manifold_in(answer).geometry;
  if (geometry.no_patches) refuse_left_out(*geometry.no_patches);
  return geometry.patches;
}

const Patch& patch_in(const fathom_answer* answer, std::size_t index) {
  const std::vector<Patch>& patches = patches_in(answer);
  require_below(index, patches.size(), "patch", "patches");
  return patches[index];
}

/// Of an answer that tells whether the depth is smooth.
const output::Manifold& smoothness_in(const fathom_answer* answer) {
  const output::Manifold& manifold = manifold_in(answer);
  if (manifold.geometry.no_patches) refuse_left_out(*manifold.geometry.no_patches);
  if (!manifold.geometry.tells_smoothness()) throw Absence("of unions it is not told whether the depth is smooth");
  return manifold;
}

Gradient gradient_in(const fathom_answer* answer) {
  const ContactGeometry& geometry = smoothness_in(answer).geometry;
  if (const std::optional<Gradient> found = geometry.gradient()) return *found;
  std::string kinks;
  for (const Kink kink : geometry.kinks) kinks += (kinks.empty() ? "" : ", ") + std::string(name(kink));
  throw Absence("the signed depth is not smooth: " + kinks);
}

std::variant<DirectionalDerivative, LeftOut> derivative_in(const output::Manifold& manifold, const double* twist_a,
                                                           const double* twist_b) {
  return directional_derivative(manifold.geometry, twist_from(twist_a, "twist_a"), twist_from(twist_b, "twist_b"));
}

}  // namespace
}  // namespace fathom::c

using namespace fathom::c;

int fathom_answer_patches(const fathom_answer* answer, size_t* count) {
  return guarded([&] {
    require(count, "count");
    *count = patches_in(answer).size();
  });
}

int fathom_answer_patch(const fathom_answer* answer, size_t patch, size_t* corners, double direction[3], double* size,
                        size_t* optimum, size_t pieces[2]) {
  return guarded([&] {
    const fathom::Patch& found = patch_in(answer, patch);
    if (corners) *corners = found.corners.size();
    if (direction) copy_numbers(fathom::rounded::nearest_unit(found.direction), direction);
    if (size) *size = fathom::root_binary64(found.squared());
    if (optimum) *optimum = found.way;
    if (!pieces) return;
    pieces[0] = found.pieces.first;
    pieces[1] = found.pieces.second;
  });
}

int fathom_answer_patch_corner(const fathom_answer* answer, size_t patch, size_t corner, double a[3], double b[3]) {
  return guarded([&] {
    const fathom::Patch& found = patch_in(answer, patch);
    require_below(corner, found.corners.size(), "corner", "corners");
    if (a) copy_numbers(fathom::rounded::nearest_binary64(found.a(corner)), a);
    if (b) copy_numbers(fathom::rounded::nearest_binary64(found.b(corner)), b);
  });
}

int fathom_answer_smooth(const fathom_answer* answer, int* smooth) {
  return guarded([&] {
    require(smooth, "smooth");
    *smooth = smoothness_in(answer).geometry.smooth() ? 1 : 0;
  });
}

int fathom_answer_gradient(const fathom_answer* answer, double v[3], double w[3]) {
  return guarded([&] {
    const fathom::Gradient found = gradient_in(answer);
    if (v) copy_numbers(fathom::rounded::nearest_binary64(found.by_translation()), v);
    if (w) copy_numbers(fathom::rounded::nearest_binary64(found.by_rotation()), w);
  });
}

int fathom_answer_derivative(const fathom_answer* answer, const double twist_a[6], const double twist_b[6],
                             double* rate, char** exact) {
  if (exact) *exact = nullptr;
  return guarded([&] {
    const auto found = derivative_in(manifold_in(answer), twist_a, twist_b);
    if (const auto* const reason = std::get_if<fathom::LeftOut>(&found)) refuse_left_out(*reason);
    const fathom::Surd value = std::get<fathom::DirectionalDerivative>(found).value();
    if (exact) *exact = text_for_caller(surd_text(value));
    if (rate) *rate = fathom::round_binary64(value) + 0.0;  // a zero is no negative one
  });
}

int fathom_answer_manifold_json(const fathom_answer* answer, const char* id, const double twist_a[6],
                                const double twist_b[6], char** text) {
  return make_text(text, [&] {
    fathom::output::Manifold manifold = manifold_in(answer);
    if (twist_a || twist_b) manifold.derivative = derivative_in(manifold, twist_a, twist_b);
    return json_of(*answer, id ? id : "", std::move(manifold));
  });
}
