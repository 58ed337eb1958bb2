// SPDX-License-Identifier: GPL-3.0-or-later
// Descents through a hierarchy, its extreme vertices, and its laws.
//
// In the view with u upward a level appears as a convex polygon; `left_` and `right_` are edges of
// the polytope that appear at either side of its highest vertex. One level below only that vertex
// or an apex that stood over one of these two can be the highest.

#include "reference/polytope/hierarchy.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "kernels/float_environment.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

Index corners(const Hierarchy& h) { return h.polytope().facets.front().end; }

std::vector<VertexId> all_vertices(const Polytope& p) {
  std::vector<VertexId> all;
  std::ranges::copy(p.vertices.ids(), std::back_inserter(all));
  return all;
}

/// Of a polytope of rank 1 or 2: the vertices as high as `highest`, among it and those next to it.
std::vector<VertexId> face_of_cycle(HierarchyDescent& descent, const Polytope& p) {
  std::vector<VertexId> face{descent.highest()};
  for (const VertexId v : p.rank == 2 ? descent.neighbours() : all_vertices(p)) {
    if (v == descent.highest()) continue;
    if (descent.rise(v) == kernels::Sign::zero) face.push_back(v);
  }
  return face.size() == 3 ? all_vertices(p) : face;  // then the polygon's plane is level
}

/// The facet with outward normal along u at the edge from v to w, or the edge itself.
std::vector<VertexId> face_at_edge(const Polytope& p, VertexId v, VertexId w, const Vector& u) {
  const auto [from, to] = std::minmax(v, w);
  const auto edge = std::ranges::lower_bound(p.edges, std::tuple(from, to), {},
                                             [](const Edge& e) { return std::tuple(e.from, e.to); });
  for (const FacetId f : {edge->left, edge->right}) {
    const Facet& facet = p.facets[f];
    if (same_direction(facet.normal, u)) return {p.corners.begin() + facet.begin, p.corners.begin() + facet.end};
  }
  return {from, to};
}

// The laws of a hierarchy, level by level, against hulls computed anew.

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
  report.expect(hull.rank == 3 && hull.vertices.size() == vertices.size(),
                "a level is flat, or has points that are not vertices");
  Edges edges;
  for (const Edge& e : hull.edges)
    edges.insert(std::minmax(vertices[hull.input_ids[e.from]], vertices[hull.input_ids[e.to]]));
  return edges;
}

void check_removed(const Coarsening& c, Index level, const Edges& edges, kernels::Report& report) {
  std::size_t ends = 0;
  for (const auto& [from, to] : edges) {
    report.expect(c.last[from] > level || c.last[to] > level || level + 1 == c.levels,
                  "adjacent vertices are removed together");
    ends += (c.last[from] == level) + (c.last[to] == level);
  }
  for (const VertexId v : c.last.ids()) {
    if (c.last[v] != level) continue;
    const std::span<const Coarsening::Link> links = c.links_of(v);
    report.expect(links.size() <= greatest_degree || level + 1 == c.levels, "a removed vertex has too many edges");
    ends -= links.size();
    for (const Coarsening::Link& link : links)
      report.expect(edges.contains(std::minmax(v, link.vertex)), "a link is no edge");
  }
  report.expect(ends == 0, "links are not all edges of a vertex");
}

}  // namespace

HierarchyDescent::HierarchyDescent(const Hierarchy& hierarchy) : hierarchy_(&hierarchy), c_(&hierarchy.coarsening()) {}

std::vector<VertexId> HierarchyDescent::coarsest() const {
  const Polytope& p = hierarchy_->polytope();
  if (p.rank == 3) return c_->top;
  std::vector<VertexId> vertices;
  if (p.rank == 2) {
    for (Index i = 0; i < corners(*hierarchy_); i += Index{1} << (hierarchy_->levels() - 1))
      vertices.push_back(p.corners[i]);
  } else {
    std::ranges::copy(p.vertices.ids(), std::back_inserter(vertices));
  }
  return vertices;
}

VertexId HierarchyDescent::highest() const { return highest_; }

bool HierarchyDescent::climb(VertexId v) {
  if (rise(v) != kernels::Sign::positive) return false;
  highest_ = v;
  return true;
}

void HierarchyDescent::start(const Vector& u) {
  view_.emplace(hierarchy_->cloud(), u);
  level_ = static_cast<Index>(hierarchy_->levels() - 1);
  const std::vector<VertexId> vertices = coarsest();
  highest_ = vertices.front();
  position_ = 0;
  for (Index i = 1; i < vertices.size(); ++i)
    if (climb(vertices[i])) position_ = i << level_;
  if (hierarchy_->polytope().rank == 3) choose_sides();
}

void HierarchyDescent::turn_to(const Vector& u) {
  view_.emplace(hierarchy_->cloud(), u);
  if (hierarchy_->polytope().rank == 3) choose_sides();
}

std::vector<VertexId> HierarchyDescent::neighbours() const {
  std::vector<VertexId> result;
  if (hierarchy_->polytope().rank == 3) {
    for (const Coarsening::Link& link : c_->links_of(highest_)) result.push_back(link.vertex);
  } else {
    const Index stride = Index{1} << level_, last = (corners(*hierarchy_) - 1) / stride * stride;
    for (const Index i : {position_ == 0 ? last : position_ - stride, position_ == last ? 0 : position_ + stride})
      result.push_back(hierarchy_->polytope().corners[i]);
  }
  return result;
}

bool HierarchyDescent::step_down() {
  --level_;
  return hierarchy_->polytope().rank == 3 ? step_down_solid() : step_down_polygon();
}

/// Heights along the cycle rise once and fall once: a corner that is higher than all is next to the
/// old highest one.
bool HierarchyDescent::step_down_polygon() {
  const Index stride = Index{1} << level_, last = (corners(*hierarchy_) - 1) / stride * stride, here = position_;
  bool climbed = false;
  for (const Index i : {here == 0 ? last : here - stride, here == last ? 0 : here + stride}) {
    if (!climb(hierarchy_->polytope().corners[i])) continue;
    position_ = i;
    climbed = true;
  }
  return climbed;
}

/// Among all edges of a vertex at its last level.
void HierarchyDescent::choose_sides() {
  left_ = right_ = {highest_};
  for (const Coarsening::Link& link : c_->links_of(highest_)) {
    const Side s{link.vertex, c_->edges[link.edge].changes, rise(link.vertex) == kernels::Sign::zero};
    const bool first = left_.other == highest_;
    if (first || s.level) left_ = right_ = s;
    if (s.level) return;
    if (first) continue;
    if (turn(left_.other, s.other) == kernels::Sign::negative) left_ = s;
    else if (turn(right_.other, s.other) == kernels::Sign::positive) right_ = s;
  }
}

/// The apexes that stand over a facet of `s` at this level, where the next coarser one has it open;
/// at most two.
void HierarchyDescent::collect(Side& s) {
  for (; s.change != no_change && c_->changes[s.change].level == level_ + 1; s.change = c_->changes[s.change].next) {
    const VertexId apex = c_->changes[s.change].apex;
    if (std::find(apexes_.begin(), apexes_.begin() + count_, apex) == apexes_.begin() + count_)
      apexes_[count_++] = apex;
  }
}

/// Whether the apex hides edge s, on the left (negative sense) or on the right.
bool HierarchyDescent::hides(VertexId apex, const Side& s, kernels::Sign sense) {
  return s.level ? rise(apex) == kernels::Sign::zero : turn(s.other, apex) == sense;
}

/// The edge from the highest vertex to an apex.
HierarchyDescent::Side HierarchyDescent::side_to(VertexId apex) {
  const std::span<const Coarsening::Link> links = c_->links_of(apex);
  const auto link = std::ranges::find(links, highest_, &Coarsening::Link::vertex);
  return {apex, c_->edges[link->edge].changes, rise(apex) == kernels::Sign::zero};
}

bool HierarchyDescent::step_down_solid() {
  count_ = 0;
  collect(left_);
  collect(right_);
  bool climbed = false;
  for (Index i = 0; i < count_; ++i) climbed |= climb(apexes_[i]);
  if (climbed) {
    choose_sides();
    return true;
  }
  for (Index i = 0; i < count_; ++i) {
    if (hides(apexes_[i], left_, kernels::Sign::negative)) left_ = side_to(apexes_[i]);
    if (hides(apexes_[i], right_, kernels::Sign::positive)) right_ = side_to(apexes_[i]);
  }
  return false;
}

Hierarchy::Hierarchy(const Polytope& polytope) : polytope_(&polytope), cloud_(polytope.vertices) {
  const kernels::DefaultFloatEnvironment environment;
  if (polytope.rank == 3) coarsening_ = coarsen(polytope);
}

std::size_t Hierarchy::levels() const {
  if (polytope_->rank == 3) return coarsening_.levels;
  std::size_t levels = 1;
  if (polytope_->rank == 2)
    for (std::size_t n = cloud_.size(); n > 4; n = (n + 1) / 2) ++levels;
  return levels;
}

std::size_t Hierarchy::size() const {
  return cloud_.size() + coarsening_.edges.size() + coarsening_.changes.size() + coarsening_.links.size();
}

VertexId Hierarchy::extreme(const Vector& u, Steps* steps) const {
  const kernels::DefaultFloatEnvironment environment;
  if (polytope_->rank == 0 || is_zero(u)) return VertexId(0);
  HierarchyDescent descent(*this);
  descent.start(u);
  while (!descent.at_finest()) descent.step_down();
  if (steps) *steps += descent.steps();
  return descent.highest();
}

std::vector<VertexId> Hierarchy::extreme_face(const Vector& u, Steps* steps) const {
  const kernels::DefaultFloatEnvironment environment;
  if (polytope_->rank == 0 || is_zero(u)) return all_vertices(*polytope_);
  HierarchyDescent descent(*this);
  descent.start(u);
  while (!descent.at_finest()) descent.step_down();
  std::vector<VertexId> face{descent.highest()};
  if (polytope_->rank < 3) face = face_of_cycle(descent, *polytope_);
  else if (const VertexId* tied = descent.tied()) face = face_at_edge(*polytope_, descent.highest(), *tied, u);
  std::ranges::sort(face);
  if (steps) *steps += descent.steps();
  return face;
}

kernels::Report validate(const Hierarchy& hierarchy) {
  kernels::Report report;
  const Coarsening& c = hierarchy.coarsening();
  for (Index level = 0; level < c.levels; ++level) {
    const Edges edges = edges_of(c, level);
    report.expect(edges == edges_of_hull(hierarchy.polytope(), vertices_of(c, level), report),
                  "edges of level " + std::to_string(level));
    check_removed(c, level, edges, report);
  }
  for (const Coarsening::Edge& e : c.edges) {
    for (Index i = e.changes; i != no_change; i = c.changes[i].next) {
      const Coarsening::Change& change = c.changes[i];
      report.expect(c.last[change.apex] + 1 == change.level, "an apex is not removed where it opens a facet");
      report.expect(change.next == no_change || c.changes[change.next].level <= change.level,
                    "changes are out of order");
    }
  }
  return report;
}

}  // namespace fathom::polytope
