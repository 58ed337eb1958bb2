// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/least_norm.hpp"

#include <initializer_list>

namespace fathom::unions {
namespace {

using kernels::RationalPoint;

// The line in which two planes meet.
class Line {
 public:
  Line(Barrier g, Barrier h, long exponent) : g_(g), h_(h), direction_(cross(g->normal, h->normal)), exponent_(exponent) {}

  [[nodiscard]] bool exists() const { return !is_zero(direction_); }

  // Its point nearest to O.
  [[nodiscard]] RationalPoint foot() const {
    return kernels::rational_point(g_->height * cross(h_->normal, direction_) + h_->height * cross(direction_, g_->normal),
                                   dot(direction_, direction_), exponent_);
  }
  // The sign of the direction in which the line leads beyond a plane: 0 if it is parallel to it.
  [[nodiscard]] int leads_beyond(Barrier e) const { return sgn(dot(direction_, e->normal)); }
  [[nodiscard]] RationalPoint meeting(Barrier e) const {
    return kernels::rational_point(
        g_->height * cross(h_->normal, e->normal) + h_->height * cross(e->normal, g_->normal) + e->height * direction_,
        dot(direction_, e->normal), exponent_);
  }

 private:
  Barrier g_, h_;
  Vector direction_;
  long exponent_;
};

// On the line the point only moves away from its foot, to one side: it ends as soon as it would have to go back. Sets `last` and `against`
// to the barriers that leave nothing of the line, or one of them to null.
CellEnd nearest_on_line(const Line& line, std::span<const Barrier> barriers, const kernels::SquaredDistance* limit, RationalPoint& nearest,
                        Barrier& last, Barrier& against) {
  nearest = line.foot();
  int way = 0;
  std::size_t moved = 0;  // barriers before this one were met before the last move
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (kernels::side(*barriers[i], nearest) >= 0) continue;
    const int to = line.leads_beyond(barriers[i]);
    against = barriers[i];
    if (to == 0) last = nullptr;
    if (to == 0 || to == -way) return CellEnd::infeasible;
    way = to;
    nearest = line.meeting(barriers[i]);
    last = barriers[i];
    moved = i;
    if (limit != nullptr && kernels::compare(nearest, *limit) > 0) return CellEnd::beyond;
  }
  for (std::size_t i = 0; i < moved; ++i) {
    against = barriers[i];
    if (kernels::side(*barriers[i], nearest) < 0) return CellEnd::infeasible;
  }
  return limit != nullptr && kernels::compare(nearest, *limit) > 0 ? CellEnd::beyond : CellEnd::found;
}

}  // namespace

CellEnd nearest_on_wall(Barrier wall, std::span<const Barrier> barriers, const kernels::SquaredDistance* limit, long exponent,
                        RationalPoint& nearest, std::vector<Barrier>* conflict) {
  const auto infeasible = [&](std::initializer_list<Barrier> with) {
    if (conflict == nullptr) return;
    conflict->assign(1, wall);
    for (const Barrier barrier : with)
      if (barrier != nullptr) conflict->push_back(barrier);
  };
  nearest = kernels::rational_point(wall->height * wall->normal, dot(wall->normal, wall->normal), exponent);
  if (limit != nullptr && kernels::compare(nearest, *limit) > 0) return CellEnd::beyond;
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (kernels::side(*barriers[i], nearest) >= 0) continue;
    const Line line(wall, barriers[i], exponent);
    if (!line.exists()) {
      infeasible({barriers[i]});
      return CellEnd::infeasible;
    }
    Barrier last = nullptr, against = nullptr;
    const CellEnd end = nearest_on_line(line, barriers.first(i), limit, nearest, last, against);
    if (end == CellEnd::infeasible) infeasible({barriers[i], last, against});
    if (end != CellEnd::found) return end;
  }
  return CellEnd::found;
}

CellEnd nearest_in_cell(std::span<const Barrier> barriers, long exponent, RationalPoint& nearest) {
  nearest = RationalPoint{};
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (kernels::side(*barriers[i], nearest) >= 0) continue;
    const CellEnd end = nearest_on_wall(barriers[i], barriers.first(i), nullptr, exponent, nearest);
    if (end != CellEnd::found) return end;
  }
  return CellEnd::found;
}

}  // namespace fathom::unions
