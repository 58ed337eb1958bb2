// SPDX-License-Identifier: GPL-3.0-or-later
// The part of union_output.hpp that draws.
#include <fmt/format.h>

#include <vector>

#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/text_rows.hpp"
#include "cli/output/union_output.hpp"
#include "view/picture/scene_picture.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_contacts = 3;  // lines of text

std::string legend(const picture::PairScene& scene) {
  const std::string bodies = "A toned, B hatched; thin: the edges of pieces, hidden ones dashed; deeper: the pieces ";
  if (scene.status == Status::disjoint)
    return bodies + "that are nearest; arrow: the way of A until it touches B, and its outline there, dashed.";
  if (!scene.moves()) return bodies + "that touch; the dot: one of the places where they do.";
  return bodies +
         "that touch after the way out; arrow: the shortest way of A out of B, and its outline there, dashed; thick: the faces in contact.";
}

void add_contacts(std::vector<std::string>& caption, const std::vector<PieceContact>& contacts) {
  for (std::size_t i = 0; i < std::min(contacts.size(), most_contacts); ++i) {
    const PieceContact& c = contacts[i];
    caption.push_back(fmt::format("piece {} of A touches piece {} of B: {}", c.a, c.b, contact_text(c.contact)));
  }
  if (contacts.size() > most_contacts) caption.push_back(fmt::format("and {} more pairs of pieces touch", contacts.size() - most_contacts));
}

}  // namespace

std::string union_picture(const UnionAnswer& answer, const Pieces& a, const Pieces& b, const Request& request) {
  const UnionDepth& depth = answer.depth;
  const picture::PairScene scene = picture::scene_of(a, b, depth);
  std::vector<std::string> caption;
  if (depth.apart) {
    const Distance& distance = depth.apart->distance;
    caption.push_back("disjoint: distance " + root_text(distance.squared));
    caption.push_back(fmt::format("A to B: {}, between piece {} of A and piece {} of B", place_text(distance.translation, request.exact),
                                  depth.apart->a, depth.apart->b));
  } else {
    const UnionOptimum& first = depth.optima.front();
    caption.push_back(fmt::format("{}: depth {}", name(depth.status), root_text(depth.low)));
    if (scene.moves()) {
      const std::string ties = depth.optima.size() > 1 ? fmt::format("; {} ways are as short", depth.optima.size()) : "";
      caption.push_back("translation of A: " + place_text(first.translation, request.exact) + ties +
                        (first.clearance ? "" : "; an exact fit, without clearance"));
    }
    add_contacts(caption, first.contacts);
  }
  if (depth.bounds && depth.status == Status::penetrating)
    caption.push_back(fmt::format("deepest pair: {}, piece {} of A and piece {} of B; hulls: {}", root_text(depth.bounds->deepest_pair),
                                  depth.bounds->a, depth.bounds->b, root_text(depth.bounds->hulls)));
  if (const std::string dents = shapes::dents_text(answer.bodies.hull); !dents.empty()) caption.push_back(dents);
  caption.push_back(legend(scene));
  return picture::scene_document(scene, answer.id, caption);
}

}  // namespace fathom::cli
