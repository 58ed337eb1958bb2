// SPDX-License-Identifier: GPL-3.0-or-later
// The segment trees. A node's strip is [first, last) in elementary strips, of which strip i lies between walls i - 1 and i; the first and
// the last are unbounded. The trees are never stored: a depth-first descent carries, strip by strip, the arcs that still concern it.
#include "reference/canonical/canonical_subsets.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace fathom {
namespace {

struct Strip {
  std::uint32_t first, last;
};

// An arc with the elementary strips it spans, and the walls of its ends, strictly inside which strips a query has to look.
struct Span {
  std::uint32_t arc;  // index in the chart
  Strip strips;
  bool left_bounded, right_bounded;

  [[nodiscard]] bool spans(Strip s) const { return strips.first <= s.first && s.last <= strips.last; }
  [[nodiscard]] bool overlaps(Strip s) const { return strips.first < s.last && s.first < strips.last; }
  [[nodiscard]] bool ends_inside(Strip s) const {
    return (left_bounded && s.first < strips.first && strips.first < s.last) ||
           (right_bounded && s.first < strips.last && strips.last < s.last);
  }
};

// Strips of a colour's arcs. An unbounded end reaches to the end of the padded range, so that only the root spans a full line.
std::vector<Span> spans_of(const Charts& charts, Colour colour, std::uint32_t padded) {
  std::vector<Span> result;
  const std::vector<ChartArc>& arcs = charts.arcs_of(colour);
  result.reserve(arcs.size());
  for (std::uint32_t i = 0; i < arcs.size(); ++i) {
    const bool left = arcs[i].left != at_infinity, right = arcs[i].right != at_infinity;
    result.push_back(
        {i, {left ? charts.wall(colour, arcs[i].left) + 1 : 0, right ? charts.wall(colour, arcs[i].right) + 1 : padded}, left, right});
  }
  return result;
}

}  // namespace

// Builds T_A or T_B of one hemisphere and answers its queries.
class CanonicalBuilder {
 public:
  CanonicalBuilder(const Charts& charts, Colour stored_of, CanonicalSubsets& out)
      : charts_(charts), stored_of_(stored_of), out_(out), padded_(std::bit_ceil(static_cast<std::uint32_t>(charts.walls.size() + 1))) {}

  void run() {
    const Strip root{0, padded_};
    const std::vector<Span> queries = spans_of(charts_, other(stored_of_), padded_);
    descend(root, spans_of(charts_, stored_of_, padded_), stored_of_ == Colour::a ? queries : inside(queries, root));
  }

 private:
  // `queries` are those that query this node. T_A: they end inside the parent (at the root: any, for ends at infinity count there).
  // T_B: they end inside the node. Depth is the binary logarithm of the number of walls.
  void descend(Strip strip, const std::vector<Span>& stored, const std::vector<Span>& queries) {
    std::vector<Span> partial;
    std::vector<std::uint32_t> list;
    for (const Span& span : stored) {
      if (span.spans(strip)) {
        list.push_back(span.arc);
      } else {
        partial.push_back(span);
      }
    }
    if (!list.empty() && !queries.empty()) answer(strip, list, queries);
    if (partial.empty() || strip.last - strip.first == 1) return;
    const std::vector<Span> below = inside(queries, strip);
    if (below.empty()) return;
    const std::uint32_t middle = std::midpoint(strip.first, strip.last);
    for (const Strip child : {Strip{strip.first, middle}, Strip{middle, strip.last}}) {
      std::vector<Span> child_stored, child_queries;
      std::ranges::copy_if(partial, std::back_inserter(child_stored), [&](const Span& s) { return s.overlaps(child); });
      std::ranges::copy_if(below, std::back_inserter(child_queries),
                           [&](const Span& s) { return stored_of_ == Colour::a ? s.overlaps(child) : s.ends_inside(child); });
      if (!child_stored.empty() && !child_queries.empty()) descend(child, child_stored, child_queries);
    }
  }

  static std::vector<Span> inside(const std::vector<Span>& queries, Strip strip) {
    std::vector<Span> result;
    std::ranges::copy_if(queries, std::back_inserter(result), [&](const Span& s) { return s.ends_inside(strip); });
    return result;
  }

  const ChartArc& stored_arc(std::uint32_t i) const { return charts_.arcs_of(stored_of_)[i]; }

  // Sign of (query above stored arc) at the left, or at the right, end of the query's part in the strip.
  int query_above(const Span& query, std::uint32_t stored, Strip strip, bool at_left) const {
    const Colour query_of = other(stored_of_);
    const ChartArc& q = charts_.arcs_of(query_of)[query.arc];
    const ChartArc& s = stored_arc(stored);
    if (at_left ? strip.first < query.strips.first : query.strips.last < strip.last) {
      return node_above_arc(charts_, query_of, at_left ? q.left : q.right, stored_of_, s);
    }
    const std::uint32_t wall = at_left ? strip.first : strip.last;
    if (wall == 0) return above_far_left(charts_, query_of, q, stored_of_, s);
    if (wall > charts_.walls.size()) return -above_far_left(charts_, query_of, q, stored_of_, s);
    return above_on_wall(charts_, query_of, q, stored_of_, s, charts_.walls[wall - 1]);
  }

  // How many arcs of the sorted list lie below the query's end.
  std::size_t rank(const Span& query, const std::vector<std::uint32_t>& list, Strip strip, bool at_left) const {
    const auto above = [&](std::uint32_t stored) { return query_above(query, stored, strip, at_left) > 0; };
    return static_cast<std::size_t>(std::ranges::partition_point(list, above) - list.begin());
  }

  // Sorts the node's list, and files each query under the canonical subsets of a balanced tree over it, in heap order, that make up
  // the range it crosses: all arcs that are below it at one end and above it at the other.
  void answer(Strip strip, std::vector<std::uint32_t>& list, const std::vector<Span>& queries) {
    std::ranges::sort(list, [&](std::uint32_t e, std::uint32_t f) {
      return e != f && above_same_colour(charts_, stored_of_, stored_arc(f), stored_arc(e)) > 0;
    });
    const std::size_t leaves = std::bit_ceil(list.size());
    filed_.clear();
    for (const Span& query : queries) {
      const auto [low, high] = std::minmax({rank(query, list, strip, true), rank(query, list, strip, false)});
      for (std::size_t first = leaves + low, last = leaves + high; first < last; first /= 2, last /= 2) {
        if (first % 2 == 1) filed_.emplace_back(first++, query.arc);
        if (last % 2 == 1) filed_.emplace_back(--last, query.arc);
      }
    }
    if (!filed_.empty()) report(list, leaves);
  }

  // Turns the filed queries into pairs (A_i, B_i), one for each canonical subset that some query returned.
  void report(const std::vector<std::uint32_t>& list, std::size_t leaves) {
    const std::uint64_t base = out_.stored_.size();
    for (const std::uint32_t arc : list) out_.stored_.push_back(stored_arc(arc).arc);
    std::ranges::sort(filed_);
    const std::vector<ChartArc>& query_arcs = charts_.arcs_of(other(stored_of_));
    for (std::size_t i = 0; i < filed_.size();) {
      const std::size_t heap = filed_[i].first;
      const std::uint64_t begin = out_.queries_.size();
      for (; i < filed_.size() && filed_[i].first == heap; ++i) out_.queries_.push_back(query_arcs[filed_[i].second].arc);
      const std::size_t width = leaves / std::bit_floor(heap);
      const std::size_t first = (heap - std::bit_floor(heap)) * width;
      out_.records_.push_back({stored_of_, base + first, base + std::min(first + width, list.size()), begin, out_.queries_.size()});
    }
  }

  const Charts& charts_;
  Colour stored_of_;
  CanonicalSubsets& out_;
  std::uint32_t padded_;
  std::vector<std::pair<std::size_t, std::uint32_t>> filed_;
};

CanonicalPair CanonicalSubsets::operator[](std::size_t i) const {
  const Record& r = records_[i];
  return {r.stored_of, std::span(stored_).subspan(r.stored_begin, r.stored_end - r.stored_begin),
          std::span(queries_).subspan(r.queries_begin, r.queries_end - r.queries_begin)};
}

CanonicalSubsets::Sums CanonicalSubsets::sums() const {
  Sums sums;
  for (std::size_t i = 0; i < size(); ++i) {
    const CanonicalPair pair = (*this)[i];
    sums.a += pair.edges_of_a().size();
    sums.b += pair.edges_of_b().size();
    sums.product += static_cast<std::uint64_t>(pair.stored.size()) * pair.queries.size();
  }
  return sums;
}

CanonicalSubsets canonical_subsets(const Charts& charts) {
  CanonicalSubsets result;
  CanonicalBuilder(charts, Colour::a, result).run();
  CanonicalBuilder(charts, Colour::b, result).run();
  return result;
}

}  // namespace fathom
