// SPDX-License-Identifier: GPL-3.0-or-later
// The segment trees. A node's strip is [first, last) in elementary strips, of which strip i lies between walls i - 1 and i; the first and
// the last are unbounded. The trees are never stored: a depth-first descent carries, strip by strip, the arcs that still concern it.
#include "reference/canonical/canonical_subsets.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include "kernels/predicates/direction.hpp"
#include "reference/canonical/query_filing.hpp"
#include "reference/chart/chart.hpp"

namespace fathom::canonical {
namespace {

struct Stored {
  chart::ChartArcId arc;
  Strip strips;
};

// What is known of a query's height over one abscissa: stored arcs over it with an id below `above` pass below the query, those with an
// id from `below` on pass above it. The rest has to be asked.
struct Reach {
  chart::ChartArcId above, below = chart::ChartArcId::none();
};

// A query with its reach at the left and at the right end of its part in the strip.
struct Query {
  chart::ChartArcId arc;
  Strip strips;
  Reach left, right;
};

// As std::partition_point; the steps are logarithmic in the distance from the hint.
template <class Iterator, class Test>
Iterator partition_point_near(Iterator first, Iterator last, Iterator hint, const Test& test) {
  std::ptrdiff_t step = 1;
  if (hint != last && test(*hint)) {
    for (first = hint + 1; step <= last - first; step *= 2) {
      if (!test(first[step - 1])) return std::partition_point(first, first + (step - 1), test);
      first += step;
    }
    return std::partition_point(first, last, test);
  }
  for (last = hint; step <= last - first; step *= 2) {
    if (test(*(last - step))) return std::partition_point(last - step + 1, last, test);
    last -= step;
  }
  return std::partition_point(first, last, test);
}

}  // namespace

// Builds T_A or T_B of one hemisphere and answers its queries.
class CanonicalBuilder {
 public:
  CanonicalBuilder(kernels::Context& context, const kernels::PerturbedKernel& kernel, const chart::Charts& charts,
                   gaussian::Colour stored_of, CanonicalSubsets& out)
      : context_(context),
        kernel_(kernel),
        charts_(charts),
        stored_of_(stored_of),
        query_of_(gaussian::other(stored_of)),
        stored_arcs_(charts.of[stored_of].arcs),
        root_{0, static_cast<std::uint32_t>(charts.walls.size() + 1)},
        filing_(charts, query_of_),
        out_(out) {}

  void run() {
    std::vector<Query> queries = all_queries();
    if (stored_of_ == gaussian::Colour::b) std::erase_if(queries, [&](const Query& q) { return !q.strips.ends_inside(root_); });
    std::vector<Stored> partial;
    list_.clear();
    for (const chart::ChartArcId i : stored_arcs_.ids()) sort_in({i, strips_of(charts_, stored_of_, i)}, root_, partial);
    if (!list_.empty()) {
      for (Query& q : queries) ask(root_, q.arc, q.left, q.right);
      file(root_);
    }
    std::erase_if(queries, [&](const Query& q) { return !q.strips.ends_inside(root_); });
    descend(root_, std::move(partial), std::move(queries));
    kernel_.count_calls(Predicate::order_on_vertical, probed_);
  }

 private:
  using Iterator = std::vector<chart::ChartArcId>::const_iterator;

  // The ends of a query are located among the stored arcs.
  std::vector<Query> all_queries() const {
    const kernels::IdVector<chart::ChartArcId, chart::ChartArc>& arcs = charts_.of[query_of_].arcs;
    std::vector<Query> result;
    result.reserve(arcs.size());
    for (const chart::ChartArcId i : arcs.ids()) {
      const chart::ChartArcId left = arcs[i].left_height, right = arcs[i].right_height;
      result.push_back({i, strips_of(charts_, query_of_, i), {left, left}, {right, right}});
    }
    return result;
  }

  void sort_in(const Stored& stored, Strip strip, std::vector<Stored>& partial) {
    if (strip.within(stored.strips)) {
      list_.push_back(stored.arc);
    } else if (stored.strips.overlaps(strip)) {
      partial.push_back(stored);
    }
  }

  // `stored` overlap the strip and do not span it; `queries` end inside it. T_A: these query both children, if they overlap them. T_B:
  // they query the children that they end inside. Depth is the binary logarithm of the number of walls.
  void descend(Strip strip, std::vector<Stored> stored, std::vector<Query> queries) {
    if (stored.empty() || queries.empty() || strip.last - strip.first == 1) return;
    report(strip);
    const std::uint32_t middle = std::midpoint(strip.first, strip.last);
    const std::array<Strip, 2> children{{{strip.first, middle}, {middle, strip.last}}};
    std::vector<Reach> at_middle(queries.size());
    std::array<std::vector<Stored>, 2> partial;
    for (const std::size_t side : {0, 1}) {
      list_.clear();
      for (const Stored& s : stored) sort_in(s, children[side], partial[side]);
      if (list_.empty()) continue;
      for (std::size_t i = 0; i < queries.size(); ++i) {
        Query& q = queries[i];
        if (!(stored_of_ == gaussian::Colour::a ? q.strips.overlaps(children[side]) : q.strips.ends_inside(children[side]))) continue;
        ask(children[side], q.arc, side == 0 || q.strips.first >= middle ? q.left : at_middle[i],
            side == 1 || q.strips.last <= middle ? q.right : at_middle[i]);
      }
      file(children[side]);
    }
    std::array<std::vector<Query>, 2> inside;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Query& q = queries[i];
      if (q.strips.ends_inside(children[0])) {
        inside[0].push_back({q.arc, q.strips, q.left, q.strips.last <= middle ? q.right : at_middle[i]});
      }
      if (q.strips.ends_inside(children[1])) {
        inside[1].push_back({q.arc, q.strips, q.strips.first >= middle ? q.left : at_middle[i], q.right});
      }
    }
    stored = {};
    queries = {};
    at_middle = {};
    for (const std::size_t side : {0, 1}) descend(children[side], std::move(partial[side]), std::move(inside[side]));
  }

  void report(Strip strip) {
    if (++nodes_ % 256 != 0) return;
    const double share = static_cast<double>(strip.first) / root_.last;
    context_.report("canonical subsets", (share + (stored_of_ == gaussian::Colour::a ? 0 : 1)) / 2);
  }

  // Calls search(test), where test(arc) says whether the query passes above a stored arc on the wall between strips `wall` - 1 and `wall`.
  // The wall is not at infinity: a query that reaches infinity ends there.
  template <class Search>
  auto with_test(chart::ChartArcId query, std::uint32_t wall, Search search) {
    const chart::ChartArc& q = charts_.of[query_of_].arcs[query];
    const kernels::IdVector<chart::ChartArcId, Vec3<double>>& circles = charts_.of[stored_of_].circles;
    const chart::Wall& w = charts_.walls[chart::WallId(wall - 1)];
    const kernels::VerticalProbe probe(charts_.of[query_of_].circles[query], kernels::image(charts_.node(w)),
                                       kernels::image(charts_.frame.v));
    return search([&](chart::ChartArcId s) {
      if (const std::optional<kernels::Sign> sign = probe.sign(circles[s])) {
        ++probed_;
        return sign == kernels::Sign::positive;
      }
      return chart::above_on_wall(kernel_, charts_, query_of_, q, stored_of_, stored_arcs_[s], w) == kernels::Sign::positive;
    });
  }

  // The part of the node's list whose order relative to the query at a reach is not settled.
  struct Gap {
    Iterator first, last;
    [[nodiscard]] auto size() const { return last - first; }
  };

  Gap gap(const Reach& reach, Iterator from) const {
    const Iterator first = std::lower_bound(from, list_.cend(), reach.above);
    return {first, std::lower_bound(first, list_.cend(), reach.below)};
  }

  // Where the list passes from below to above the query on a wall. Only a gap asks predicates, and the reach learns from the answers.
  Iterator rank(chart::ChartArcId query, std::uint32_t wall, Reach& reach, Gap gap, Iterator hint) {
    if (gap.size() == 0) return gap.first;
    hint = std::clamp(hint, gap.first, gap.last);
    const Iterator found = with_test(query, wall, [&](const auto& test) { return partition_point_near(gap.first, gap.last, hint, test); });
    if (found != gap.first) reach.above = std::prev(found)->next();
    if (found != gap.last) reach.below = *found;
    return found;
  }

  // The query crosses all arcs that are below it at one end of its part in the strip and above it at the other. Most cross none, and
  // where the one end lies is a good guess for the other.
  void ask(Strip strip, chart::ChartArcId query, Reach& left, Reach& right) {
    const Iterator from = std::ranges::lower_bound(std::as_const(list_), std::min(left.above, right.above));
    if (from == list_.cend() || *from >= std::max(left.below, right.below)) return;
    const Gap left_gap = gap(left, from), right_gap = gap(right, from);
    Iterator at_left, at_right;
    if (left_gap.size() < right_gap.size()) {
      at_left = rank(query, strip.first, left, left_gap, left_gap.first);
      at_right = rank(query, strip.last, right, right_gap, at_left);
    } else {
      at_right = rank(query, strip.last, right, right_gap, right_gap.first);
      at_left = rank(query, strip.first, left, left_gap, at_right);
    }
    const auto index = [&](Iterator p) { return static_cast<std::size_t>(p - list_.cbegin()); };
    const auto [low, high] = std::minmax(at_left, at_right);
    filing_.file(list_.size(), index(low), index(high), at_left < at_right, query);
  }

  // Turns the filed queries into pairs (A_i, B_i), one for each canonical subset and sense of crossing.
  void file(Strip strip) {
    if (filing_.empty()) return;
    const std::uint64_t base = append(stored_of_, list_).first;
    filing_.take(list_.size(), [&](std::size_t first, std::size_t last, bool rising, std::span<const Filing::Entry> entries) {
      CanonicalSubsets::Record record{stored_of_, rising, strip, {}};
      record.arcs[stored_of_] = {base + first, base + last};
      record.arcs[query_of_] = append(query_of_, entries, &Filing::Entry::query);
      out_.records_.push_back(record);
    });
  }

  template <class Projection = std::identity>
  CanonicalSubsets::Range append(gaussian::Colour colour, const auto& arcs, Projection projection = {}) {
    const auto to = [&](auto& ids) -> CanonicalSubsets::Range {
      const std::uint64_t first = ids.size();
      for (const auto& arc : arcs) ids.emplace_back(std::invoke(projection, arc).value);
      return {first, ids.size()};
    };
    return colour == gaussian::Colour::a ? to(out_.a_) : to(out_.b_);
  }

  kernels::Context& context_;
  const kernels::PerturbedKernel& kernel_;
  const chart::Charts& charts_;
  gaussian::Colour stored_of_, query_of_;
  const kernels::IdVector<chart::ChartArcId, chart::ChartArc>& stored_arcs_;
  Strip root_;
  std::vector<chart::ChartArcId> list_;  // arcs stored at the node at hand, in height order
  Filing filing_;
  CanonicalSubsets& out_;
  std::uint64_t nodes_ = 0, probed_ = 0;
};

CanonicalPair CanonicalSubsets::operator[](std::size_t i) const {
  const Record& r = records_[i];
  return {r.stored_of, r.rising, r.strip, std::span(a_).subspan(r.arcs.a.first, r.arcs.a.last - r.arcs.a.first),
          std::span(b_).subspan(r.arcs.b.first, r.arcs.b.last - r.arcs.b.first)};
}

CanonicalSubsets::Sums CanonicalSubsets::sums() const {
  Sums sums;
  for (std::size_t i = 0; i < size(); ++i) {
    const CanonicalPair pair = (*this)[i];
    sums.a += pair.a.size();
    sums.b += pair.b.size();
    sums.product += pair.crossings();
  }
  return sums;
}

CanonicalSubsets canonical_subsets(kernels::Context& context, const chart::Charts& charts) {
  context.report("canonical subsets");
  const kernels::PerturbedKernel kernel(charts.perturbation, context.counters.predicates);
  CanonicalSubsets result;
  for (const gaussian::Colour stored_of : gaussian::both_colours) CanonicalBuilder(context, kernel, charts, stored_of, result).run();
  return result;
}

}  // namespace fathom::canonical
