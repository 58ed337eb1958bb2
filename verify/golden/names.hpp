// SPDX-License-Identifier: GPL-3.0-or-later
// The words that stand for values in a record.
#pragma once

#include <string_view>

#include "reference/depth/depth.hpp"
#include "verify/golden/recipe.hpp"

namespace fathom::golden {

constexpr std::string_view name_of(Status status) {
  switch (status) {
    case Status::penetrating: return "penetrating";
    case Status::touching: return "touching";
    case Status::disjoint: break;
  }
  return "disjoint";
}

constexpr std::string_view name_of(Form form) {
  switch (form) {
    case Form::given: return "given";
    case Form::binary64: return "binary64";
    case Form::binary32: break;
  }
  return "binary32";
}

constexpr std::string_view name_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::facet_vertex: return "facet-vertex";
    case ContactKind::vertex_facet: return "vertex-facet";
    case ContactKind::facet_edge: return "facet-edge";
    case ContactKind::edge_facet: return "edge-facet";
    case ContactKind::facet_facet: return "facet-facet";
    case ContactKind::edge_edge: break;
  }
  return "edge-edge";
}

}  // namespace fathom::golden
