// SPDX-License-Identifier: GPL-3.0-or-later
// The part of answer_output.hpp that draws.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/output/answer_output.hpp"
#include "cli/output/text_rows.hpp"
#include "reference/files/shape_names.hpp"
#include "view/picture/paint.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_contacts = 3;  // lines of text
constexpr std::string_view until_touching = "arrow: the way of A until it touches B, and its outline there, dashed.";
constexpr std::string_view out_of_b =
    "arrow: the shortest way of A out of B, and its outline there, dashed; thick: the faces in contact.";

/// What the parts of a picture are.
std::string legend(const picture::PairScene& scene) {
  std::string result = scene.has_edges() ? "A toned, B hatched, hidden edges dashed" : "A toned, B hatched";
  if (!scene.moves()) return result + "; the dot: where they touch.";
  return fmt::format("{}; {}", result, scene.status == Status::disjoint ? until_touching : out_of_b);
}

std::string legend_of_unions(const picture::PairScene& scene) {
  const std::string bodies =
      "A toned, B hatched; thin: the edges of pieces, hidden ones dashed; deeper: the pieces that ";
  if (!scene.moves() && scene.status != Status::disjoint)
    return bodies + "touch; the dot: one of the places where they do.";
  return scene.status == Status::disjoint ? fmt::format("{}are nearest; {}", bodies, until_touching)
                                          : fmt::format("{}touch after the way out; {}", bodies, out_of_b);
}

std::string ways_text(std::size_t count) { return count > 1 ? fmt::format("; {} ways are as short", count) : ""; }

void add_answer(std::vector<std::string>& caption, const picture::PairScene& scene, const Depth& depth,
                const AnswerForm& form) {
  if (const Distance* distance = depth.distance()) {
    caption.push_back("disjoint: distance " + root_text(distance->squared));
    caption.push_back("A to B: " + place_text(distance->translation, form.exact));
  } else {
    caption.push_back(fmt::format("{}: depth {}", name(depth.status()), root_text(depth.squared())));
    if (scene.moves())
      caption.push_back("translation of A: " + place_text(depth.translation(), form.exact) +
                        ways_text(depth.optima_count()));
  }
  if (depth.contact()) caption.push_back("contact: " + contact_text(*depth.contact()));
}

void add_answer(std::vector<std::string>& caption, const picture::PairScene& scene, const SignedDepth& depth,
                const AnswerForm& form) {
  caption.push_back(shape_length_text(depth));
  const std::vector<AlongNormal> ways = depth.translations();
  if (!ways.empty() && scene.moves())
    caption.push_back((depth.status() == Status::disjoint ? "A to B: " : "translation of A: ") +
                      place_text(ways.front(), form.exact) +
                      (has_continuum(depth) ? "; a continuum of ways is as short" : ways_text(ways.size())));
  if (depth.contact()) caption.push_back("contact: " + contact_text(*depth.contact()));
}

void add_contacts(std::vector<std::string>& caption, const std::vector<PieceContact>& contacts) {
  for (std::size_t i = 0; i < std::min(contacts.size(), most_contacts); ++i) {
    const PieceContact& c = contacts[i];
    caption.push_back(fmt::format("piece {} of A touches piece {} of B: {}", c.a, c.b, contact_text(c.contact)));
  }
  if (contacts.size() > most_contacts)
    caption.push_back(fmt::format("and {} more pairs of pieces touch", contacts.size() - most_contacts));
}

void add_answer(std::vector<std::string>& caption, const picture::PairScene& scene, const UnionDepth& depth,
                const AnswerForm& form) {
  if (depth.apart) {
    const Distance& distance = depth.apart->distance;
    caption.push_back("disjoint: distance " + root_text(distance.squared));
    caption.push_back(fmt::format("A to B: {}, between piece {} of A and piece {} of B",
                                  place_text(distance.translation, form.exact), depth.apart->a, depth.apart->b));
  } else {
    const UnionOptimum& first = depth.optima.front();
    caption.push_back(fmt::format("{}: depth {}", name(depth.status), root_text(depth.low)));
    if (scene.moves()) {
      caption.push_back("translation of A: " + place_text(first.translation, form.exact) +
                        ways_text(depth.optima.size()) + (first.clearance ? "" : "; an exact fit, without clearance"));
    }
    add_contacts(caption, first.contacts);
  }
  if (depth.bounds && depth.status == Status::penetrating)
    caption.push_back(fmt::format("deepest pair: {}, piece {} of A and piece {} of B; hulls: {}",
                                  root_text(depth.bounds->deepest_pair), depth.bounds->a, depth.bounds->b,
                                  root_text(depth.bounds->hulls)));
}

}  // namespace

picture::PairScene answer_scene(const Case& bodies, const Answer& answer) {
  if (const Depth* const depth = std::get_if<Depth>(&answer.found))
    return picture::scene_of({bodies.a.points, bodies.b.points, *depth});
  if (const SignedDepth* const shapes = std::get_if<SignedDepth>(&answer.found))
    return picture::scene_of(files::shape_of(bodies.a), files::shape_of(bodies.b), *shapes);
  return picture::scene_of(pieces_of(bodies.a), pieces_of(bodies.b), std::get<UnionDepth>(answer.found));
}

std::string answer_picture(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form) {
  const picture::PairScene scene = answer_scene(bodies, answered.answer);
  std::vector<std::string> caption;
  std::visit([&](const auto& found) { add_answer(caption, scene, found, form); }, answered.answer.found);
  const bool unions = std::holds_alternative<UnionDepth>(answered.answer.found);
  if (!unions) caption.push_back("sizes: " + shapes::sizes_text(answered.bodies.sizes));
  if (const std::string dents = shapes::dents_text(answered.bodies.hull); !dents.empty()) caption.push_back(dents);
  caption.push_back(unions ? legend_of_unions(scene) : legend(scene));
  return picture::scene_document(scene, answered.id, caption);
}

}  // namespace fathom::cli
