// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/least_norm.hpp"

#include <initializer_list>
#include <optional>
#include <utility>

#include "kernels/filters/meeting_image.hpp"

namespace fathom::unions {
namespace {

using kernels::RationalPoint;

// The line in which two planes meet: by images, and exactly where they cannot tell.
class Line {
 public:
  Line(Barrier g, Barrier h, long exponent) : g_(g), h_(h), exponent_(exponent), image_(*g, *h) {}

  [[nodiscard]] bool exists() { return image_.surely_exists() || !is_zero(direction()); }
  // The sign of the direction in which the line leads beyond a plane: 0 if it is parallel to it.
  [[nodiscard]] int leads_beyond(Barrier e) {
    if (const auto sure = image_.leads_beyond(*e)) return kernels::to_int(*sure);
    return sgn(dot(direction(), e->normal));
  }
  [[nodiscard]] const kernels::MeetingLine& image() const { return image_; }
  // Its point nearest to O.
  [[nodiscard]] RationalPoint foot() {
    const Vector& d = direction();
    return kernels::rational_point(g_->height * cross(h_->normal, d) + h_->height * cross(d, g_->normal), dot(d, d), exponent_);
  }
  [[nodiscard]] RationalPoint meeting(Barrier e) {
    return kernels::rational_point(
        g_->height * cross(h_->normal, e->normal) + h_->height * cross(e->normal, g_->normal) + e->height * direction(),
        dot(direction(), e->normal), exponent_);
  }

 private:
  const Vector& direction() {
    if (!direction_) direction_ = cross(g_->normal, h_->normal);
    return *direction_;
  }

  Barrier g_, h_;
  long exponent_;
  kernels::MeetingLine image_;
  std::optional<Vector> direction_;
};

// The nearest point so far: the foot of the wall or of a line, or where the line meets a third plane. Most of them are asked for nothing
// that their image cannot tell, and have no exact coordinates.
class Candidate {
 public:
  Candidate(Barrier wall, long exponent) : wall_(wall), exponent_(exponent), image_(kernels::foot_image(*wall)) {}

  void move_to_foot(Line& line) { move(line, nullptr, line.image().foot()); }
  void move_to_meeting(Line& line, Barrier e) { move(line, e, line.image().meeting(*e)); }

  [[nodiscard]] int side(Barrier e) {
    if (const auto sure = kernels::sure_side(*e, image_)) return kernels::to_int(*sure);
    return kernels::side(*e, exact());
  }
  // Whether it is farther away than the limit, if there is one.
  [[nodiscard]] bool is_beyond(const kernels::SquaredDistance* limit) {
    if (limit == nullptr) return false;
    if (const auto sure = kernels::sure_order(image_, *limit)) return *sure == kernels::Sign::positive;
    return kernels::compare(exact(), *limit) > 0;
  }
  RationalPoint& exact() {
    if (!exact_) {
      if (line_ == nullptr) exact_ = kernels::rational_point(wall_->height * wall_->normal, dot(wall_->normal, wall_->normal), exponent_);
      else exact_ = third_ == nullptr ? line_->foot() : line_->meeting(third_);
    }
    return *exact_;
  }

 private:
  void move(Line& line, Barrier third, const kernels::PointImage& image) {
    line_ = &line;
    third_ = third;
    image_ = image;
    exact_.reset();
  }

  Barrier wall_, third_ = nullptr;
  Line* line_ = nullptr;
  long exponent_;
  kernels::PointImage image_;
  std::optional<RationalPoint> exact_;
};

// On the line the point only moves away from its foot, to one side: it ends as soon as it would have to go back. Sets `last` and `against`
// to the barriers that leave nothing of the line, or one of them to null.
CellEnd nearest_on_line(Line& line, std::span<const Barrier> barriers, const kernels::SquaredDistance* limit, Candidate& nearest,
                        Barrier& last, Barrier& against) {
  nearest.move_to_foot(line);
  int way = 0;
  std::size_t moved = 0;  // barriers before this one were met before the last move
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (nearest.side(barriers[i]) >= 0) continue;
    const int to = line.leads_beyond(barriers[i]);
    against = barriers[i];
    if (to == 0) last = nullptr;
    if (to == 0 || to == -way) return CellEnd::infeasible;
    way = to;
    nearest.move_to_meeting(line, barriers[i]);
    last = barriers[i];
    moved = i;
    if (nearest.is_beyond(limit)) return CellEnd::beyond;
  }
  for (std::size_t i = 0; i < moved; ++i) {
    against = barriers[i];
    if (nearest.side(barriers[i]) < 0) return CellEnd::infeasible;
  }
  return nearest.is_beyond(limit) ? CellEnd::beyond : CellEnd::found;
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
  Candidate candidate(wall, exponent);
  if (candidate.is_beyond(limit)) return CellEnd::beyond;
  std::optional<Line> line;
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (candidate.side(barriers[i]) >= 0) continue;
    line.emplace(wall, barriers[i], exponent);
    if (!line->exists()) {
      infeasible({barriers[i]});
      return CellEnd::infeasible;
    }
    Barrier last = nullptr, against = nullptr;
    const CellEnd end = nearest_on_line(*line, barriers.first(i), limit, candidate, last, against);
    if (end == CellEnd::infeasible) infeasible({barriers[i], last, against});
    if (end != CellEnd::found) return end;
  }
  nearest = std::move(candidate.exact());
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
