// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/lazy_integer.hpp"

#include <algorithm>
#include <optional>

#include "kernels/filters/plane.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {
namespace {

// The one with the smaller error.
void tighten(WideEnclosure& x, const WideEnclosure& other) {
  if (other.error() < x.error()) x = other;
}

}  // namespace

// A known integer; or a sum of products, each of two operands or of one alone; or the minor (q1 -
// p1)(r2 - p2) - (q2 - p2)(r1 - p1) of the operands p1, q1, r1, p2, q2, r2.
struct LazyInteger::Node {
  enum class Kind : std::uint8_t { known, products, minor };
  struct Product {
    Node *left, *right;
    bool minus;
  };

  WideEnclosure enclosure;
  mpz_class value;  // if it is known
  std::array<Node*, 6> operands{};
  std::array<bool, 3> minus{};  // of products
  Kind kind = Kind::known;
  std::uint32_t users = 1;

  // The integer is known; the operands are those of an unknown one no longer.
  void forget_operands() {
    kind = Kind::known;
    for (Node*& node : operands) drop(std::exchange(node, nullptr));
  }
};

thread_local std::uint64_t LazyInteger::computed_ = 0;

LazyInteger::Node* LazyInteger::keep(Node* node) {
  if (node != nullptr) ++node->users;
  return node;
}

void LazyInteger::drop(Node* node) {
  if (node == nullptr || --node->users > 0) return;
  node->forget_operands();
  delete node;
}

LazyInteger::LazyInteger(mpz_class value) : node_(new Node) {
  node_->enclosure = WideEnclosure(value);
  node_->value = std::move(value);
}

const mpz_class& LazyInteger::value_of(Node& node) {
  if (node.kind == Node::Kind::known) return node.value;
  ++computed_;
  const auto operand = [&](std::size_t k) -> const mpz_class& { return value_of(*node.operands[k]); };
  if (node.kind == Node::Kind::minor) {
    const mpz_class &p1 = operand(0), &p2 = operand(3);
    node.value = (operand(1) - p1) * (operand(5) - p2) - (operand(4) - p2) * (operand(2) - p1);
  } else {
    static const mpz_class one = 1;
    for (std::size_t k = 0; k < 3 && node.operands[2 * k] != nullptr; ++k) {
      const mpz_class &left = operand(2 * k), &right = node.operands[2 * k + 1] == nullptr ? one : operand(2 * k + 1);
      (node.minus[k] ? mpz_submul : mpz_addmul)(node.value.get_mpz_t(), left.get_mpz_t(), right.get_mpz_t());
    }
  }
  node.enclosure = WideEnclosure(node.value);
  node.forget_operands();
  return node.value;
}

const WideEnclosure& LazyInteger::enclosure() const { return node_->enclosure; }
bool LazyInteger::known() const { return node_->kind == Node::Kind::known; }

int sgn(const LazyInteger& a) {
  if (const auto sure = a.enclosure().sign()) return to_int(*sure);
  return sgn(a.exact());
}

int cmp(const LazyInteger& a, const LazyInteger& b) {
  if (const auto sure = (a.enclosure() - b.enclosure()).sign()) return to_int(*sure);
  return cmp(a.exact(), b.exact());
}

WideEnclosure LazyInteger::difference(const LazyInteger& a, const LazyInteger& b) {
  if (!a.known() || !b.known()) return a.enclosure() - b.enclosure();
  return WideEnclosure::of_difference(a.enclosure(), a.exact(), b.enclosure(), b.exact());
}

LazyInteger operator-(const LazyInteger& a) {
  auto* node = new LazyInteger::Node;
  node->enclosure = -a.enclosure();
  node->kind = LazyInteger::Node::Kind::products;
  node->operands[0] = LazyInteger::keep(a.node_);
  node->minus[0] = true;
  return LazyInteger(node);
}

LazyInteger operator-(const LazyInteger& a, const LazyInteger& b) {
  auto* node = new LazyInteger::Node;
  node->enclosure = LazyInteger::difference(a, b);
  node->kind = LazyInteger::Node::Kind::products;
  node->operands[0] = LazyInteger::keep(a.node_);
  node->operands[2] = LazyInteger::keep(b.node_);
  node->minus[1] = true;
  return LazyInteger(node);
}

LazyInteger operator+(const LazyInteger& a, const LazyInteger& b) { return a - -b; }

LazyInteger operator*(const LazyInteger& a, const LazyInteger& b) {
  auto* node = new LazyInteger::Node;
  node->enclosure = a.enclosure() * b.enclosure();
  node->kind = LazyInteger::Node::Kind::products;
  node->operands[0] = LazyInteger::keep(a.node_);
  node->operands[1] = LazyInteger::keep(b.node_);
  return LazyInteger(node);
}

LazyInteger dot(const Vec3<LazyInteger>& u, const Vec3<LazyInteger>& v) {
  auto* node = new LazyInteger::Node;
  node->enclosure = dot(enclosure(u), enclosure(v));
  node->kind = LazyInteger::Node::Kind::products;
  std::size_t k = 0;
  for (const LazyInteger* c : {&u.x, &v.x, &u.y, &v.y, &u.z, &v.z}) node->operands[k++] = LazyInteger::keep(c->node_);
  return LazyInteger(node);
}

Vec3<LazyInteger> cross(const Vec3<LazyInteger>& u, const Vec3<LazyInteger>& v) {
  const auto component = [](const LazyInteger& a, const LazyInteger& b, const LazyInteger& c, const LazyInteger& d) {
    auto* node = new LazyInteger::Node;
    node->enclosure = a.enclosure() * b.enclosure() - c.enclosure() * d.enclosure();
    node->kind = LazyInteger::Node::Kind::products;
    std::size_t k = 0;
    for (const LazyInteger* operand : {&a, &b, &c, &d}) node->operands[k++] = LazyInteger::keep(operand->node_);
    node->minus[1] = true;
    return LazyInteger(node);
  };
  return {component(u.y, v.z, u.z, v.y), component(u.z, v.x, u.x, v.z), component(u.x, v.y, u.y, v.x)};
}

// The minor of each two edges is the same number.
LazyInteger LazyInteger::minor(const std::array<const Vec3<LazyInteger>*, 3>& points,
                               const std::array<Vec3<WideEnclosure>, 3>& edges, int i, int j) {
  auto* node = new Node;
  node->kind = Node::Kind::minor;
  for (std::size_t k = 0; k < 3; ++k) {
    node->operands[k] = keep(coordinate(*points[k], i).node_);
    node->operands[k + 3] = keep(coordinate(*points[k], j).node_);
  }
  for (std::size_t k = 0; k < 3 && (k == 0 || !node->enclosure.has_digits()); ++k) {
    const Vec3<WideEnclosure>&e = edges[k], &f = edges[(k + 1) % 3];
    const WideEnclosure found = coordinate(e, i) * coordinate(f, j) - coordinate(e, j) * coordinate(f, i);
    if (k == 0) node->enclosure = found;
    else tighten(node->enclosure, found);
  }
  return LazyInteger(node);
}

std::pair<Vec3<LazyInteger>, LazyInteger> plane_through(const Vec3<LazyInteger>& p, const Vec3<LazyInteger>& q,
                                                        const Vec3<LazyInteger>& r) {
  const std::array edges{enclosure_of_difference(q, p), enclosure_of_difference(r, q), enclosure_of_difference(p, r)};
  const auto minor = [&](int i, int j) { return LazyInteger::minor({&p, &q, &r}, edges, i, j); };
  std::pair<Vec3<LazyInteger>, LazyInteger> plane{{minor(1, 2), minor(2, 0), minor(0, 1)}, {}};
  auto& [normal, height] = plane;
  height = dot(normal, p);
  for (const Vec3<LazyInteger>* other : {&q, &r})
    if (!height.enclosure().has_digits()) tighten(height.node_->enclosure, dot(enclosure(normal), enclosure(*other)));
  return plane;
}

Vec3<WideEnclosure> enclosure(const Vec3<LazyInteger>& v) {
  return {v.x.enclosure(), v.y.enclosure(), v.z.enclosure()};
}

Vec3<WideEnclosure> enclosure_of_difference(const Vec3<LazyInteger>& v, const Vec3<LazyInteger>& w) {
  return {LazyInteger::difference(v.x, w.x), LazyInteger::difference(v.y, w.y), LazyInteger::difference(v.z, w.z)};
}

bool is_zero(const Vec3<LazyInteger>& v) {
  for (const LazyInteger* c : {&v.x, &v.y, &v.z}) {
    const auto sure = c->enclosure().sign();
    if (sure && *sure != Sign::zero) return false;
  }
  return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0;
}

int order_along(const Vec3<LazyInteger>& u, const Vec3<LazyInteger>& v, const Vec3<LazyInteger>& w) {
  if (const auto sure = dot(enclosure(u), enclosure_of_difference(v, w)).sign()) return to_int(*sure);
  return sgn(dot(u, v - w).exact());
}

namespace {

Leading leading_of(const LazyInteger& n) {
  if (n.known()) return leading(n.exact().get_mpz_t());
  if (const auto sure = n.enclosure().leading()) return *sure;
  return leading(n.exact().get_mpz_t());
}

}  // namespace

double image(const LazyInteger& c, long exponent) {
  if (c.enclosure().order() - exponent < negligible_image) return 0;
  return image(leading_of(c), exponent);
}

long bit_length(const Vec3<LazyInteger>& v) {
  long most = 0;
  for (const LazyInteger* c : {&v.x, &v.y, &v.z})
    if (c->enclosure().order() > most) most = std::max(most, leading_of(*c).exponent);
  return most;
}

double root_from_above(const LazyInteger& numerator, const LazyInteger& denominator, long exponent) {
  return root_from_above(leading_of(numerator), leading_of(denominator), exponent);
}

}  // namespace fathom::kernels
