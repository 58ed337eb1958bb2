// SPDX-License-Identifier: GPL-3.0-or-later
#include <deque>
#include <unordered_set>
#include <utility>

#include "reference/approximate/shallow.hpp"

namespace fathom::approximate {
namespace {

constexpr std::uint64_t facets_between_reports = 256;

/// A face of P by the faces of the two bodies that it is the sum of.
struct Name {
  Face a, b;
  friend bool operator==(const Name&, const Name&) = default;
};

struct HashOfName {
  static std::uint64_t code(const Face& face) { return static_cast<std::uint64_t>(face.kind) << 32 | face.index; }
  std::size_t operator()(const Name& name) const {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    const std::uint64_t h = (code(name.a) * odd ^ code(name.b)) * odd;
    return h ^ h >> 32;
  }
};

using Names = std::unordered_set<Name, HashOfName>;

class Walk {
 public:
  Walk(kernels::Context& context, const SumSurface& surface, const Ball& ball, const VisitFacet& visit)
      : context_(context), surface_(surface), ball_(ball), visit_(visit) {}

  void meet(SumFacet facet) {
    if (met_.insert({facet.a, facet.b}).second) waiting_.push_back(std::move(facet));
  }

  WalkCounts run() {
    while (!waiting_.empty()) {
      const SumFacet facet = std::move(waiting_.front());
      waiting_.pop_front();
      if (++counts_.facets % facets_between_reports == 0) {
        context_.report("facets near the origin",
                        static_cast<double>(counts_.facets) / static_cast<double>(counts_.facets + waiting_.size()));
      }
      visit_(facet);
      leave(facet);
    }
    return counts_;
  }

 private:
  void leave(const SumFacet& facet) {
    for (const SumEdge& edge : surface_.edges(facet)) {
      ++counts_.steps;
      if (!edges_.insert({edge.a, edge.b}).second) continue;  // seen from its other side: left alone there, or crossed to here
      ++counts_.edges;
      if (ball_.meets(surface_.from(edge), surface_.to(edge))) meet(surface_.across(edge, &counts_.steps));
    }
  }

  kernels::Context& context_;
  const SumSurface& surface_;
  const Ball& ball_;
  const VisitFacet& visit_;
  Names met_, edges_;
  std::deque<SumFacet> waiting_;
  WalkCounts counts_;
};

}  // namespace

bool Ball::holds(const Vector& p) const {
  const Vector r = p - centre;
  return denominator * dot(r, r) <= numerator;
}

// The nearest point of the line is p + t (q - p) with t = -<r,d>/<d,d>; if that is not between p and q, an end is nearest.
bool Ball::meets(const Vector& p, const Vector& q) const {
  const Vector r = p - centre, d = q - p;
  if (dot(r, d) >= 0) return holds(p);
  if (dot(q - centre, d) <= 0) return holds(q);
  const Vector moment = cross(r, d);
  return denominator * dot(moment, moment) <= numerator * dot(d, d);
}

WalkCounts walk(kernels::Context& context, const SumSurface& surface, const Ball& ball, std::span<const SumFacet> starts,
                const VisitFacet& visit) {
  Walk walk(context, surface, ball, visit);
  for (const SumFacet& facet : starts) walk.meet(facet);
  return walk.run();
}

}  // namespace fathom::approximate
