// SPDX-License-Identifier: Apache-2.0
#include "scaled.hpp"

#include <algorithm>
#include <limits>

#include "limits.hpp"

namespace fathom_check {
namespace {

constexpr std::array<Integer Vector::*, 3> axes{&Vector::x, &Vector::y, &Vector::z};

class Scaling {
 public:
  Scaling(const Certificate& certificate, Arena& integers) : c_(&certificate), integers_(&integers) {}

  ScaledBody body(const Body& body) {
    ScaledBody result;
    if (body.radius.num.sign() < 0) throw refused(body.line, "a radius is negative");
    switch (body.core) {
      case Body::Core::points:
        if (body.points.items.empty()) throw refused(body.line, "a body without points");
        make_points(body, result);
        break;
      case Body::Core::pieces:
        if (body.pieces.empty()) throw refused(body.line, "a body without pieces");
        make_points(body, result);
        break;
      case Body::Core::shape: make_shape(body, result); break;
      case Body::Core::half_space: make_half_space(body, result); break;
      case Body::Core::solid:
      case Body::Core::none: break;
    }
    return result;
  }

 private:
  Integer times(const Rational& r, const mpz_class& scale) {
    if (mpz_cmp(r.den.get_mpz_t(), scale.get_mpz_t()) == 0) return r.num;
    if (bits(scale) <= 63 && bits(r.num) <= 63) {  // the denominator divides the scale
      const Int128 product =
          Int128{to_word(scale.get_mpz_t()) / to_word(r.den.get_mpz_t())} * to_word(r.num.get_mpz_t());
      if (const auto word = static_cast<Word>(product); word == product) return integers_->keep(word);
    }
    mpz_divexact(product_.get_mpz_t(), scale.get_mpz_t(), r.den.get_mpz_t());
    mpz_mul(product_.get_mpz_t(), product_.get_mpz_t(), r.num.get_mpz_t());
    return integers_->keep(product_);
  }
  Vector times(const RationalPoint& p, const mpz_class& scale) {
    return {times(p.x, scale), times(p.y, scale), times(p.z, scale)};
  }

  void make_points(const Body& body, ScaledBody& result) {
    result.points.reserve(body.points.items.size());
    for (const RationalPoint& p : body.points.items) result.points.push_back(times(p, c_->scale));
  }

  void make_shape(const Body& body, ScaledBody& result) {
    if (body.terms.empty()) throw refused(body.line, "a shape without terms");
    for (const Term& term : body.terms) {
      if (term.empty()) throw refused(body.line, "a term without atoms");
      result.terms.emplace_back();
      for (const Atom& atom : term) {
        result.terms.back().emplace_back();
        for (const RationalPoint& vector : atom) result.terms.back().back().push_back(times(vector, c_->scale));
      }
    }
    if (body.inner.lines.empty()) throw refused(body.inner.line, "there is no inner point");
    for (std::size_t k = 0; k < body.inner.lines.size(); ++k) result.points.push_back(inner_point(body, result, k));
  }

  /// The sum, over the terms, of center + sum of y axis.
  Vector inner_point(const Body& body, const ScaledBody& shape, std::size_t k) {
    const std::size_t line = body.inner.lines[k];
    MutableVector sum;
    for (std::size_t t = 0; t < shape.terms.size(); ++t) {
      const Place& place = body.inner.items[k * shape.terms.size() + t];
      if (place.atom >= shape.terms[t].size()) throw refused(line, "the term has no atom of this number");
      const std::vector<Vector>& atom = shape.terms[t][place.atom];
      const Integer y[] = {times(place.y.x, c_->fine), times(place.y.y, c_->fine), times(place.y.z, c_->fine)};
      dot(product_, Vector{y[0], y[1], y[2]}, Vector{y[0], y[1], y[2]});
      if (product_ > c_->fine * c_->fine) throw refused(line, "parameters outside of the unit ball");
      MutableVector shift;
      for (std::size_t axis = 1; axis < atom.size(); ++axis) {
        mpz_addmul(shift.x.get_mpz_t(), y[axis - 1].get_mpz_t(), atom[axis].x.get_mpz_t());
        mpz_addmul(shift.y.get_mpz_t(), y[axis - 1].get_mpz_t(), atom[axis].y.get_mpz_t());
        mpz_addmul(shift.z.get_mpz_t(), y[axis - 1].get_mpz_t(), atom[axis].z.get_mpz_t());
      }
      const auto place_coordinate = [this](mpz_class& coordinate, mpz_class& moved, const Integer& center) {
        mpz_divexact(moved.get_mpz_t(), moved.get_mpz_t(), c_->fine.get_mpz_t());  // the parameters are over `fine`
        coordinate += moved;
        mpz_add(coordinate.get_mpz_t(), coordinate.get_mpz_t(), center.get_mpz_t());
      };
      place_coordinate(sum.x, shift.x, atom[0].x);
      place_coordinate(sum.y, shift.y, atom[0].y);
      place_coordinate(sum.z, shift.z, atom[0].z);
    }
    return kept(*integers_, sum);
  }

  void make_half_space(const Body& body, ScaledBody& result) {
    const RationalPoint& m = body.normal;
    const mpz_class common = lcm(lcm(m.x.den.value(), m.y.den.value()), m.z.den.value());
    result.normal = times(m, common);
    if (is_zero(result.normal)) throw refused(body.line, "the normal of a half-space is zero");
    result.offset = mpq_class(body.offset.num.value() * common * c_->scale, body.offset.den.value());
    result.offset.canonicalize();
  }

  const Certificate* c_;
  Arena* integers_;
  mpz_class product_;
};

/// Returns false if a coordinate does not fit.
bool make_words(ScaledBody& body) {
  const auto fits = [](const Vector& p) { return std::max({bits(p.x), bits(p.y), bits(p.z)}) <= most_bits_of_words; };
  if (!std::all_of(body.points.begin(), body.points.end(), fits)) return false;
  body.words.reserve(body.points.size());
  for (const Vector& p : body.points)
    body.words.push_back({to_word(p.x.get_mpz_t()), to_word(p.y.get_mpz_t()), to_word(p.z.get_mpz_t())});
  return true;
}

/// The least that no coordinate of this axis has fewer of; 0 if all are 0.
mp_bitcnt_t common_zeros(const Scaled& bodies, Integer Vector::*axis) {
  mp_bitcnt_t least = std::numeric_limits<mp_bitcnt_t>::max();
  for (const ScaledBody* const body : {&bodies.a, &bodies.b})
    for (const Vector& p : body->points)
      if ((p.*axis).sign() != 0) least = std::min(least, mpz_scan1((p.*axis).get_mpz_t(), 0));
  return least == std::numeric_limits<mp_bitcnt_t>::max() ? 0 : least;
}

void leave_zeros_out(Scaled& bodies) {
  mpz_class shifted;
  bodies.a.words.clear(), bodies.b.words.clear();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const mp_bitcnt_t zeros = bodies.units.zeros[i] = common_zeros(bodies, axes[i]);
    for (ScaledBody* const body : {&bodies.a, &bodies.b}) {
      for (Vector& p : body->points) {
        mpz_tdiv_q_2exp(shifted.get_mpz_t(), (p.*axes[i]).get_mpz_t(), zeros);
        p.*axes[i] = bodies.integers.keep(shifted);
      }
    }
  }
}

}  // namespace

void Units::make_equal(MutableVector& n) const {
  if (equal()) return;
  const mp_bitcnt_t most = largest();
  n.x <<= most - zeros[0], n.y <<= most - zeros[1], n.z <<= most - zeros[2];
}

long Units::take(MutableVector& n) const {
  if (equal()) return 0;
  const std::array<mpz_class*, 3> entries{&n.x, &n.y, &n.z};
  mp_bitcnt_t common = std::numeric_limits<mp_bitcnt_t>::max();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    *entries[i] <<= zeros[i];
    if (*entries[i] != 0) common = std::min(common, mpz_scan1(entries[i]->get_mpz_t(), 0));
  }
  for (mpz_class* const entry : entries) *entry >>= common;
  return static_cast<long>(common) - static_cast<long>(largest());
}

Homogeneous homogeneous(const RationalPoint& p) {
  const mpz_class w = lcm(lcm(p.x.den.value(), p.y.den.value()), p.z.den.value());
  const auto over = [&w](const Rational& r) { return mpz_class(w / r.den.value() * r.num.value()); };
  return {{over(p.x), over(p.y), over(p.z)}, w};
}

std::vector<Homogeneous> homogeneous(const Body& body) {
  std::vector<Homogeneous> result;
  result.reserve(body.points.items.size());
  for (const RationalPoint& p : body.points.items) result.push_back(homogeneous(p));
  return result;
}

void subtract(MutableVector& difference, const Homogeneous& to, const Homogeneous& from) {
  const auto entry = [&](mpz_class& result, const mpz_class& x, const mpz_class& y) {
    mpz_mul(result.get_mpz_t(), y.get_mpz_t(), from.w.get_mpz_t());
    mpz_submul(result.get_mpz_t(), x.get_mpz_t(), to.w.get_mpz_t());
  };
  entry(difference.x, from.x.x, to.x.x), entry(difference.y, from.x.y, to.x.y), entry(difference.z, from.x.z, to.x.z);
}

Scaled scaled(const Certificate& certificate, Arithmetic arithmetic) {
  if (certificate.a.core == Body::Core::half_space && certificate.b.core == Body::Core::half_space)
    throw refused(certificate.b.line, "two half-spaces");
  Scaled result;
  Scaling scaling(certificate, result.integers);
  result.a = scaling.body(certificate.a);
  result.b = scaling.body(certificate.b);
  if (arithmetic == Arithmetic::of_any_size) return result;
  const auto make_all_words = [&result] {
    const bool a = make_words(result.a), b = make_words(result.b);
    return a && b;
  };
  if (make_all_words() || certificate.format != 1 || certificate.proof != Proof::facets) return result;
  leave_zeros_out(result);
  make_all_words();
  return result;
}

}  // namespace fathom_check
