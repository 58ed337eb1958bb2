// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of a hierarchy, level by level, against hulls computed anew.
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "reference/polytope/hierarchy.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;
using Edges = std::set<std::pair<VertexId, VertexId>>;

/// Vertices of one level, ascending.
std::vector<VertexId> vertices_of(const Coarsening& c, Index level) {
  std::vector<VertexId> vertices;
  for (const VertexId v : c.last.ids())
    if (c.last[v] >= level) vertices.push_back(v);
  return vertices;
}

Edges edges_of(const Coarsening& c, Index level) {
  Edges edges;
  for (const Coarsening::Edge& e : c.edges)
    if (e.born <= level && level <= std::min(c.last[e.from], c.last[e.to])) edges.insert(std::minmax(e.from, e.to));
  return edges;
}

/// The hull of the level's vertices, with the vertices of the finest level for numbers.
Edges edges_of_hull(const Polytope& polytope, const std::vector<VertexId>& vertices, kernels::Report& report) {
  std::vector<Vector> points;
  for (const VertexId v : vertices) points.push_back(polytope.vertices[v]);
  const Polytope hull = convex_hull(points);
  report.expect(hull.rank == 3 && hull.vertices.size() == vertices.size(), "a level is flat, or has points that are not vertices");
  Edges edges;
  for (const Edge& e : hull.edges) edges.insert(std::minmax(vertices[hull.input_ids[e.from]], vertices[hull.input_ids[e.to]]));
  return edges;
}

void check_removed(const Coarsening& c, Index level, const Edges& edges, kernels::Report& report) {
  std::size_t ends = 0;
  for (const auto& [from, to] : edges) {
    report.expect(c.last[from] > level || c.last[to] > level || level + 1 == c.levels, "adjacent vertices are removed together");
    ends += (c.last[from] == level) + (c.last[to] == level);
  }
  for (const VertexId v : c.last.ids()) {
    if (c.last[v] != level) continue;
    const std::span<const Coarsening::Link> links = c.links_of(v);
    report.expect(links.size() <= greatest_degree || level + 1 == c.levels, "a removed vertex has too many edges");
    ends -= links.size();
    for (const Coarsening::Link& link : links) report.expect(edges.contains(std::minmax(v, link.vertex)), "a link is no edge");
  }
  report.expect(ends == 0, "links are not all edges of a vertex");
}

}  // namespace

kernels::Report validate(const Hierarchy& hierarchy) {
  kernels::Report report;
  const Coarsening& c = hierarchy.coarsening();
  for (Index level = 0; level < c.levels; ++level) {
    const Edges edges = edges_of(c, level);
    report.expect(edges == edges_of_hull(hierarchy.polytope(), vertices_of(c, level), report), "edges of level " + std::to_string(level));
    check_removed(c, level, edges, report);
  }
  for (const Coarsening::Edge& e : c.edges) {
    for (Index i = e.changes; i != no_change; i = c.changes[i].next) {
      const Coarsening::Change& change = c.changes[i];
      report.expect(c.last[change.apex] + 1 == change.level, "an apex is not removed where it opens a facet");
      report.expect(change.next == no_change || c.changes[change.next].level <= change.level, "changes are out of order");
    }
  }
  return report;
}

}  // namespace fathom::polytope
