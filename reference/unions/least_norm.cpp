// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/least_norm.hpp"

#include <initializer_list>
#include <optional>
#include <utility>

#include "kernels/filters/meeting_points.hpp"

namespace fathom::unions {
namespace {

using kernels::AnyNumbers;
using kernels::as;
using kernels::FixedNumbers;
using kernels::RationalPointIn;

template <class Integer>
Vec3<Integer> scaled(const Integer& s, const Vec3<Integer>& v) {
  return {Integer(s * v.x), Integer(s * v.y), Integer(s * v.z)};
}

// A plane's equation in the integers that points are computed with.
template <class Numbers>
struct Equation {
  using Integer = typename Numbers::Product;
  explicit Equation(const kernels::OrientedPlaneIn<Numbers>& plane)
      : normal(as<Integer>(plane.normal)), height(as<Integer>(plane.height)) {}
  Vec3<Integer> normal;
  Integer height;
};

template <class Numbers>
RationalPointIn<Numbers> foot_of(BarrierIn<Numbers> wall, long exponent) {
  const Equation<Numbers> g(*wall);
  return kernels::rational_point<Numbers>(scaled(g.height, g.normal), dot(g.normal, g.normal), exponent);
}

// The line in which two planes meet: by images, and exactly where they cannot tell.
template <class Numbers>
class Line {
 public:
  using Integer = typename Numbers::Product;

  Line(BarrierIn<Numbers> g, BarrierIn<Numbers> h, long exponent)
      : g_(g), h_(h), exponent_(exponent), image_(g->image, h->image) {}

  [[nodiscard]] bool exists() { return image_.surely_exists() || !is_zero(exact().direction); }
  // The sign of the direction in which the line leads beyond a plane: 0 if it is parallel to it.
  [[nodiscard]] int leads_beyond(BarrierIn<Numbers> e) {
    if (const auto sure = image_.leads_beyond(e->image)) return kernels::to_int(*sure);
    return sgn(dot(exact().direction, as<Integer>(e->normal)));
  }
  [[nodiscard]] const kernels::MeetingLine& image() const { return image_; }
  // Its point nearest to O.
  [[nodiscard]] RationalPointIn<Numbers> foot() {
    const auto& [g, h, d] = exact();
    return kernels::rational_point<Numbers>(scaled(g.height, cross(h.normal, d)) + scaled(h.height, cross(d, g.normal)),
                                            dot(d, d), exponent_);
  }
  [[nodiscard]] RationalPointIn<Numbers> meeting(BarrierIn<Numbers> third) {
    const auto& [g, h, d] = exact();
    const Equation<Numbers> e(*third);
    return kernels::rational_point<Numbers>(
        scaled(g.height, cross(h.normal, e.normal)) + scaled(h.height, cross(e.normal, g.normal)) + scaled(e.height, d),
        dot(d, e.normal), exponent_);
  }

 private:
  struct Exact {
    Equation<Numbers> g, h;
    Vec3<Integer> direction;
  };

  const Exact& exact() {
    if (!exact_) {
      const Equation<Numbers> g(*g_), h(*h_);
      exact_ = Exact{g, h, cross(g.normal, h.normal)};
    }
    return *exact_;
  }

  BarrierIn<Numbers> g_, h_;
  long exponent_;
  kernels::MeetingLine image_;
  std::optional<Exact> exact_;
};

// The nearest point so far: the foot of the wall or of a line, or where the line meets a third
// plane. Most of them are asked for nothing that their image cannot tell, and have no exact
// coordinates.
template <class Numbers>
class Candidate {
 public:
  Candidate(BarrierIn<Numbers> wall, long exponent)
      : wall_(wall), exponent_(exponent), image_(kernels::foot_image(wall->image)) {}

  void move_to_foot(Line<Numbers>& line) { move(line, nullptr, line.image().foot()); }
  void move_to_meeting(Line<Numbers>& line, BarrierIn<Numbers> e) { move(line, e, line.image().meeting(e->image)); }

  [[nodiscard]] int side(BarrierIn<Numbers> e) {
    if (const auto sure = kernels::sure_side(e->image, image_)) return kernels::to_int(*sure);
    return kernels::side(*e, exact());
  }
  // Whether it is farther away than the limit, if there is one.
  [[nodiscard]] bool is_beyond(LimitIn<Numbers> limit) {
    if (limit == nullptr) return false;
    if (const auto sure = kernels::sure_order(image_, limit->image)) return *sure == kernels::Sign::positive;
    return kernels::compare(exact(), *limit) > 0;
  }
  RationalPointIn<Numbers>& exact() {
    if (!exact_) {
      if (line_ == nullptr) exact_ = foot_of<Numbers>(wall_, exponent_);
      else exact_ = third_ == nullptr ? line_->foot() : line_->meeting(third_);
    }
    return *exact_;
  }

 private:
  void move(Line<Numbers>& line, BarrierIn<Numbers> third, const kernels::PointImage& image) {
    line_ = &line;
    third_ = third;
    image_ = image;
    exact_.reset();
  }

  BarrierIn<Numbers> wall_, third_ = nullptr;
  Line<Numbers>* line_ = nullptr;
  long exponent_;
  kernels::PointImage image_;
  std::optional<RationalPointIn<Numbers>> exact_;
};

// On the line the point only moves away from its foot, to one side: it ends as soon as it would
// have to go back. Sets `last` and `against` to the barriers that leave nothing of the line, or one
// of them to null.
template <class Numbers>
CellEnd nearest_on_line(Line<Numbers>& line, BarriersIn<Numbers> barriers, LimitIn<Numbers> limit,
                        Candidate<Numbers>& nearest, BarrierIn<Numbers>& last, BarrierIn<Numbers>& against) {
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

template <class Numbers>
CellEnd nearest_on_wall(BarrierIn<Numbers> wall, BarriersIn<Numbers> barriers, LimitIn<Numbers> limit, long exponent,
                        RationalPointIn<Numbers>& nearest,
                        std::type_identity_t<std::vector<BarrierIn<Numbers>>>* conflict) {
  const auto infeasible = [&](std::initializer_list<BarrierIn<Numbers>> with) {
    if (conflict == nullptr) return;
    conflict->assign(1, wall);
    for (const BarrierIn<Numbers> barrier : with)
      if (barrier != nullptr) conflict->push_back(barrier);
  };
  Candidate<Numbers> candidate(wall, exponent);
  if (candidate.is_beyond(limit)) return CellEnd::beyond;
  std::optional<Line<Numbers>> line;
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (candidate.side(barriers[i]) >= 0) continue;
    line.emplace(wall, barriers[i], exponent);
    if (!line->exists()) {
      infeasible({barriers[i]});
      return CellEnd::infeasible;
    }
    BarrierIn<Numbers> last = nullptr, against = nullptr;
    const CellEnd end = nearest_on_line<Numbers>(*line, barriers.first(i), limit, candidate, last, against);
    if (end == CellEnd::infeasible) infeasible({barriers[i], last, against});
    if (end != CellEnd::found) return end;
  }
  nearest = std::move(candidate.exact());
  return CellEnd::found;
}

template <class Numbers>
CellEnd nearest_in_cell(BarriersIn<Numbers> barriers, long exponent, RationalPointIn<Numbers>& nearest) {
  nearest = RationalPointIn<Numbers>{};
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    if (kernels::side(*barriers[i], nearest) >= 0) continue;
    const CellEnd end = nearest_on_wall<Numbers>(barriers[i], barriers.first(i), nullptr, exponent, nearest);
    if (end != CellEnd::found) return end;
  }
  return CellEnd::found;
}

template CellEnd nearest_on_wall(BarrierIn<AnyNumbers>, BarriersIn<AnyNumbers>, LimitIn<AnyNumbers>, long,
                                 RationalPointIn<AnyNumbers>&, std::vector<BarrierIn<AnyNumbers>>*);
template CellEnd nearest_in_cell(BarriersIn<AnyNumbers>, long, RationalPointIn<AnyNumbers>&);
template CellEnd nearest_on_wall(BarrierIn<FixedNumbers>, BarriersIn<FixedNumbers>, LimitIn<FixedNumbers>, long,
                                 RationalPointIn<FixedNumbers>&, std::vector<BarrierIn<FixedNumbers>>*);
template CellEnd nearest_in_cell(BarriersIn<FixedNumbers>, long, RationalPointIn<FixedNumbers>&);

}  // namespace fathom::unions
