// SPDX-License-Identifier: Apache-2.0
// The tree of cells: every t that the polytopes leave out is as far away as claimed, and the
// nearest ones are listed.
#include <algorithm>

#include "budget.hpp"
#include "combine.hpp"
#include "unions.hpp"

namespace fathom_check {
namespace {

/// Which half-spaces are done.
class Done {
 public:
  Done(const Certificate& certificate, const Bound& squared) : c_(&certificate), squared_(&squared) {
    const mpz_class& unit = certificate.of_unions.unit;
    const auto over_unit = [&unit](const Rational& r) { return mpz_class(unit / r.den.value() * r.num.value()); };
    for (const RationalPoint& t : certificate.of_unions.optima.items)
      optima_.push_back({over_unit(t.x), over_unit(t.y), over_unit(t.z)});
    std::sort(optima_.begin(), optima_.end(), ascending<MutableVector, MutableVector>);
    numerator_ = certificate.low.num.value() * certificate.scale * unit;
  }

  /// The one of the x with <n,x> >= c.
  template <class Normal>
  bool operator()(const Normal& n, const mpz_class& c) {
    if (c <= 0) return false;
    if (is_zero(n)) return true;
    reached_ = c * c;
    reached_ *= squared_->den;
    dot(needed_, n, n);
    needed_ *= squared_->num;
    if (reached_ != needed_) return reached_ > needed_;
    return is_listed(n, c);
  }

 private:
  /// The point c n / <n,n>, where c^2 = q <n,n>: it is q n / c. It is an optimum only if it is
  /// integral in the unit of the optima, to which a division is the shortest way; a fraction in
  /// lowest terms takes many times as long.
  template <class Normal>
  bool is_listed(const Normal& n, const mpz_class& c) {
    mpz_mul(den_.get_mpz_t(), c_->low.den.get_mpz_t(), c.get_mpz_t());
    const auto divide = [this](mpz_class& coordinate, const auto& entry) {
      mpz_mul(num_.get_mpz_t(), numerator_.get_mpz_t(), entry.get_mpz_t());  // c is in the units of the scaled points
      mpz_tdiv_qr(coordinate.get_mpz_t(), num_.get_mpz_t(), num_.get_mpz_t(), den_.get_mpz_t());
      return num_ == 0;
    };
    if (!divide(foot_.x, n.x) || !divide(foot_.y, n.y) || !divide(foot_.z, n.z)) return false;
    return std::binary_search(optima_.begin(), optima_.end(), foot_, ascending<MutableVector, MutableVector>);
  }

  const Certificate* c_;
  const Bound* squared_;
  std::vector<MutableVector> optima_;  ///< in units of 1 / unit
  mpz_class numerator_;                ///< that of q, in units of the points and of the optima
  mpz_class reached_, needed_, num_, den_;
  MutableVector foot_;
};

// Without recursion: a tree may be as deep as it has nodes.
class Tree {
 public:
  Tree(const Certificate& certificate, const std::vector<Plane>& facets, const Bound& squared, WorkOfTree* work)
      : polytopes_(&certificate.of_unions.polytopes),
        part_(&certificate.of_unions.tree),
        nodes_(&part_->items),
        facets_(&facets),
        work_(work),
        done_(certificate, squared),
        listed_by_(facets.size()) {}

  void check() {
    if (work_)
      for (const Plane& plane : *facets_) work_->take(0, width(plane));
    if (nodes_->size() == 0) throw refused(part_->line, "a tree has a root");
    find_open_facets();
    for (std::size_t node = 0; node < nodes_->size(); ++node) {
      if (node > 0 && !enter_next_cell()) throw refused(part_->lines[node], "the tree ends before this node");
      nodes_->splits[node] ? check_split(node) : check_leaf(node);
    }
    if (enter_next_cell()) throw refused(part_->lines.back(), "behind this node the tree goes on: a child is missing");
  }

 private:
  /// A constraint of the path: x is beyond a facet, or below it.
  struct Side {
    std::size_t facet;
    bool beyond;
  };
  /// A split on the way to the node at hand.
  struct Level {
    std::size_t node, next_child, path;  ///< how long the path to this node is
  };

  [[nodiscard]] std::size_t first_facet(std::size_t polytope) const {
    return polytope == 0 ? 0 : (*polytopes_)[polytope - 1].facets.end;
  }
  [[nodiscard]] std::size_t children(std::size_t node) const { return nodes_->ends[node] - nodes_->begin_of(node) - 1; }
  [[nodiscard]] std::size_t facet(std::size_t node, std::size_t child) const {
    const std::uint32_t* const indices = nodes_->indices.data() + nodes_->begin_of(node);
    return first_facet(indices[0]) + indices[1 + child];
  }

  /// How many digits the numbers of a plane have.
  static std::size_t width(const Plane& plane) {
    return std::max({bits(plane.normal.x), bits(plane.normal.y), bits(plane.normal.z), bits(plane.c)});
  }

  // So that a split takes no longer than it has children.
  void find_open_facets() {
    open_.resize(polytopes_->size());
    is_open_.resize(facets_->size());
    for (std::size_t s = 0; s < polytopes_->size(); ++s)
      for (std::size_t f = first_facet(s); f < (*polytopes_)[s].facets.end; ++f) {
        is_open_[f] = !done_((*facets_)[f].normal, (*facets_)[f].c.value());
        if (is_open_[f]) ++open_[s];
      }
  }

  void check_split(std::size_t node) {
    const std::size_t line = part_->lines[node], begin = nodes_->begin_of(node);
    const std::uint32_t s = nodes_->indices[begin];
    if (s >= polytopes_->size()) throw refused(line, "there is no polytope of this number");
    const std::size_t facets = (*polytopes_)[s].facets.end - first_facet(s);
    std::size_t listed = 0;
    for (std::size_t child = 0; child < children(node); ++child) {
      if (nodes_->indices[begin + 1 + child] >= facets) throw refused(line, "the polytope has no facet of this number");
      const std::size_t f = facet(node, child);
      if (is_open_[f] && listed_by_[f] != node + 1) ++listed;
      listed_by_[f] = node + 1;
    }
    if (listed != open_[s]) throw refused(line, "a facet that is not done is not among the children");
    levels_.push_back({node, 0, path_.size()});
  }

  /// Goes on to the next child of the innermost split that has one left. False if there is none:
  /// the tree is complete.
  bool enter_next_cell() {
    while (!levels_.empty() && levels_.back().next_child == children(levels_.back().node)) levels_.pop_back();
    if (levels_.empty()) return false;
    Level& level = levels_.back();
    path_.resize(level.path + level.next_child);  // of the child before, what is below it is gone
    if (level.next_child > 0) path_.back().beyond = false;
    path_.push_back({facet(level.node, level.next_child), true});
    ++level.next_child;
    return true;
  }

  void check_leaf(std::size_t node) {
    const std::size_t line = part_->lines[node], begin = nodes_->begin_of(node), count = nodes_->ends[node] - begin;
    if (count > most_constraints) throw refused(line, "a leaf has at most four constraints");
    std::vector<Constraint> constraints;
    std::size_t widest = 0;
    for (std::size_t k = begin; k < nodes_->ends[node]; ++k) {
      if (nodes_->indices[k] >= path_.size()) throw refused(line, "the path has no constraint of this number");
      const Side side = path_[nodes_->indices[k]];
      const Plane& plane = (*facets_)[side.facet];
      widest = std::max(widest, width(plane));
      if (side.beyond) {
        constraints.push_back({copied(plane.normal), plane.c.value()});
      } else {
        constraints.push_back({negated(plane.normal), -plane.c.value()});
      }
    }
    if (work_ && count > 0) work_->take(count, widest);
    const std::optional<Constraint> sum = combined(constraints);
    if (!sum) throw refused(line, "these constraints have no multipliers that are not negative");
    if (!done_(sum->n, sum->c)) throw refused(line, "these constraints leave a place that is nearer, or not listed");
  }

  const std::vector<InnerPolytope>* polytopes_;
  const Part<Nodes>* part_;
  const Nodes* nodes_;
  const std::vector<Plane>* facets_;  ///< of all polytopes, one after another
  WorkOfTree* work_;
  Done done_;
  std::vector<std::size_t> open_;       ///< for each polytope, how many of its facets are not done
  std::vector<bool> is_open_;           ///< for each facet
  std::vector<std::size_t> listed_by_;  ///< for each facet, 1 + the last split that lists it
  std::vector<Level> levels_;
  std::vector<Side> path_;
};

}  // namespace

void check_tree(const Certificate& certificate, const std::vector<Plane>& facets, const Bound& squared,
                WorkOfTree* work) {
  Tree(certificate, facets, squared, work).check();
}

}  // namespace fathom_check
