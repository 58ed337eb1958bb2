// SPDX-License-Identifier: GPL-3.0-or-later
// The search once more, depth first, with the answer as its limit. Q grows on the way, so that the tree is built again until it does not.
#include "reference/unions/union_prover.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "kernels/number/ratio.hpp"
#include "reference/unions/multipliers.hpp"

namespace fathom::unions {
namespace {

using kernels::RationalPoint;

constexpr int most_passes = 4;

class Prover {
 public:
  Prover(kernels::Context& context, const PlacedPieces& pieces, UnionSearch& search)
      : context_(context), pieces_(pieces), search_(search) {}

  UnionProof run() {
    std::size_t corners = 0;
    for (int pass = 0; pass < most_passes && corners != count_corners(); ++pass) {
      corners = count_corners();
      proof_ = {};
      versions_.clear();
      add_node(0);
      prove_cell(RationalPoint{});
    }
    const mpz_class unit = pieces_.whole.denominator * pieces_.whole.denominator;
    proof_.squared = kernels::ratio(search_.best()->numerator, search_.best()->denominator * unit);
    for (const RationalPoint& p : search_.optima()) add_optimum(p);
    const auto before = [](const ProofOptimum& s, const ProofOptimum& t) {
      const Point &p = s.translation, &q = t.translation;
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    std::sort(proof_.optima.begin(), proof_.optima.end(), before);
    return std::move(proof_);
  }

 private:
  struct Version {
    std::uint32_t index;
    std::vector<std::uint32_t> facet_of;
  };

  [[nodiscard]] std::size_t count_corners() const {
    std::size_t count = 1;
    for (const auto& pair : search_.pairs()) count += pair->surface().vertices().size();
    return count;
  }

  std::size_t add_node(std::uint32_t facet) {
    ProofNode& node = proof_.nodes.emplace_back();
    node.facet = facet;
    return proof_.nodes.size() - 1;
  }

  // The last node is that of a cell whose nearest point is p, not farther than the depth.
  void prove_cell(const RationalPoint& p) {
    context_.report("proof of the union");
    const bool known =
        std::any_of(search_.optima().begin(), search_.optima().end(), [&](const RationalPoint& o) { return same_point(o, p); });
    if (known) return close_at(p);
    PiecePair* pair = search_.deepest(p);
    if (pair == nullptr) throw std::logic_error("a translation out of a union is shorter than its depth");
    split(*pair);
  }

  void split(PiecePair& pair) {
    const std::vector<UnionSearch::OpenFacet> open = search_.open_facets(pair, path_);
    const Version& version = version_of(pair);
    const std::vector<std::uint32_t> facet_of = version.facet_of;
    const std::size_t node = proof_.nodes.size() - 1, before = path_.size();
    proof_.nodes[node].split = true;
    proof_.nodes[node].polytope = version.index;
    std::vector<bool> listed(*std::max_element(facet_of.begin(), facet_of.end()) + 1, false);
    const std::vector<PieceFacet*> facets = pair.facets();
    const auto merged = [&](const PieceFacet* f) {
      return facet_of[static_cast<std::size_t>(std::find(facets.begin(), facets.end(), f) - facets.begin())];
    };
    std::uint32_t children = 0;
    const auto child = [&](PieceFacet* f) {
      listed[merged(f)] = true;
      ++children;
      add_node(merged(f));
      prove_beyond(f);
      path_.push_back(&f->reversed);
    };
    for (const UnionSearch::OpenFacet& o : open) child(o.facet);
    for (PieceFacet* f : facets)
      if (!listed[merged(f)] && !kernels::farther(f->plane, *search_.best())) child(f);
    proof_.nodes[node].children = children;
    path_.resize(before);
  }

  // The last node is that of the cell of the path and the facet.
  void prove_beyond(PieceFacet* f) {
    RationalPoint nearest;
    std::vector<Barrier> conflict;
    CellEnd end = nearest_on_wall(&f->plane, path_, nullptr, pieces_.exponent(), nearest, &conflict);
    path_.push_back(&f->plane);
    if (end == CellEnd::infeasible) {
      close(conflict);
    } else if (kernels::compare(nearest, *search_.best()) > 0) {
      close_at(nearest);
    } else {
      prove_cell(nearest);
    }
    path_.pop_back();
  }

  void close(const std::vector<Barrier>& active) {
    for (const Barrier barrier : active)
      proof_.nodes.back().active.push_back(static_cast<std::uint32_t>(std::find(path_.begin(), path_.end(), barrier) - path_.begin()));
  }

  void close_at(const RationalPoint& p) {
    std::vector<Barrier> tight;
    for (const Barrier barrier : path_)
      if (kernels::side(*barrier, p) == 0) tight.push_back(barrier);
    close(deciding(tight, p.v));
  }

  const Version& version_of(PiecePair& pair) {
    const auto [place, fresh] = versions_.try_emplace({&pair, pair.surface().vertices().size()});
    if (!fresh) return place->second;
    place->second.index = static_cast<std::uint32_t>(proof_.polytopes.size());
    PiecePolytope& polytope = proof_.polytopes.emplace_back();
    const auto k = static_cast<std::size_t>(
        std::find_if(search_.pairs().begin(), search_.pairs().end(), [&](const auto& other) { return other.get() == &pair; }) -
        search_.pairs().begin());
    polytope.a = static_cast<std::uint32_t>(k / pieces_.b.size());
    polytope.b = static_cast<std::uint32_t>(k % pieces_.b.size());
    polytope.inner = pair.inner(place->second.facet_of);
    polytope.inside = spanning(polytope);
    return place->second;
  }

  // The corners of a facet that are not in one line with each other, and a corner off its plane.
  [[nodiscard]] std::array<std::uint32_t, 4> spanning(const PiecePolytope& polytope) const {
    const auto at = [&](std::uint32_t v) {
      const auto& [a, b] = polytope.inner.vertices[v];
      return pieces_.b[polytope.b][b] - pieces_.a[polytope.a][a];
    };
    const std::vector<std::uint32_t>& facet = polytope.inner.facets.front();
    const Vector p = at(facet[0]), n = cross(at(facet[1]) - p, at(facet[2]) - p);
    std::uint32_t off = 0;
    while (dot(n, at(off) - p) == 0) ++off;
    return {facet[0], facet[1], facet[2], off};
  }

  void add_optimum(const RationalPoint& p) {
    const mpz_class w = p.w * pieces_.whole.denominator;
    ProofOptimum& optimum = proof_.optima.emplace_back();
    optimum.translation = {kernels::ratio(p.v.x, w), kernels::ratio(p.v.y, w), kernels::ratio(p.v.z, w)};
    for (const auto& pair : search_.pairs()) {
      if (pair->contains(p)) throw std::logic_error("a translation out of a union lies inside");
      optimum.directions.push_back(pair->separation().normal);
    }
  }

  kernels::Context& context_;
  const PlacedPieces& pieces_;
  UnionSearch& search_;
  UnionProof proof_;
  std::vector<Barrier> path_;
  std::map<std::pair<PiecePair*, std::size_t>, Version> versions_;
};

}  // namespace

UnionProof prove(kernels::Context& context, const PlacedPieces& pieces, UnionSearch& search) {
  return Prover(context, pieces, search).run();
}

UnionProof prove_union_depth(kernels::Context& context, const Pieces& a, const Pieces& b) {
  const PlacedPieces pieces = place_pieces(a, b);
  UnionSearch search(pieces);
  if (search.starts_free()) throw std::invalid_argument("a proof of the depth of unions that do not penetrate");
  search.dive();
  if (!search.run(context)) throw Interrupted();
  return prove(context, pieces, search);
}

}  // namespace fathom::unions
