// SPDX-License-Identifier: GPL-3.0-or-later
// The segment trees. A node's strip is [first, last) in elementary strips, of which strip i lies
// between walls i - 1 and i; the first and the last are unbounded. The trees are never stored: a
// depth-first descent carries, strip by strip, the arcs that still concern it.
#include "reference/canonical/canonical_subsets.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "kernels/predicates/direction.hpp"
#include "reference/chart/chart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::canonical {

namespace {

// The strips over which a chart arc runs. An end at infinity lies strictly inside no strip.
Strip strips_of(const chart::Charts& charts, gaussian::Colour colour, chart::ChartArcId arc) {
  const chart::ColourChart& chart = charts.of[colour];
  const chart::ChartArc& a = chart.arcs[arc];
  const auto strips = static_cast<std::uint32_t>(charts.walls.size() + 1);
  return {a.left != chart::at_infinity ? chart.wall_of[a.left].value + 1 : 0,
          a.right != chart::at_infinity ? chart.wall_of[a.right].value + 1 : strips};
}

}  // namespace

// The queries that one node of a segment tree has answered, filed under the canonical subsets that
// they cross. Over the node's list of stored arcs stands a balanced tree in heap order, whose
// subtrees are the canonical subsets.
class Filing {
 public:
  struct Entry {
    std::uint64_t subset;  ///< index in the heap, then the sense of crossing in the lowest bit
    chart::ChartArcId query;
  };

  Filing(const chart::Charts& charts, gaussian::Colour query_of);

  [[nodiscard]] bool empty() const { return entries_.empty(); }

  /// Files the query under the subsets that make up [low, high) of a list of `size` arcs.
  void file(std::size_t size, std::size_t low, std::size_t high, bool rising, chart::ChartArcId query) {
    const std::size_t leaves = std::bit_ceil(size);
    for (std::size_t first = leaves + low, last = leaves + high; first < last; first /= 2, last /= 2) {
      if (first % 2 == 1) entries_.push_back({2 * first++ + rising, query});
      if (last % 2 == 1) entries_.push_back({2 * --last + rising, query});
    }
  }

  /// Calls visit(first, last, rising, entries) for each subset [first, last) and sense that has
  /// entries, these in the order in which they cross the stored arcs from left to right. Afterwards
  /// nothing is filed.
  template <class Visit>
  void take(std::size_t size, Visit visit) {
    sort();
    const std::size_t leaves = std::bit_ceil(size);
    for (std::size_t i = 0, j = 0; i < entries_.size(); i = j) {
      while (j < entries_.size() && entries_[j].subset == entries_[i].subset) ++j;
      const std::size_t heap = entries_[i].subset / 2, width = leaves / std::bit_floor(heap);
      const std::size_t first = (heap - std::bit_floor(heap)) * width;
      visit(first, std::min(first + width, size), entries_[i].subset % 2 == 1,
            std::span<const Entry>(entries_).subspan(i, j - i));
    }
    entries_.clear();
  }

 private:
  void sort();

  kernels::IdVector<chart::ChartArcId, Strip> strips_;  // of the query colour's arcs
  std::vector<Entry> entries_;
};

Filing::Filing(const chart::Charts& charts, gaussian::Colour query_of) {
  strips_.reserve(charts.of[query_of].arcs.size());
  for (const chart::ChartArcId i : charts.of[query_of].arcs.ids()) strips_.push_back(strips_of(charts, query_of, i));
}

// Within one subset and sense: of two queries whose x-ranges overlap, a rising arc crosses later
// than one above it and a falling arc later than one below it, and ids are in height order; of two
// others the left one crosses first. [proofs/canonical_subsets.md, "Grid"]
void Filing::sort() {
  std::ranges::sort(entries_, [&](const Entry& e, const Entry& f) {
    if (e.subset != f.subset) return e.subset < f.subset;
    if (e.query == f.query) return false;
    const Strip& s = strips_[e.query];
    const Strip& t = strips_[f.query];
    if (!s.overlaps(t)) return s.first < t.first;
    return (e.subset % 2 == 1) == (e.query > f.query);
  });
}

struct Stored {
  chart::ChartArcId arc;
  Strip strips;
};

// What is known of a query's height over one abscissa: stored arcs over it with an id below `above`
// pass below the query, those with an id from `below` on pass above it. The rest has to be asked.
struct Reach {
  chart::ChartArcId above, below = chart::ChartArcId::none();
};

// A query with its reach at the left and at the right end of its part in the strip.
struct Query {
  chart::ChartArcId arc;
  Strip strips;
  Reach left, right;
};

namespace {

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
    if (stored_of_ == gaussian::Colour::b)
      std::erase_if(queries, [&](const Query& q) { return !q.strips.ends_inside(root_); });
    std::vector<Stored> partial;
    list_.clear();
    for (const chart::ChartArcId i : stored_arcs_.ids())
      sort_in({i, strips_of(charts_, stored_of_, i)}, root_, partial);
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

  // `stored` overlap the strip and do not span it; `queries` end inside it. T_A: these query both
  // children, if they overlap them. T_B: they query the children that they end inside. Depth is the
  // binary logarithm of the number of walls.
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
        if (!(stored_of_ == gaussian::Colour::a ? q.strips.overlaps(children[side])
                                                : q.strips.ends_inside(children[side])))
          continue;
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

  // Calls search(test), where test(arc) says whether the query passes above a stored arc on the
  // wall between strips `wall` - 1 and `wall`. The wall is not at infinity: a query that reaches
  // infinity ends there.
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
      return chart::above_on_wall(kernel_, charts_, query_of_, q, stored_of_, stored_arcs_[s], w) ==
             kernels::Sign::positive;
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

  // Where the list passes from below to above the query on a wall. Only a gap asks predicates, and
  // the reach learns from the answers.
  Iterator rank(chart::ChartArcId query, std::uint32_t wall, Reach& reach, Gap gap, Iterator hint) {
    if (gap.size() == 0) return gap.first;
    hint = std::clamp(hint, gap.first, gap.last);
    const Iterator found =
        with_test(query, wall, [&](const auto& test) { return partition_point_near(gap.first, gap.last, hint, test); });
    if (found != gap.first) reach.above = std::prev(found)->next();
    if (found != gap.last) reach.below = *found;
    return found;
  }

  // The query crosses all arcs that are below it at one end of its part in the strip and above it
  // at the other. Most cross none, and where the one end lies is a good guess for the other.
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

  // Turns the filed queries into pairs (A_i, B_i), one for each canonical subset and sense of
  // crossing.
  void file(Strip strip) {
    if (filing_.empty()) return;
    const std::uint64_t base = append(stored_of_, list_).first;
    filing_.take(list_.size(),
                 [&](std::size_t first, std::size_t last, bool rising, std::span<const Filing::Entry> entries) {
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
  for (const gaussian::Colour stored_of : gaussian::both_colours)
    CanonicalBuilder(context, kernel, charts, stored_of, result).run();
  return result;
}

// The naive twin: all pairs of arcs.
std::vector<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>> crossings_naive(const chart::Charts& charts) {
  std::vector<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>> result;
  PredicateCounts uncounted;
  const kernels::PerturbedKernel kernel(charts.perturbation, uncounted);
  const gaussian::GaussianDiagram &a = *charts.of.a.diagram, &b = *charts.of.b.diagram;
  for (const gaussian::ArcId i : a.arcs.ids()) {
    for (const gaussian::ArcId j : b.arcs.ids()) {
      const kernels::Direction& d = a.arcs[i].circle;
      const kernels::Direction& g = b.arcs[j].circle;
      for (const kernels::Sign sign : gaussian::perturbed_crossings(kernel, a, a.arcs[i], b, b.arcs[j])) {
        if (sign * kernel.order_at_infinity(d, g, charts.frame.z) == kernels::Sign::positive)
          result.emplace_back(i.value, j.value);
      }
    }
  }
  return result;
}

// What the canonical pairs say about all pairs of arcs is checked, and the grid that each canonical
// pair forms.
namespace {

// Query q crosses s further left than query r does, both in one sense: at q's crossing with s, a
// rising r is still below s and a falling one above it. The crossing has the direction +-(d_q x
// d_s), and in either sense det(d_q, d_s, d_r) < 0, all d oriented upward.
bool crosses_first(const kernels::PerturbedKernel& kernel, const chart::Charts& charts, gaussian::Colour of_queries,
                   const chart::ChartArc& q, const chart::ChartArc& r, const chart::ChartArc& s) {
  const chart::ColourChart &queries = charts.of[of_queries], &stored = charts.of[gaussian::other(of_queries)];
  const kernels::Sign sign = kernel.order_at_infinity(queries.circle(q), stored.circle(s), queries.circle(r));
  return orientation(q) * orientation(r) * orientation(s) * sign == kernels::Sign::negative;
}

// The arcs of one side of a pair, or none if one of them is not an arc of the chart.
std::vector<const chart::ChartArc*> arcs_of(const chart::ColourChart& chart, const auto& ids) {
  std::vector<const chart::ChartArc*> arcs;
  for (const auto id : ids) {
    if (id.value >= chart.arcs.size()) return {};
    arcs.push_back(&chart.arcs[chart::ChartArcId(id.value)]);
  }
  return arcs;
}

void check_grid(kernels::Report& report, const kernels::PerturbedKernel& kernel, const chart::Charts& charts,
                const CanonicalPair& pair, const gaussian::PerColour<std::vector<const chart::ChartArc*>>& arcs) {
  const gaussian::Colour of_stored = pair.stored_of, of_queries = gaussian::other(of_stored);
  const std::vector<const chart::ChartArc*>&stored = arcs[of_stored], &queries = arcs[of_queries];
  for (std::size_t i = 1; i < stored.size(); ++i) {
    report.expect(
        chart::above_same_colour(kernel, charts, of_stored, *stored[i], *stored[i - 1]) == kernels::Sign::positive,
        "stored arcs are not in height order");
  }
  for (const chart::ChartArc* s : stored) {
    for (std::size_t k = 0; k < queries.size(); ++k) {
      const bool from_below =
          chart::above_far_left(kernel, charts, of_queries, *queries[k], of_stored, *s) == kernels::Sign::negative;
      report.expect(from_below == pair.rising, "a query crosses in the other sense");
      report.expect(k == 0 || crosses_first(kernel, charts, of_queries, *queries[k - 1], *queries[k], *s),
                    "queries are not in the order in which they cross");
    }
  }
}

// In the strip the query comes from one side of the stored arc and leaves on the other, unless it
// ends in there.
bool crosses_inside(const kernels::PerturbedKernel& kernel, const chart::Charts& charts, const CanonicalPair& pair,
                    const chart::ChartArc& query, Strip of_query, const chart::ChartArc& stored) {
  const gaussian::Colour of_queries = gaussian::other(pair.stored_of);
  const auto above_at = [&](std::uint32_t wall) {
    const chart::Wall& w = charts.walls[chart::WallId(wall - 1)];
    return chart::above_on_wall(kernel, charts, of_queries, query, pair.stored_of, stored, w) ==
           kernels::Sign::positive;
  };
  const bool from = pair.strip.first <= of_query.first || above_at(pair.strip.first) != pair.rising;
  const bool to = pair.strip.last >= of_query.last || above_at(pair.strip.last) == pair.rising;
  return from && to && of_query.overlaps(pair.strip);
}

void check_strip(kernels::Report& report, const kernels::PerturbedKernel& kernel, const chart::Charts& charts,
                 const CanonicalPair& pair) {
  const gaussian::Colour of_queries = gaussian::other(pair.stored_of);
  const auto ids = [&](gaussian::Colour colour) {
    std::vector<chart::ChartArcId> result;
    const auto copy = [&](const auto& arcs) {
      for (const auto arc : arcs) result.emplace_back(arc.value);
    };
    colour == gaussian::Colour::a ? copy(pair.a) : copy(pair.b);
    return result;
  };
  const std::vector<chart::ChartArcId> queries = ids(of_queries);
  const bool inside = pair.strip.first < pair.strip.last && pair.strip.last <= charts.walls.size() + 1;
  if (!report.expect(inside, "a strip is none of the chart")) return;
  for (const chart::ChartArcId s : ids(pair.stored_of)) {
    report.expect(pair.strip.within(strips_of(charts, pair.stored_of, s)), "a stored arc does not span the strip");
    for (const chart::ChartArcId q : queries) {
      report.expect(crosses_inside(kernel, charts, pair, charts.of[of_queries].arcs[q],
                                   strips_of(charts, of_queries, q), charts.of[pair.stored_of].arcs[s]),
                    "a crossing is outside the strip");
    }
  }
}

void check_once(kernels::Report& report, const std::vector<const chart::ChartArc*>& arcs) {
  report.expect(std::set(arcs.begin(), arcs.end()).size() == arcs.size(), "C1: an edge occurs twice in a set");
}

}  // namespace

kernels::Report validate(const CanonicalSubsets& subsets, const chart::Charts& charts) {
  kernels::Report report;
  PredicateCounts uncounted;
  const kernels::PerturbedKernel kernel(charts.perturbation, uncounted);
  std::map<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>, int> reported;
  for (std::size_t k = 0; k < subsets.size(); ++k) {
    const CanonicalPair pair = subsets[k];
    report.expect(!pair.a.empty() && !pair.b.empty(), "a canonical pair has an empty side");
    const gaussian::PerColour<std::vector<const chart::ChartArc*>> arcs{arcs_of(charts.of.a, pair.a),
                                                                        arcs_of(charts.of.b, pair.b)};
    if (!report.expect(arcs.a.size() == pair.a.size() && arcs.b.size() == pair.b.size(),
                       "C1: an id is not an arc of the chart"))
      continue;
    check_once(report, arcs.a);
    check_once(report, arcs.b);
    check_strip(report, kernel, charts, pair);
    check_grid(report, kernel, charts, pair, arcs);
    for (const chart::ChartArc* e : arcs.a) {
      for (const chart::ChartArc* f : arcs.b)
        ++reported[{gaussian::EdgeOfA(e->arc.value), gaussian::EdgeOfB(f->arc.value)}];
    }
  }
  const auto name = [](const std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>& pair) {
    return "(" + std::to_string(pair.first.value) + "," + std::to_string(pair.second.value) + ")";
  };
  for (const auto& crossing : crossings_naive(charts)) {
    report.expect(reported[crossing] > 0, "C3: crossing pair " + name(crossing) + " is not reported");
    report.expect(reported[crossing] <= 1, "crossing pair " + name(crossing) + " is reported more than once");
    reported.erase(crossing);
  }
  for (const auto& [pair, count] : reported)
    report.expect(false, "C2: reported pair " + name(pair) + " does not cross");
  return report;
}

}  // namespace fathom::canonical
