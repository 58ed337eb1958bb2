// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/accepted.hpp"

#include <algorithm>
#include <optional>

#include "kernels/number/ratio.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"

namespace fathom::golden {

void take_accepted(std::string_view text, const std::string& id, const std::function<void(const fathom_check::Certificate&)>& take) {
  fathom_check::Lines lines(text, fathom_check::longest_line);
  fathom_check::Reader reader(lines);
  std::optional<std::string> refusal;
  const auto verdict = reader.next([&](const fathom_check::Certificate& certificate) {
    try {
      if (certificate.id != id) throw NotProved("the certificate is that of another record, '" + certificate.id + "'");
      take(certificate);
    } catch (const NotProved& fault) {
      refusal = fault.what();
    }
  });
  if (!verdict || !verdict->accepted())
    throw NotProved("the certificate is not accepted: " + (verdict ? fathom_check::verdict_line(*verdict, id) : ""));
  if (refusal) throw NotProved(*refusal);
  if (reader.next()) throw NotProved("expected one certificate, found more");
}

mpq_class value_of(const fathom_check::Rational& q) { return kernels::ratio(q.num.value(), q.den.value()); }
Point value_of(const fathom_check::RationalPoint& p) { return {value_of(p.x), value_of(p.y), value_of(p.z)}; }
Vector value_of(const fathom_check::Vector& v) { return {v.x.value(), v.y.value(), v.z.value()}; }

bool same(const Point& p, const fathom_check::RationalPoint& q) {
  const auto equal = [](const mpq_class& x, const fathom_check::Rational& y) {
    return x.get_num() * y.den.value() == y.num.value() * x.get_den();
  };
  return equal(p.x, q.x) && equal(p.y, q.y) && equal(p.z, q.z);
}

bool same(const std::vector<Point>& points, const std::vector<fathom_check::RationalPoint>& others) {
  return std::equal(points.begin(), points.end(), others.begin(), others.end(), [](const auto& p, const auto& q) { return same(p, q); });
}

}  // namespace fathom::golden
