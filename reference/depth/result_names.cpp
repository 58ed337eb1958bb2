// SPDX-License-Identifier: GPL-3.0-or-later
// The words of fathom/depth.hpp.
#include <stdexcept>

#include "fathom/depth.hpp"

namespace fathom {

std::string_view name(Status status) {
  switch (status) {
    case Status::penetrating: return "penetrating";
    case Status::touching: return "touching";
    case Status::disjoint: return "disjoint";
  }
  throw std::logic_error("unknown status");
}

std::string_view name(ContactKind kind) {
  switch (kind) {
    case ContactKind::facet_vertex: return "facet-vertex";
    case ContactKind::vertex_facet: return "vertex-facet";
    case ContactKind::facet_edge: return "facet-edge";
    case ContactKind::edge_facet: return "edge-facet";
    case ContactKind::facet_facet: return "facet-facet";
    case ContactKind::edge_edge: return "edge-edge";
    case ContactKind::vertex_vertex: return "vertex-vertex";
    case ContactKind::vertex_edge: return "vertex-edge";
    case ContactKind::edge_vertex: return "edge-vertex";
  }
  throw std::logic_error("unknown contact kind");
}

std::string_view name(Method method) {
  switch (method) {
    case Method::automatic: return "automatic";
    case Method::exact: return "exact";
    case Method::naive: return "naive";
    case Method::certificate: return "certificate";
  }
  throw std::logic_error("unknown method");
}

std::optional<Status> status_named(std::string_view text) {
  for (const Status status : {Status::penetrating, Status::touching, Status::disjoint})
    if (name(status) == text) return status;
  return std::nullopt;
}

}  // namespace fathom
