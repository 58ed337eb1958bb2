// SPDX-License-Identifier: Apache-2.0
// Which checks belong to which claim about unions; separations, of which all of them have some.
#include <algorithm>
#include <array>
#include <optional>

#include "checks.hpp"
#include "limits.hpp"

namespace fathom_check {

namespace {

void check_pieces(const Body& body, const ScaledBody& scaled) {
  for (std::size_t k = 0; k < body.pieces.size(); ++k)
    if (const Points points = piece(body, scaled, k); !has_interior(points.begin(), points.end()))
      throw refused(body.pieces[k].line, "the points of this piece lie in one plane");
}

class Separations {
 public:
  Separations(const Certificate& certificate, const Scaled& bodies, const Bound& low)
      : c_(&certificate), bodies_(&bodies), separation_(certificate, low) {}

  /// The list of this number, for the place t / den.
  void check(std::size_t list, const MutableVector& t, const mpz_class& den) {
    const UnionParts& parts = c_->of_unions;
    const std::size_t first = begin_of(parts.separation_lists, list), count = parts.separation_lists[list].end - first;
    const std::size_t m = c_->a.pieces.size(), n = c_->b.pieces.size();
    if (count != m * n)
      throw refused(parts.separation_lists[list].line, "there is not one separation for each pair of pieces");
    for (std::size_t k = 0; k < count; ++k) {
      const Vector& u = parts.separations.items[first + k];
      find_height(u, k / n, k % n);
      separation_.check(u, height_, 1, t, den, parts.separations.lines[first + k]);
    }
  }

 private:
  /// h_ij(u), in units of 1 / scale.
  void find_height(const Vector& u, std::size_t i, std::size_t j) {
    find_largest(height_, scratch_, u, piece(c_->b, bodies_->b, j));
    find_largest(of_a_, scratch_, negated(u), piece(c_->a, bodies_->a, i));
    height_ += of_a_;
  }

  const Certificate* c_;
  const Scaled* bodies_;
  Separation separation_;
  mpz_class height_, of_a_, scratch_;
};

bool below(const Rational& r, const Rational& s) {
  return r.num.value() * s.den.value() < s.num.value() * r.den.value();
}

bool below(const RationalPoint& p, const RationalPoint& q) {
  if (!same(p.x, q.x)) return below(p.x, q.x);
  if (!same(p.y, q.y)) return below(p.y, q.y);
  return below(p.z, q.z);
}

}  // namespace

void require_pieces(const Certificate& c, std::size_t i, std::size_t j, std::size_t line) {
  if (i >= count_pieces(c.a)) throw refused(line, "a has no piece of this number");
  if (j >= count_pieces(c.b)) throw refused(line, "b has no piece of this number");
}

Points piece(const Body& body, const ScaledBody& scaled, std::size_t number) {
  return {scaled.points, scaled.words, begin_of(body.pieces, number), body.pieces[number].end};
}

void Separation::check(const Vector& u, const mpz_class& num, const mpz_class& den, const MutableVector& t,
                       const mpz_class& den_t, std::size_t line) {
  if (is_zero(u)) throw refused(line, "a direction that is zero proves nothing");
  const bool gap = c_->claim == Claim::apart;
  if (gap) {
    dot(reached_, u, u);
    reached_ *= low_->num;  // which is negative
    reached_ *= den * den;
    needed_ = num * num;
    needed_ *= low_->den;
  } else {
    dot(reached_, u, t);
    reached_ *= c_->scale * den;
    needed_ = num * den_t;
  }
  if (gap ? num >= 0 : reached_ < needed_) throw refused(line, "this direction does not separate the two pieces");
  if (gap && needed_ < -reached_) throw refused(line, "the two pieces may be nearer to each other than claimed");
}

void check_optima(const Certificate& c, const CheckApart& check_apart) {
  const Part<std::vector<RationalPoint>>& optima = c.of_unions.optima;
  if (optima.items.empty()) throw refused(optima.line, "there is no optimum");
  mpz_class reached;
  for (std::size_t k = 0; k < optima.items.size(); ++k) {
    const RationalPoint& p = optima.items[k];
    if (k > 0 && !below(optima.items[k - 1], p))
      throw refused(optima.lines[k], "an optimum must be above the one before it");
    const auto [t, den] = homogeneous(p);
    dot(reached, t, t);
    if (reached * c.low.den.value() != c.low.num.value() * den * den)
      throw refused(optima.lines[k], "the length of this translation is not the depth");
    check_apart(k, t, den);
  }
}

void check_unions(const Certificate& c, const Scaled& bodies, const Bound& low) {
  check_pieces(c.a, bodies.a);
  check_pieces(c.b, bodies.b);
  const UnionParts& parts = c.of_unions;
  if (c.claim == Claim::depth) {
    Separations separations(c, bodies, low);
    check_optima(c, [&separations](std::size_t optimum, const MutableVector& t, const mpz_class& den) {
      separations.check(optimum, t, den);
    });
    Arena integers;
    check_tree(c, check_polytopes(c, bodies, integers), low);
    return;
  }
  Separations(c, bodies, low).check(0, {}, 1);
  require_pieces(c, parts.nearest_a, parts.nearest_b, parts.nearest_line);
  check_weights(c, piece(c.a, bodies.a, parts.nearest_a), piece(c.b, bodies.b, parts.nearest_b), low);
}

// What a few half-spaces say together: the multipliers of a leaf.

namespace {

using Row = std::array<mpz_class, most_constraints>;
using Matrix = std::array<Row, most_constraints>;
using Indices = std::array<std::size_t, most_constraints>;

Indices without(const Indices& indices, std::size_t place) {
  Indices result = indices;
  std::copy(indices.begin() + place + 1, indices.end(), result.begin() + place);
  return result;
}

/// Of the first `size` of these rows and columns, by the first row.
mpz_class determinant(const Matrix& m, const Indices& rows, const Indices& columns, std::size_t size) {
  if (size == 0) return 1;
  if (size == 1) return m[rows[0]][columns[0]];
  mpz_class result = 0;
  const Indices below = without(rows, 0);
  for (std::size_t k = 0; k < size; ++k) {
    const mpz_class term = m[rows[0]][columns[k]] * determinant(m, below, without(columns, k), size - 1);
    k % 2 == 0 ? result += term : result -= term;
  }
  return result;
}

Matrix products(const std::vector<Constraint>& constraints) {
  Matrix result;
  for (std::size_t i = 0; i < constraints.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      dot(result[i][k], constraints[i].n, constraints[k].n);
      result[k][i] = result[i][k];
    }
  return result;
}

/// Row `i` of the adjugate of a symmetric matrix, which is its column too.
Row adjugate_row(const Matrix& m, std::size_t size, std::size_t i) {
  Row result;
  const Indices all{0, 1, 2, 3};
  for (std::size_t k = 0; k < size; ++k) {
    result[k] = determinant(m, without(all, i), without(all, k), size - 1);
    if ((i + k) % 2 == 1) result[k] = -result[k];
  }
  return result;
}

bool is_zero(const Row& row) {
  return std::all_of(row.begin(), row.end(), [](const mpz_class& x) { return x == 0; });
}

mpz_class level(const std::vector<Constraint>& constraints, const Row& multipliers) {
  mpz_class result = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) result += multipliers[i] * constraints[i].c;
  return result;
}

/// The column of the adjugate for four normals, less a positive factor. As G = N N^T for the matrix
/// N of the normals, whose rank is at most three, entry (i, k) of its adjugate is (-1)^(i+k) d_i
/// d_k, with the determinant d_i of the three normals besides i (Cauchy and Binet).
std::optional<Row> dependency(const std::vector<Constraint>& four) {
  MutableVector first, second;
  cross(first, four[0].n, four[1].n);
  cross(second, four[2].n, four[3].n);
  Row row;
  dot(row[0], four[1].n, second);
  dot(row[1], four[0].n, second);
  dot(row[2], first, four[3].n);
  dot(row[3], first, four[2].n);
  row[1] = -row[1];
  row[3] = -row[3];
  const auto known = std::find_if(row.begin(), row.end(), [](const mpz_class& x) { return x != 0; });
  if (known == row.end()) return std::nullopt;
  if (*known < 0)
    for (mpz_class& x : row) x = -x;
  return row;
}

/// By the adjugate of the Gram matrix.
std::optional<Row> multipliers(const std::vector<Constraint>& constraints) {
  const std::size_t size = constraints.size();
  if (size == most_constraints) return dependency(constraints);
  const Matrix gram = products(constraints);
  Row row = adjugate_row(gram, size, 0);
  mpz_class determinant = 0;
  for (std::size_t k = 0; k < size; ++k) determinant += gram[0][k] * row[k];
  if (determinant == 0) {
    for (std::size_t i = 1; is_zero(row) && i < size; ++i) row = adjugate_row(gram, size, i);
    return is_zero(row) ? std::nullopt : std::optional(row);
  }
  Row result;
  result[0] = level(constraints, row);
  for (std::size_t i = 1; i < size; ++i) result[i] = level(constraints, adjugate_row(gram, size, i));
  return result;
}

}  // namespace

std::optional<Constraint> combined(const std::vector<Constraint>& constraints) {
  const std::size_t size = constraints.size();
  if (size == 0 || size > most_constraints) return std::nullopt;
  const std::optional<Row> l = multipliers(constraints);
  if (!l || std::any_of(l->begin(), l->end(), [](const mpz_class& x) { return x < 0; })) return std::nullopt;
  Constraint result{{}, level(constraints, *l)};
  if (size == most_constraints) return result;  // the normals add up to O
  for (std::size_t i = 0; i < size; ++i) {
    result.n.x += (*l)[i] * constraints[i].n.x;
    result.n.y += (*l)[i] * constraints[i].n.y;
    result.n.z += (*l)[i] * constraints[i].n.z;
  }
  return result;
}

// The tree of cells: every t that the polytopes leave out is as far away as claimed, and the
// nearest ones are listed.

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

  [[nodiscard]] std::size_t children(std::size_t node) const { return nodes_->ends[node] - nodes_->begin_of(node) - 1; }
  [[nodiscard]] std::size_t facet(std::size_t node, std::size_t child) const {
    const std::uint32_t* const indices = nodes_->indices.data() + nodes_->begin_of(node);
    return (*polytopes_)[indices[0]].first_facet + indices[1 + child];
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
      for (std::size_t f = (*polytopes_)[s].first_facet; f < (*polytopes_)[s].facets.end; ++f) {
        is_open_[f] = !done_((*facets_)[f].normal, (*facets_)[f].c.value());
        if (is_open_[f]) ++open_[s];
      }
  }

  void check_split(std::size_t node) {
    const std::size_t line = part_->lines[node], begin = nodes_->begin_of(node);
    const std::uint32_t s = nodes_->indices[begin];
    if (s >= polytopes_->size()) throw refused(line, "there is no polytope of this number");
    const std::size_t facets = (*polytopes_)[s].facets.end - (*polytopes_)[s].first_facet;
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
