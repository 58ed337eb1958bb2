// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/infinitesimal.hpp"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace fathom::kernels {

Monomial operator*(Monomial s, Monomial t) {
  for (unsigned k = 1; k <= Monomial::variables; ++k) {
    if (s.exponent(k) + t.exponent(k) > Monomial::largest_exponent)
      throw std::overflow_error("exponent of an infinitesimal");
  }
  Monomial product;
  product.packed_ = s.packed_ + t.packed_;
  return product;
}

std::string Monomial::text() const {
  std::string result;
  for (unsigned k = 1; k <= variables; ++k) {
    if (exponent(k) == 0) continue;
    if (!result.empty()) result += ' ';
    result += "e" + std::to_string(k);
    if (exponent(k) > 1) result += "^" + std::to_string(exponent(k));
  }
  return result.empty() ? "1" : result;
}

Infinitesimal::Infinitesimal(const mpz_class& constant) : Infinitesimal(Monomial(), constant) {}

Infinitesimal::Infinitesimal(Monomial monomial, const mpz_class& coefficient) {
  if (coefficient != 0) terms_.emplace_back(monomial, coefficient);
}

// Both lists are sorted; the result takes over equal monomials once and drops what cancels.
template <class Combine>
void Infinitesimal::merge(const Infinitesimal& t, Combine combine) {
  std::vector<Term> result;
  result.reserve(terms_.size() + t.terms_.size());
  auto own = terms_.begin();
  for (const Term& other : t.terms_) {
    while (own != terms_.end() && own->first < other.first) result.push_back(std::move(*own++));
    mpz_class coefficient;
    if (own != terms_.end() && own->first == other.first) coefficient = std::move((own++)->second);
    combine(coefficient, other.second);
    if (coefficient != 0) result.emplace_back(other.first, std::move(coefficient));
  }
  std::move(own, terms_.end(), std::back_inserter(result));
  terms_ = std::move(result);
}

Infinitesimal& Infinitesimal::operator+=(const Infinitesimal& t) {
  if (&t == this) return *this = *this * Infinitesimal(2);
  merge(t, [](mpz_class& s, const mpz_class& c) { s += c; });
  return *this;
}

Infinitesimal& Infinitesimal::operator-=(const Infinitesimal& t) {
  if (&t == this) return *this = Infinitesimal();
  merge(t, [](mpz_class& s, const mpz_class& c) { s -= c; });
  return *this;
}

Infinitesimal& Infinitesimal::operator*=(const Infinitesimal& t) { return *this = *this * t; }

Infinitesimal operator*(const Infinitesimal& s, const Infinitesimal& t) {
  std::vector<Infinitesimal::Term> products;
  products.reserve(s.terms_.size() * t.terms_.size());
  for (const auto& [m, c] : s.terms_) {
    for (const auto& [n, d] : t.terms_) products.emplace_back(m * n, c * d);
  }
  // A factor of one term keeps the order of the other.
  if (s.terms_.size() > 1 && t.terms_.size() > 1) std::ranges::stable_sort(products, {}, &Infinitesimal::Term::first);
  Infinitesimal result;
  for (std::size_t i = 0; i < products.size();) {
    Infinitesimal::Term sum = std::move(products[i]);
    for (++i; i < products.size() && products[i].first == sum.first; ++i) sum.second += products[i].second;
    if (sum.second != 0) result.terms_.push_back(std::move(sum));
  }
  return result;
}

Infinitesimal operator-(Infinitesimal s) {
  for (auto& [monomial, coefficient] : s.terms_) mpz_neg(coefficient.get_mpz_t(), coefficient.get_mpz_t());
  return s;
}

std::strong_ordering operator<=>(const Infinitesimal& s, const Infinitesimal& t) { return sgn(s - t) <=> 0; }

std::ostream& operator<<(std::ostream& out, const Infinitesimal& s) {
  if (s.terms().empty()) return out << '0';
  bool first = true;
  for (const auto& [monomial, coefficient] : s.terms()) {
    if (first) {
      out << (coefficient < 0 ? "-" : "");
    } else {
      out << (coefficient < 0 ? " - " : " + ");
    }
    first = false;
    const mpz_class size = abs(coefficient);
    if (monomial == Monomial()) {
      out << size;
    } else {
      if (size != 1) out << size << ' ';
      out << monomial.text();
    }
  }
  return out;
}

}  // namespace fathom::kernels
