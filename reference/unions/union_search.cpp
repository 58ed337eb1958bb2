// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/union_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace fathom::unions {

using kernels::AnyNumbers;
using kernels::as;
using kernels::FixedNumbers;

constexpr int most_compared = 8;  // pairs that hold a point

template <class Numbers>
bool same_point(const kernels::RationalPointIn<Numbers>& p, const kernels::RationalPointIn<Numbers>& q) {
  using Product = typename Numbers::Product;
  const auto &of_p = as<Product>(p.w), &of_q = as<Product>(q.w);
  const auto same = [&](const auto& c, const auto& d) {
    return Product(as<Product>(c) * of_q) == Product(as<Product>(d) * of_p);
  };
  return same(p.v.x, q.v.x) && same(p.v.y, q.v.y) && same(p.v.z, q.v.z);
}

bool is_before(const Point& p, const Point& q) {
  if (const int c = cmp(p.x, q.x)) return c < 0;
  if (const int c = cmp(p.y, q.y)) return c < 0;
  return cmp(p.z, q.z) < 0;
}

template <class Numbers>
UnionSearchIn<Numbers>::UnionSearchIn(const PlacedPieces& pieces, bool all_pairs)
    : pieces_(pieces), table_(pieces, all_pairs) {
  push(Place{}, none);
}

template <class Numbers>
bool UnionSearchIn<Numbers>::starts_free() {
  return is_free(Place{});
}

template <class Numbers>
bool UnionSearchIn<Numbers>::is_free(const Place& p) {
  if (last_ != nullptr && last_->contains(p)) return false;
  RankedPairs pairs = table_.ranked(p);
  for (auto ranked = pairs.next(); ranked && ranked->bound >= 0; ranked = pairs.next()) {
    Pair* pair = table_.find(*ranked, p);
    if (pair == nullptr || !pair->contains(p)) continue;
    last_ = pair;
    return false;
  }
  return true;
}

template <class Numbers>
void UnionSearchIn<Numbers>::offer(const Place& p) {
  if (best_ && kernels::compare(p, *best_) > 0) return;
  if (is_free(p)) accept(p);
}

template <class Numbers>
void UnionSearchIn<Numbers>::accept(const Place& p) {
  const int order = best_ ? kernels::compare(p, *best_) : -1;
  if (order > 0) return;
  if (order < 0) {
    optima_.clear();
    best_ = kernels::squared_distance(p);
  }
  if (std::none_of(optima_.begin(), optima_.end(), [&](const Place& o) { return same_point(o, p); }))
    optima_.push_back(p);
}

template <class Numbers>
typename UnionSearchIn<Numbers>::Pair* UnionSearchIn<Numbers>::deepest(const Place& p) {
  Pair* found = nullptr;
  double most = 0;
  int compared = 0;
  RankedPairs pairs = table_.ranked(p);
  for (auto ranked = pairs.next(); ranked && ranked->bound >= 0; ranked = pairs.next()) {
    if (found != nullptr && (ranked->bound <= most || compared == most_compared)) break;
    Pair* pair = table_.find(*ranked, p);
    if (pair == nullptr || !pair->contains(p)) continue;
    ++compared;
    const double margin = pair->margin(p);
    if (found != nullptr && margin <= most) continue;
    found = pair;
    most = margin;
  }
  return found;
}

template <class Numbers>
CellEnd UnionSearchIn<Numbers>::cut(std::span<const Wall> cell, Wall wall, Place& nearest) {
  ++counts_.nearest_points;
  return nearest_on_wall<Numbers>(wall, cell, best_ ? &*best_ : nullptr, pieces_.exponent(), nearest);
}

template <class Numbers>
std::vector<typename UnionSearchIn<Numbers>::OpenFacet> UnionSearchIn<Numbers>::open_facets(
    Pair& pair, std::span<const Wall> cell) {
  std::map<const Facet*, std::optional<Place>> known;
  std::vector<OpenFacet> open;
  for (bool again = true; again;) {
    again = false;
    open.clear();
    const std::vector<Facet*> facets = pair.facets();
    for (Facet* f : facets) {
      if (again && !pair.surface().triangles()[f->triangle].alive) continue;
      if (best_ && kernels::farther(f->plane, *best_)) continue;
      auto [place, fresh] = known.try_emplace(f);
      if (fresh) {
        Place nearest;
        if (cut(cell, &f->plane, nearest) == CellEnd::found) place->second = std::move(nearest);
      }
      if (!place->second) continue;
      if (!pair.settle(*f)) again = true;
      else open.push_back({f, *place->second});
    }
  }
  std::sort(open.begin(), open.end(), [](const OpenFacet& x, const OpenFacet& y) {
    return std::pair(x.nearest.image_square, x.facet->triangle.value) <
           std::pair(y.nearest.image_square, y.facet->triangle.value);
  });
  const auto same_plane = [](const OpenFacet& x, const OpenFacet& y) {
    return x.facet->plane.normal == y.facet->plane.normal;
  };
  std::vector<OpenFacet> distinct;
  for (OpenFacet& f : open)
    if (std::none_of(distinct.begin(), distinct.end(), [&](const OpenFacet& other) { return same_plane(f, other); }))
      distinct.push_back(std::move(f));
  return distinct;
}

template <class Numbers>
void UnionSearchIn<Numbers>::dive() {
  std::vector<Wall> cell;
  Place p;
  while (Pair* pair = deepest(p)) {
    std::optional<OpenFacet> next;
    while (!next) {
      for (Facet* f : pair->facets()) {
        Place nearest;
        if (cut(cell, &f->plane, nearest) != CellEnd::found) continue;
        if (!next || nearest.image_square < next->nearest.image_square) next = OpenFacet{f, std::move(nearest)};
      }
      if (!next) return;
      if (!pair->settle(*next->facet)) next.reset();
    }
    cell.insert(cell.begin(), &next->facet->plane);
    p = std::move(next->nearest);
  }
  accept(p);
}

template <class Numbers>
void UnionSearchIn<Numbers>::push(Place nearest, std::uint32_t link) {
  open_.push_back({std::move(nearest), link});
  std::push_heap(open_.begin(), open_.end(), is_farther);
}

template <class Numbers>
typename UnionSearchIn<Numbers>::Cell UnionSearchIn<Numbers>::pop() {
  std::pop_heap(open_.begin(), open_.end(), is_farther);
  Cell cell = std::move(open_.back());
  open_.pop_back();
  return cell;
}

template <class Numbers>
void UnionSearchIn<Numbers>::collect(std::uint32_t link) {
  cell_.clear();
  for (; link != none; link = links_[link].before) cell_.push_back(links_[link].barrier);
}

template <class Numbers>
void UnionSearchIn<Numbers>::split(const Cell& cell) {
  ++counts_.nodes;
  Pair* pair = deepest(cell.nearest);
  if (pair == nullptr) return accept(cell.nearest);
  if (best_ && kernels::compare(cell.nearest, *best_) == 0) return;  // the cell's other points are farther
  collect(cell.link);
  std::uint32_t link = cell.link;
  std::vector<OpenFacet> open = open_facets(*pair, cell_);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto& [facet, unbarred] = open[i];
    Place nearest = unbarred;
    const std::uint32_t before = link;
    if (i == 0 || cut(cell_, &facet->plane, nearest) == CellEnd::found) {
      links_.push_back({&facet->plane, before});
      push(std::move(nearest), static_cast<std::uint32_t>(links_.size() - 1));
    }
    links_.push_back({&facet->reversed(), before});
    link = static_cast<std::uint32_t>(links_.size() - 1);
    cell_.insert(cell_.begin(), &facet->reversed());
  }
}

// Which bounds the search has come to, rounded, for people to read.
template <class Numbers>
std::string UnionSearchIn<Numbers>::stage() const {
  const auto length = [&](double image_square) {
    mpq_class x = std::sqrt(image_square);
    const auto shift = static_cast<mp_bitcnt_t>(std::abs(pieces_.exponent()));
    if (pieces_.exponent() < 0) mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), shift);
    else mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), shift);
    return mpq_class(x / pieces_.whole.denominator).get_d();
  };
  if (!best_) return "union";
  return fmt::format("union: depth between {:.4g} and {:.4g}", length(open_.front().nearest.image_square),
                     length(best_->image));
}

template <class Numbers>
bool UnionSearchIn<Numbers>::run(kernels::Context& context) {
  constexpr std::uint64_t told_every = 32;  // cells: the text takes time
  std::string now = stage();
  try {
    while (!open_.empty()) {
      const double high = best_ ? best_->image : 0;
      if (counts_.nodes % told_every == 0) now = stage();
      context.report(now, high > 0 ? std::min(1.0, open_.front().nearest.image_square / high) : 0);
      const Cell cell = pop();
      if (!best_ || kernels::compare(cell.nearest, *best_) <= 0) split(cell);
    }
  } catch (const Interrupted&) {
    return false;
  }
  return true;
}

template <class Numbers>
std::optional<mpq_class> UnionSearchIn<Numbers>::squared_best() const {
  if (!best_) return std::nullopt;
  return pieces_.squared(as<mpz_class>(best_->numerator), as<mpz_class>(best_->denominator));
}

template <class Numbers>
mpq_class UnionSearchIn<Numbers>::squared_low() const {
  std::optional<mpq_class> least = squared_best();
  for (const Cell& cell : open_) {
    const auto p = kernels::converted<AnyNumbers>(cell.nearest);
    mpq_class q = pieces_.squared(dot(p.v, p.v), p.w * p.w);
    if (!least || q < *least) least = std::move(q);
  }
  return least.value_or(0);
}

template <class Numbers>
UnionCounters UnionSearchIn<Numbers>::counts() const {
  UnionCounters counts = counts_;
  counts.pairs = table_.size();
  counts.pairs_touched = table_.made();
  return counts;
}

template class UnionSearchIn<AnyNumbers>;
template class UnionSearchIn<FixedNumbers>;
template bool same_point(const kernels::RationalPointIn<AnyNumbers>&, const kernels::RationalPointIn<AnyNumbers>&);
template bool same_point(const kernels::RationalPointIn<FixedNumbers>&, const kernels::RationalPointIn<FixedNumbers>&);

}  // namespace fathom::unions
