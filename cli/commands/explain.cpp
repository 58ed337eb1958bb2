// SPDX-License-Identifier: GPL-3.0-or-later
// fathom explain A B -o PAGE.html | CASES.jsonl --case ID -o PAGE.html
// Writes one page: the answer with its patches, the stages, and how the depth changes along
// motions.

#include "cli/commands/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/text_rows.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/files/cases.hpp"
#include "view/page/page.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/scene.hpp"

namespace fathom::cli {
namespace {

std::vector<std::string> notes_on(const AboutBodies& bodies) {
  std::vector<std::string> notes;
  if (const std::string sentence = shapes::about_hulls(bodies.hull); !sentence.empty()) notes.push_back(sentence);
  if (const std::optional<std::string> sizes = shapes::sizes_note(bodies.sizes)) notes.push_back(*sizes);
  return notes;
}

/// Returns the names of the green parts of the picture: "the arrow, and where they touch then".
std::string drawn_beside(const picture::PairScene& scene) {
  const bool touching = scene.status == Status::touching;
  const std::string arrow = scene.moves() ? "the arrow" : "";
  if (scene.patches.empty() && !touching) return arrow;
  const std::string where = touching                              ? "where they touch"
                            : scene.status == Status::penetrating ? "where they touch then"
                                                                  : "where they are nearest";
  return arrow.empty() ? where : fmt::format("{}, and {}", arrow, where);
}

// ---- motions ----

constexpr std::uint32_t steps_of_twist = 40, steps_of_usual = 10;
constexpr int least_turn = -60;            // an exponent of two
constexpr std::size_t most_points = 2000;  // of both bodies together, for motions that the user did not ask for

struct NamedMotion {
  std::string name;
  Motion motion;
  std::uint32_t steps;

  /// Returns "A moves along n", "A and B move by the twists".
  [[nodiscard]] std::string sentence() const {
    const bool b_moves = motion.of_b != Twist(), a_moves = !b_moves || motion.of_a != Twist();
    return fmt::format("{} {}", !b_moves ? "A moves" : a_moves ? "A and B move" : "B moves", name);
  }
};

bool is_length(double value) { return std::isfinite(value) && value > 0; }

/// Returns the longest side of the bounding boxes of both bodies; 0 if there is none.
double longest_side(const AnsweredCase& answered) {
  double longest = 0;
  for (const auto& sides : {answered.bodies.sizes.a, answered.bodies.sizes.b})
    if (sides) longest = std::max(longest, *std::ranges::max_element(*sides));
  return longest;
}

/// Returns motions of A for illustration: along the direction, across the contact; and, if it is
/// not far from O, by half a radian about the axes through the middle of the first patch. Steps are
/// powers of two, found by exponents, because quotients of doubles could underflow or overflow.
/// Empty if no double holds the size of the bodies.
std::vector<NamedMotion> usual_motions(const AnsweredCase& answered) {
  const double side = longest_side(answered), depth = std::abs(answered.answer.low_binary64());
  const Point middle = answered.manifold->geometry.patches.front().centroid().a.core;
  const double far = std::max(side, picture::largest(middle).get_d());
  if (!is_length(side) || !is_length(far)) return {};
  const auto power = [](int exponent) { return kernels::times_power_of_two(mpq_class(1), exponent); };
  const int size = std::ilogb(side);
  const mpq_class length = power(is_length(depth) ? std::min(std::ilogb(depth) + 1, size + 2) : size - 2) *
                           (answered.answer.status() == Status::disjoint ? -1 : 1);
  const std::array<double, 3> n = rounded::nearest_unit(*answered.answer.direction());
  std::vector<NamedMotion> motions{{"along n", {{length * Point{n[0], n[1], n[2]}, {}}, {}}, steps_of_usual}};
  const mpq_class turn = power(std::max(size - std::ilogb(far) - 1, least_turn));
  const Point x{turn, 0, 0}, y{0, turn, 0}, z{0, 0, turn};
  for (const auto& [name, w] : {std::pair("about x", x), std::pair("about y", y), std::pair("about z", z)})
    motions.push_back({name, {{cross(middle, w), w}, {}}, steps_of_usual});
  return motions;
}

std::string twist_text(const Twist& twist) {
  const auto& [v, w] = twist;
  std::string text;
  for (const mpq_class* c : {&v.x, &v.y, &v.z, &w.x, &w.y, &w.z}) text += (text.empty() ? "" : ",") + exact_text(*c);
  return text;
}

/// Returns the options with which `fathom depth` computes the same steps; if B moves, which --along
/// does not support, those with which it finds the same derivative.
std::string repeated_text(const Path& path) {
  const auto& [of_a, of_b] = path.motion;
  if (of_b == Twist()) return fmt::format("--along={} --steps {}", twist_text(of_a), path.steps);
  const std::string twist_a = of_a == Twist() ? "" : fmt::format("--twist={} ", twist_text(of_a));
  return fmt::format("{}--twist-b={}", twist_a, twist_text(of_b));
}

/// Returns the section of the page on the depth while the bodies move.
page::Motions motions_of(const Case& single, const AnsweredCase& answered, const DepthRequest& request,
                         Monitor& monitor) {
  const ContactGeometry& geometry = answered.manifold->geometry;
  const auto none = [](const std::string& why) { return page::Motions{"[]", {}, why}; };
  if (geometry.no_patches == LeftOut::curved)
    return none("Of curved bodies no motion is followed here, but fathom depth --along does.");
  if (geometry.no_patches)
    return none(fmt::format("No motion is followed, as where they touch is not told: {}.", name(*geometry.no_patches)));
  const std::optional<Motion> typed = request.form.twists.in(3);
  if (!typed && single.a.points.size() + single.b.points.size() > most_points)
    return none(fmt::format("Bodies of more than {} points are followed along a motion only if --twist names it.",
                            most_points));
  const std::vector<NamedMotion> motions =
      typed ? std::vector{NamedMotion{"by the twist", *typed, steps_of_twist}} : usual_motions(answered);
  if (motions.empty())
    return none("Bodies without a length that binary64 holds are followed along a motion only if --twist names it.");
  page::Motions result;
  Json data = Json::array();
  for (const NamedMotion& motion : motions) {
    const Path path{single.id, motion.motion, motion.steps};
    const std::vector<AlongStep> steps = walked(single, path, request, monitor);
    const auto derivative = directional_derivative(geometry, motion.motion.of_a, motion.motion.of_b);
    const auto* const told = std::get_if<DirectionalDerivative>(&derivative);
    const std::optional<double> slope = told ? std::optional(round_binary64(told->value()) + 0.0) : std::nullopt;
    const std::string title = motion.name + (slope ? fmt::format(": derivative {}", *slope) : "");
    data.push_back({{"name", motion.name},
                    {"derivative", output::derivative_object(derivative)},
                    {"path", along_object(path, steps)}});
    const auto figure =
        along_figure(steps, fmt::format("motion{}", result.charts.size()), title, motion.sentence(), slope);
    result.charts.push_back({motion.sentence(), plot::figure_element(figure), repeated_text(path)});
  }
  result.json = data.text();
  result.of_b = typed && typed->of_b != Twist();
  return result;
}

}  // namespace

std::string explained_page(const AskedCase& asked, const ExplainRequest& request, Monitor& monitor) {
  Case single = asked;
  if (request.depth.inputs.size() == 2)
    single.id = picture::without_folders(single.id);  // ids of meshes are names of files
  Workspace workspace;
  AnsweredCase answered = answered_by(asked, request.depth, question_of(request.depth, monitor, workspace));
  const Answer& answer = answered.answer;
  if (!answer.complete()) throw Interrupted();
  answered.id = single.id;
  const bool plane = single.a.dimension == 2;
  AnswerForm form = request.depth.form;
  form.patch = !plane;
  if (!plane) answered.manifold = output::manifold_of(single.a, single.b, answer, form.twists.in(3), &monitor);
  const picture::PairScene scene = answer_scene(single, answered, form);
  const std::string beside = drawn_beside(scene);
  const std::string picture =
      picture::scene_panels(scene, "still", "A and B" + (beside.empty() ? "" : fmt::format(", {}", beside)));
  const std::string depth = output::answer_json(answered, form), pair = files::case_json(single);
  const std::vector<std::string> notes = notes_on(asked.bodies);
  if (const UnionDepth* const unions = std::get_if<UnionDepth>(&answer.found)) {
    stages::UnionStages stages =
        stages::stages_of(pieces_of(single.a), pieces_of(single.b), *unions, &monitor, single.a.dimension);
    stages.id = single.id;
    if (form.twists)
      stages.left_out.emplace_back("Of unions no motion is followed: the facts have the derivative alone.");
    return page::html_page({FATHOM_VERSION, depth, stages, pair, notes, picture, beside});
  }
  stages::StageOptions options = request.options;
  options.monitor = &monitor;
  stages::Stages stages =
      plane ? stages::stages_in_plane(single.a, single.b, answer) : stages::stages_of(single.a, single.b, options);
  stages.id = single.id;
  const page::Motions motions = plane ? page::Motions() : motions_of(single, answered, request.depth, monitor);
  return page::html_page({FATHOM_VERSION, depth, stages, pair, notes, picture, beside, motions, request.opens});
}

ExitCode run_explain(const Given& given) {
  ExplainRequest request(given);
  request.options.times = given.flag("--times");
  CertificateFile file(given.text("--output"), "page");  // fails early for an unwritable path
  const Case single = asked_case(request.depth, "", "", request.depth.form.twists ? "--twist is about those" : "");
  std::string page;
  {
    const InterruptGuard interrupt_guard;
    Progress progress;
    page = explained_page(looked_at(single, request.depth), request, progress);
  }
  file.write(page);
  return fine;
}

}  // namespace fathom::cli
