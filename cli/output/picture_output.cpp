// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/picture_output.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/text_rows.hpp"
#include "reference/files/shape_names.hpp"
#include "view/picture/scene_picture.hpp"

namespace fathom::cli {
namespace {

/// What the parts of a picture are.
std::string legend(const picture::PairScene& scene) {
  std::string result = scene.has_edges() ? "A toned, B hatched, hidden edges dashed" : "A toned, B hatched";
  if (!scene.moves()) return result + "; the dot: where they touch.";
  if (scene.status == Status::disjoint) return result + "; arrow: the way of A until it touches B, and its outline there, dashed.";
  return result + "; arrow: the shortest way of A out of B, and its outline there, dashed; thick: the faces in contact.";
}

std::string ways_text(std::size_t count) { return count > 1 ? fmt::format("; {} ways are as short", count) : ""; }

/// The lines that every picture has after its answer.
void add_common(std::vector<std::string>& caption, const AboutBodies& bodies, const picture::PairScene& scene) {
  caption.push_back("sizes: " + shapes::sizes_text(bodies.sizes));
  if (const std::string dents = shapes::dents_text(bodies.hull); !dents.empty()) caption.push_back(dents);
  caption.push_back(legend(scene));
}

}  // namespace

std::string picture_text(const Case& bodies, const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  const picture::PairScene scene = picture::scene_of({bodies.a.points, bodies.b.points, depth});
  std::vector<std::string> caption;
  if (const Distance* distance = depth.distance()) {
    caption.push_back("disjoint: distance " + root_text(distance->squared));
    caption.push_back("A to B: " + place_text(distance->translation, request.exact));
  } else {
    caption.push_back(fmt::format("{}: depth {}", name(depth.status()), root_text(depth.squared())));
    if (scene.moves())
      caption.push_back("translation of A: " + place_text(depth.translation(), request.exact) + ways_text(depth.optima_count()));
  }
  if (depth.contact()) caption.push_back("contact: " + contact_text(*depth.contact()));
  add_common(caption, answer.bodies, scene);
  return picture::scene_document(scene, answer.id, caption);
}

std::string picture_text(const Case& bodies, const ShapeAnswer& answer, const Request& request) {
  const SignedDepth& depth = answer.depth;
  const picture::PairScene scene = picture::scene_of(files::shape_of(bodies.a), files::shape_of(bodies.b), depth);
  std::vector<std::string> caption{shape_length_text(depth)};
  const std::vector<AlongNormal> ways = depth.translations();
  if (!ways.empty() && scene.moves())
    caption.push_back((depth.status() == Status::disjoint ? "A to B: " : "translation of A: ") + place_text(ways.front(), request.exact) +
                      (has_continuum(depth) ? "; a continuum of ways is as short" : ways_text(ways.size())));
  if (depth.contact()) caption.push_back("contact: " + contact_text(*depth.contact()));
  add_common(caption, answer.bodies, scene);
  return picture::scene_document(scene, answer.id, caption);
}

}  // namespace fathom::cli
