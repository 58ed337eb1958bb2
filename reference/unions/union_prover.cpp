// SPDX-License-Identifier: GPL-3.0-or-later
// The search once more, depth first, with the answer as its limit. The polytopes grow on the way; so the tree is built again, until they do
// not: else the proof would hold each of them in many sizes.
#include "reference/unions/union_prover.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/unions/multipliers.hpp"
#include "reference/unions/union_search.hpp"

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
      prove_cell(RationalPoint{});
    }
    proof_.squared = *search_.squared_best();
    for (const RationalPoint& p : search_.optima()) add_optimum(p);
    std::sort(proof_.optima.begin(), proof_.optima.end(),
              [](const ProofOptimum& s, const ProofOptimum& t) { return is_before(s.translation, t.translation); });
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

  // Adds what proves the cell of the path, whose nearest point is p, not farther than the depth.
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
    const std::size_t node = proof_.nodes.size(), before = path_.size();
    proof_.nodes.push_back({true, version.index, {}});
    std::vector<bool> listed(*std::max_element(facet_of.begin(), facet_of.end()) + 1, false);
    const std::vector<PieceFacet*> facets = pair.facets();
    const auto merged = [&](const PieceFacet* f) {
      return facet_of[static_cast<std::size_t>(std::find(facets.begin(), facets.end(), f) - facets.begin())];
    };
    const auto child = [&](PieceFacet* f) {
      listed[merged(f)] = true;
      proof_.nodes[node].numbers.push_back(merged(f));
      prove_beyond(f);
      path_.push_back(&f->reversed);
    };
    for (const UnionSearch::OpenFacet& o : open) child(o.facet);
    for (PieceFacet* f : facets)
      if (!listed[merged(f)] && !kernels::farther(f->plane, *search_.best())) child(f);
    path_.resize(before);
  }

  // The same for the cell of the path and the facet.
  void prove_beyond(PieceFacet* f) {
    RationalPoint nearest;
    std::vector<Barrier> conflict;
    CellEnd end = nearest_on_wall(&f->plane, path_, nullptr, pieces_.exponent(), nearest, &conflict);
    path_.push_back(&f->plane);
    if (end == CellEnd::infeasible) {
      close(without_spare(conflict));
    } else if (kernels::compare(nearest, *search_.best()) > 0) {
      close_at(nearest);
    } else {
      prove_cell(nearest);
    }
    path_.pop_back();
  }

  void close(const std::vector<Barrier>& active) {
    std::vector<std::uint32_t>& numbers = proof_.nodes.emplace_back().numbers;
    for (const Barrier barrier : active)
      numbers.push_back(static_cast<std::uint32_t>(std::find(path_.begin(), path_.end(), barrier) - path_.begin()));
  }

  // Barriers without a common point, of which none can go: then only one combination of them is a contradiction, which checkers find.
  [[nodiscard]] std::vector<Barrier> without_spare(std::vector<Barrier> barriers) const {
    for (std::size_t i = 0; i < barriers.size();) {
      std::vector<Barrier> fewer = barriers;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      RationalPoint p;
      if (nearest_in_cell(fewer, pieces_.exponent(), p) == CellEnd::infeasible) barriers = std::move(fewer);
      else ++i;
    }
    return barriers;
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
    return place->second;
  }

  void add_optimum(const RationalPoint& p) {
    ProofOptimum& optimum = proof_.optima.emplace_back();
    optimum.translation = pieces_.translation(p);
    optimum.directions = separations(search_, p);
  }

  kernels::Context& context_;
  const PlacedPieces& pieces_;
  UnionSearch& search_;
  UnionProof proof_;
  std::vector<Barrier> path_;
  std::map<std::pair<PiecePair*, std::size_t>, Version> versions_;
};

}  // namespace

std::vector<Vector> separations(const UnionSearch& search, const RationalPoint& p) {
  std::vector<Vector> directions;
  for (const auto& pair : search.pairs()) {
    if (pair->contains(p)) throw std::logic_error("a translation out of a union lies inside");
    directions.push_back(pair->separation().normal);
  }
  return directions;
}

UnionProof prove(kernels::Context& context, const PlacedPieces& pieces, const std::vector<UnionOptimum>& optima) {
  UnionSearch search(pieces);
  for (const UnionOptimum& o : optima) search.offer(pieces.point(o.translation));
  if (search.starts_free() || search.optima().size() != optima.size())
    throw std::logic_error("translations that are not the optima of a union");
  return Prover(context, pieces, search).run();
}

}  // namespace fathom::unions
