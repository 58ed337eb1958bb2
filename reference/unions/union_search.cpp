// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/union_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include "kernels/filters/meeting_points.hpp"

namespace fathom::unions {

namespace {

using kernels::AnyNumbers;
using kernels::as;
using kernels::FixedNumbers;
using kernels::RationalPointIn;

template <class Integer>
Vec3<Integer> scaled(const Integer& s, const Vec3<Integer>& v) {
  return {Integer(s * v.x), Integer(s * v.y), Integer(s * v.z)};
}

// A plane's equation in the integers that points are computed with.
template <class Numbers>
struct Equation {
  using Integer = typename Numbers::Product;
  explicit Equation(const kernels::OrientedPlaneIn<Numbers>& plane)
      : normal(as<Integer>(plane.normal)), height(as<Integer>(plane.height)) {}
  Vec3<Integer> normal;
  Integer height;
};

template <class Numbers>
RationalPointIn<Numbers> foot_of(BarrierIn<Numbers> wall, long exponent) {
  const Equation<Numbers> g(*wall);
  return kernels::rational_point<Numbers>(scaled(g.height, g.normal), dot(g.normal, g.normal), exponent);
}

// The line in which two planes meet: by images, and exactly where they cannot tell.
template <class Numbers>
class Line {
 public:
  using Integer = typename Numbers::Product;

  Line(BarrierIn<Numbers> g, BarrierIn<Numbers> h, long exponent)
      : g_(g), h_(h), exponent_(exponent), image_(g->image, h->image) {}

  [[nodiscard]] bool exists() { return image_.surely_exists() || !is_zero(exact().direction); }
  // The sign of the direction in which the line leads beyond a plane: 0 if it is parallel to it.
  [[nodiscard]] int leads_beyond(BarrierIn<Numbers> e) {
    if (const auto sure = image_.leads_beyond(e->image)) return kernels::to_int(*sure);
    return sgn(dot(exact().direction, as<Integer>(e->normal)));
  }
  [[nodiscard]] const kernels::MeetingLine& image() const { return image_; }
  // Its point nearest to O.
  [[nodiscard]] RationalPointIn<Numbers> foot() {
    const auto& [g, h, d] = exact();
    return kernels::rational_point<Numbers>(scaled(g.height, cross(h.normal, d)) + scaled(h.height, cross(d, g.normal)),
                                            dot(d, d), exponent_);
  }
  [[nodiscard]] RationalPointIn<Numbers> meeting(BarrierIn<Numbers> third) {
    const auto& [g, h, d] = exact();
    const Equation<Numbers> e(*third);
    return kernels::rational_point<Numbers>(
        scaled(g.height, cross(h.normal, e.normal)) + scaled(h.height, cross(e.normal, g.normal)) + scaled(e.height, d),
        dot(d, e.normal), exponent_);
  }

 private:
  struct Exact {
    Equation<Numbers> g, h;
    Vec3<Integer> direction;
  };

  const Exact& exact() {
    if (!exact_) {
      const Equation<Numbers> g(*g_), h(*h_);
      exact_ = Exact{g, h, cross(g.normal, h.normal)};
    }
    return *exact_;
  }

  BarrierIn<Numbers> g_, h_;
  long exponent_;
  kernels::MeetingLine image_;
  std::optional<Exact> exact_;
};

// The nearest point so far: the foot of the wall or of a line, or where the line meets a third
// plane. Most of them are asked for nothing that their image cannot tell, and have no exact
// coordinates.
template <class Numbers>
class Candidate {
 public:
  Candidate(BarrierIn<Numbers> wall, long exponent)
      : wall_(wall), exponent_(exponent), image_(kernels::foot_image(wall->image)) {}

  void move_to_foot(Line<Numbers>& line) { move(line, nullptr, line.image().foot()); }
  void move_to_meeting(Line<Numbers>& line, BarrierIn<Numbers> e) { move(line, e, line.image().meeting(e->image)); }

  [[nodiscard]] int side(BarrierIn<Numbers> e) {
    if (const auto sure = kernels::sure_side(e->image, image_)) return kernels::to_int(*sure);
    return kernels::side(*e, exact());
  }
  // Whether it is farther away than the limit, if there is one.
  [[nodiscard]] bool is_beyond(LimitIn<Numbers> limit) {
    if (limit == nullptr) return false;
    if (const auto sure = kernels::sure_order(image_, limit->image)) return *sure == kernels::Sign::positive;
    return kernels::compare(exact(), *limit) > 0;
  }
  RationalPointIn<Numbers>& exact() {
    if (!exact_) {
      if (line_ == nullptr) exact_ = foot_of<Numbers>(wall_, exponent_);
      else exact_ = third_ == nullptr ? line_->foot() : line_->meeting(third_);
    }
    return *exact_;
  }

 private:
  void move(Line<Numbers>& line, BarrierIn<Numbers> third, const kernels::PointImage& image) {
    line_ = &line;
    third_ = third;
    image_ = image;
    exact_.reset();
  }

  BarrierIn<Numbers> wall_, third_ = nullptr;
  Line<Numbers>* line_ = nullptr;
  long exponent_;
  kernels::PointImage image_;
  std::optional<RationalPointIn<Numbers>> exact_;
};

// On the line the point only moves away from its foot, to one side: it ends as soon as it would
// have to go back. Sets `last` and `against` to the barriers that leave nothing of the line, or one
// of them to null.
template <class Numbers>
CellEnd nearest_on_line(Line<Numbers>& line, BarriersIn<Numbers> barriers, LimitIn<Numbers> limit,
                        Candidate<Numbers>& nearest, BarrierIn<Numbers>& last, BarrierIn<Numbers>& against) {
  nearest.move_to_foot(line);
  int way = 0;
  std::size_t moved = 0;  // barriers before this one were met before the last move
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (nearest.side(barriers[i]) >= 0) continue;
    const int to = line.leads_beyond(barriers[i]);
    against = barriers[i];
    if (to == 0) last = nullptr;
    if (to == 0 || to == -way) return CellEnd::infeasible;
    way = to;
    nearest.move_to_meeting(line, barriers[i]);
    last = barriers[i];
    moved = i;
    if (nearest.is_beyond(limit)) return CellEnd::beyond;
  }
  for (std::size_t i = 0; i < moved; ++i) {
    against = barriers[i];
    if (nearest.side(barriers[i]) < 0) return CellEnd::infeasible;
  }
  return nearest.is_beyond(limit) ? CellEnd::beyond : CellEnd::found;
}

}  // namespace

template <class Numbers>
CellEnd nearest_on_wall(BarrierIn<Numbers> wall, BarriersIn<Numbers> barriers, LimitIn<Numbers> limit, long exponent,
                        RationalPointIn<Numbers>& nearest,
                        std::type_identity_t<std::vector<BarrierIn<Numbers>>>* conflict) {
  const auto infeasible = [&](std::initializer_list<BarrierIn<Numbers>> with) {
    if (conflict == nullptr) return;
    conflict->assign(1, wall);
    for (const BarrierIn<Numbers> barrier : with)
      if (barrier != nullptr) conflict->push_back(barrier);
  };
  Candidate<Numbers> candidate(wall, exponent);
  if (candidate.is_beyond(limit)) return CellEnd::beyond;
  std::optional<Line<Numbers>> line;
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (candidate.side(barriers[i]) >= 0) continue;
    line.emplace(wall, barriers[i], exponent);
    if (!line->exists()) {
      infeasible({barriers[i]});
      return CellEnd::infeasible;
    }
    BarrierIn<Numbers> last = nullptr, against = nullptr;
    const CellEnd end = nearest_on_line<Numbers>(*line, barriers.first(i), limit, candidate, last, against);
    if (end == CellEnd::infeasible) infeasible({barriers[i], last, against});
    if (end != CellEnd::found) return end;
  }
  nearest = std::move(candidate.exact());
  return CellEnd::found;
}

template <class Numbers>
CellEnd nearest_in_cell(BarriersIn<Numbers> barriers, long exponent, RationalPointIn<Numbers>& nearest) {
  nearest = RationalPointIn<Numbers>{};
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (kernels::side(*barriers[i], nearest) >= 0) continue;
    const CellEnd end = nearest_on_wall<Numbers>(barriers[i], barriers.first(i), nullptr, exponent, nearest);
    if (end != CellEnd::found) return end;
  }
  return CellEnd::found;
}

template CellEnd nearest_on_wall(BarrierIn<AnyNumbers>, BarriersIn<AnyNumbers>, LimitIn<AnyNumbers>, long,
                                 RationalPointIn<AnyNumbers>&, std::vector<BarrierIn<AnyNumbers>>*);
template CellEnd nearest_in_cell(BarriersIn<AnyNumbers>, long, RationalPointIn<AnyNumbers>&);
template CellEnd nearest_on_wall(BarrierIn<FixedNumbers>, BarriersIn<FixedNumbers>, LimitIn<FixedNumbers>, long,
                                 RationalPointIn<FixedNumbers>&, std::vector<BarrierIn<FixedNumbers>>*);
template CellEnd nearest_in_cell(BarriersIn<FixedNumbers>, long, RationalPointIn<FixedNumbers>&);

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
