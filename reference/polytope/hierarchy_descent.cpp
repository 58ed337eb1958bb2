// SPDX-License-Identifier: GPL-3.0-or-later
// In the view with u upward a level appears as a convex polygon; `left_` and `right_` are edges of the polytope that appear at either side
// of its highest vertex. One level below only that vertex or an apex that stood over one of these two can be the highest.
#include <algorithm>
#include <iterator>

#include "reference/polytope/hierarchy.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

Index corners(const Hierarchy& h) { return h.polytope().facets.front().end; }

}  // namespace

HierarchyDescent::HierarchyDescent(const Hierarchy& hierarchy) : hierarchy_(&hierarchy), c_(&hierarchy.coarsening()) {}

std::vector<VertexId> HierarchyDescent::coarsest() const {
  const Polytope& p = hierarchy_->polytope();
  if (p.rank == 3) return c_->top;
  std::vector<VertexId> vertices;
  if (p.rank == 2) {
    for (Index i = 0; i < corners(*hierarchy_); i += Index{1} << (hierarchy_->levels() - 1)) vertices.push_back(p.corners[i]);
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

/// Heights along the cycle rise once and fall once: a corner that is higher than all is next to the old highest one.
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

/// The apexes that stand over a facet of `s` at this level, where the next coarser one has it open; at most two.
void HierarchyDescent::collect(Side& s) {
  for (; s.change != no_change && c_->changes[s.change].level == level_ + 1; s.change = c_->changes[s.change].next) {
    const VertexId apex = c_->changes[s.change].apex;
    if (std::find(apexes_.begin(), apexes_.begin() + count_, apex) == apexes_.begin() + count_) apexes_[count_++] = apex;
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

}  // namespace fathom::polytope
