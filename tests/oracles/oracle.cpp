// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/oracle.hpp"

#include <algorithm>
#include <ostream>

namespace fathom::oracles {

OracleAnswer answer_of(const Depth& depth) {
  OracleAnswer answer{depth.status(), depth.squared(), {}};
  for (const Optimum& optimum : depth.optima()) answer.directions.push_back(optimum.direction);
  return answer;
}

std::ostream& operator<<(std::ostream& out, const OracleAnswer& answer) {
  constexpr const char* names[] = {"penetrating", "touching", "disjoint"};
  out << names[static_cast<int>(answer.status)] << ", depth^2 " << answer.squared << ", directions";
  for (const Vector& d : answer.directions) out << " (" << d.x << ' ' << d.y << ' ' << d.z << ')';
  return out;
}

OracleAnswer nearest_half_spaces(std::span<const HalfSpace> half_spaces) {
  OracleAnswer answer{Status::penetrating, -1, {}};
  for (const HalfSpace& half_space : half_spaces) {
    if (half_space.offset < 0) return {Status::disjoint, 0, {}};
    if (half_space.offset == 0) answer.status = Status::touching;
  }
  if (answer.status == Status::touching) return {Status::touching, 0, {}};
  for (const HalfSpace& half_space : half_spaces) {
    const mpq_class squared = half_space.offset * half_space.offset / dot(half_space.normal, half_space.normal);
    if (answer.squared >= 0 && squared > answer.squared) continue;
    if (squared != answer.squared) answer.directions.clear();
    answer.squared = squared;
    answer.directions.push_back(primitive(half_space.normal));
  }
  std::ranges::sort(answer.directions, lexicographically_less);
  answer.directions.erase(std::unique(answer.directions.begin(), answer.directions.end()), answer.directions.end());
  return answer;
}

IntegerBodies integer_bodies(std::span<const Point> a, std::span<const Point> b) {
  IntegerBodies result;
  for (const auto& points : {a, b})
    for (const Point& p : points)
      for (const mpq_class* value : {&p.x, &p.y, &p.z}) result.denominator = lcm(result.denominator, value->get_den());
  const auto integer = [&result](const mpq_class& value) {
    return mpz_class(value.get_num() * (result.denominator / value.get_den()));
  };
  for (const Point& p : a) result.a.push_back({integer(p.x), integer(p.y), integer(p.z)});
  for (const Point& p : b) result.b.push_back({integer(p.x), integer(p.y), integer(p.z)});
  return result;
}

}  // namespace fathom::oracles
