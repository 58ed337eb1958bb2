// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/manifold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "fathom/patch.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/patch/patch.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/shapes/core.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {

namespace {

constexpr unsigned position_bits = 40;
/// The most corners of a polygon among whose subsets the best is sought.
constexpr std::size_t most_tried = 10;

/// Returns the point moved along n into the plane through O.
Point shadow(const Vector& n, const Point& p) { return p - mpq_class(dot(n, p) / mpq_class(dot(n, n))) * n; }

std::vector<Point> shadows(const Vector& n, std::span<const Point> points) {
  std::vector<Point> result;
  for (const Point& p : points) result.push_back(shadow(n, p));
  return result;
}

/// Returns the least squared distance such that `count` corners of a polygon can be chosen whose
/// hull is within it of all corners; `corners` are in order. With more than most_tried corners it
/// tries some of them only, and the result is an upper bound.
mpq_class least_missed_squared(const std::vector<Point>& corners, std::size_t count) {
  if (corners.size() <= count) return 0;
  const std::size_t tried = std::min(corners.size(), std::max(count, most_tried));
  std::vector<char> chosen(tried, 0);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(count), 1);
  std::optional<mpq_class> least;
  do {
    std::vector<Point> some;
    for (std::size_t k = 0; k < tried; ++k)
      if (chosen[k] != 0) some.push_back(corners[k * corners.size() / tried]);
    mpq_class farthest = 0;
    for (const Point& corner : corners)
      if ((!least || farthest < *least) && std::ranges::find(some, corner) == some.end())
        farthest = std::max(farthest, squared_distance(corner, some));
    if (!least || farthest < *least) least = std::move(farthest);
  } while (std::ranges::prev_permutation(chosen).found);
  return *least;
}

/// Returns whether the angle between v and n has a sine of at most 1/64.
bool nearly_along(const Vector& v, const Vector& n) {
  const Vector across = cross(v, n);
  return dot(v, n) > 0 && 4096 * dot(across, across) <= dot(v, v) * dot(n, n);
}

/// Returns the corners of the hull of shadows along n, in the order of a face.
std::vector<std::uint32_t> corners_seen(const std::vector<Point>& shadows, const Vector& n) {
  std::vector<Vec3<mpq_class>> points;
  for (const Point& p : shadows) points.push_back({p.x, p.y, p.z});
  std::vector<std::uint32_t> ids(points.size());
  std::iota(ids.begin(), ids.end(), 0U);
  return polytope::polygon_corners(points, std::move(ids), Vec3<mpq_class>{n.x, n.y, n.z});
}

/// Returns the corners of the intersection of the hulls of two sets of shadows; empty if it is
/// empty.
std::vector<Point> common(const std::vector<Point>& one, const std::vector<Point>& other, const Vector& n) {
  if (one.empty() || other.empty()) return {};
  const std::vector<std::uint32_t> of_one = corners_seen(one, n), of_other = corners_seen(other, n);
  return patch::shared_naive({}, {n, polytope::Points(one), of_one, polytope::Points(other), of_other});
}

mpq_class squared_length(const std::vector<Point>& ends) { return dot(ends[1] - ends[0], ends[1] - ends[0]); }

/// Returns the area times |n| of a polygon in a plane across n, given by its corners in order.
mpq_class area_along(const Vector& n, const std::vector<Point>& corners) {
  mpq_class sum = 0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += dot(n, cross(corners[k] - corners[0], corners[k + 1] - corners[0]));
  return abs(sum) / 2;
}

std::string length_text(const mpq_class& signed_square, int digits = 4) {
  return fmt::format("{:.{}g}", kernels::nearest_binary64({0, signed_square}), digits);
}

}  // namespace

ContactJudge::ContactJudge(const Truth& truth, const Claim& claim, const Allowances& allowed,
                           const std::optional<ContactLimits>& declared, long exponent,
                           const std::optional<mpq_class>& slack)
    : truth_(truth), claim_(claim), depth_(allowed.depth) {
  const kernels::DefaultFloatEnvironment environment;
  near_ = kernels::enclosed({0, allowed.witness.squared()}, position_bits).high;
  if (slack) slack_ = std::max(mpq_class(0), *slack);
  if (declared) {
    margin_ = Allowance(0, 0, scaled(exact_value(declared->margin), -exponent));
    most_ = declared->most;
    promised_ = !most_ || *most_ > 1;  // one contact alone has no extent
  }
  if (promised_ || slack_) find_extents();
}

void ContactJudge::find_extents() {
  const Penetration* const penetration = truth_.depth.penetration();
  if (!penetration || penetration->unlisted > 0) return;
  for (const Optimum& optimum : penetration->optima) {
    const Vector& n = optimum.direction;
    if (claim_.direction && !nearly_along(*claim_.direction, n)) continue;
    const Patch patch =
        patch::shared_inside({n, truth_.a, optimum.contact.a, truth_.b, optimum.contact.b}, optimum.support);
    Extent& extent = extents_.emplace_back(Extent{n, optimum.support, {}, patch.centroid().a.core});
    if (slack_) extent.corners = with_slack(extent, *slack_ * *slack_);
    for (std::size_t k = 0; !slack_ && k < patch.corners.size(); ++k) extent.corners.push_back(patch.a(k).core);
  }
}

std::vector<Point> ContactJudge::with_slack(const Extent& extent, const mpq_class& squared) const {
  std::vector<Point> corners;
  for (const patch::LineOverlap& line :
       patch::LinesAlong(extent.direction, truth_.a.exact(), truth_.b.exact()).with_slack(extent.support, squared))
    corners.push_back(line.a);
  return corners;
}

/// Returns how far a corner may be from the contacts. A subject that reports at most `most_`
/// contacts chooses among the corners where the bodies overlap as deep, within the tolerance of a
/// depth, or among those of the patch: what the best choice misses is allowed. For a patch with
/// slack, the slack is allowed too, and the corners are those of this patch alone.
ContactJudge::Reach ContactJudge::reach_of(const Extent& extent) const {
  Reach reach{slack_ ? mpq_class(near_ + *slack_) : near_};
  if (!most_) return reach;
  const Vector& n = extent.direction;
  reach.squared = least_missed_squared(shadows(n, extent.corners), *most_);
  if (!slack_)
    reach.squared =
        std::max(reach.squared, least_missed_squared(shadows(n, with_slack(extent, depth_.squared())), *most_));
  return reach;
}

std::optional<MeasuredExtent> ContactJudge::measured() const {
  const kernels::DefaultFloatEnvironment environment;
  std::optional<MeasuredExtent> best;
  if (!slack_ || claim_.contacts.empty()) return best;
  for (const Extent& extent : extents_) {
    const Vector& n = extent.direction;
    const std::vector<Point> contacts = shadows(n, claim_.contacts), corners = shadows(n, extent.corners);
    MeasuredExtent found;
    for (const Point& corner : corners)
      found.missed_squared = std::max(found.missed_squared, squared_distance(corner, contacts));
    const std::vector<Point> covered = common(corners, contacts, n);
    if (corners.size() > 2) {
      const mpq_class share = area_along(n, covered) / area_along(n, corners);
      found.covered_squared = share * share;
    } else if (corners.size() == 2) {
      found.covered_squared =
          covered.size() < 2 ? mpq_class(0) : mpq_class(squared_length(covered) / squared_length(corners));
    }
    if (!best || found.missed_squared < best->missed_squared) best = std::move(found);
  }
  return best;
}

std::vector<ContactFault> ContactJudge::faults() const {
  const kernels::DefaultFloatEnvironment environment;
  std::vector<ContactFault> faults;
  if (claim_.contacts.empty() || !claim_.finite) return faults;
  if (claim_.direction) {
    const patch::LinesAlong lines(*claim_.direction, truth_.a.exact(), truth_.b.exact());
    for (std::size_t k = 0; k < claim_.contacts.size(); ++k) judge_contact(lines, k, faults);
  }
  judge_extent(faults);
  return faults;
}

// ---- one contact ----

const mpq_class& ContactJudge::claimed(std::size_t contact) const {
  const std::optional<mpq_class>& own = claim_.contact_depths[contact];
  return own ? *own : *claim_.length;
}

/// Returns the signed square of factor |v|.
mpq_class ContactJudge::signed_square(const mpq_class& factor) const {
  return factor * abs(factor) * dot(*claim_.direction, *claim_.direction);
}

/// Returns whether the claimed depth of the contact exceeds an overlap by more than the allowance;
/// the second function, whether it falls short of it.
bool ContactJudge::deeper(std::size_t contact, const mpq_class& factor) const {
  const mpq_class &d = claimed(contact), overlap = signed_square(factor);
  if (!depth_.above(d, overlap)) return false;
  return claim_.contact_depths[contact] || margin_.above(d, overlap);
}
bool ContactJudge::shallower(std::size_t contact, const mpq_class& factor) const {
  return claim_.contact_depths[contact] && depth_.below(claimed(contact), signed_square(factor));
}

// The line through the position itself is tried first, because it decides most contacts.
void ContactJudge::judge_contact(const patch::LinesAlong& lines, std::size_t contact,
                                 std::vector<ContactFault>& faults) const {
  const Point& x = claim_.contacts[contact];
  const std::optional<patch::LineOverlap> here = lines.at(x);
  const auto told = [&] { return fmt::format("{:.4g}", kernels::nearest_binary64({claimed(contact), 0})); };
  if (!here || deeper(contact, here->factor)) {
    const patch::GreatestOverlap greatest = lines.greatest(x, near_);
    if (!greatest.overlap) {
      faults.push_back(
          {Verdict::contact_outside,
           contact,
           greatest.planes,
           {},
           {},
           fmt::format("contact {} is outside: no line near it along the direction meets both bodies", contact)});
      return;
    }
    if (deeper(contact, greatest.overlap->factor)) {
      faults.push_back({Verdict::contact_too_deep,
                        contact,
                        greatest.planes,
                        {},
                        {},
                        fmt::format("contact {} is too deep: {} is claimed, along the lines near it the bodies overlap "
                                    "by {} at most",
                                    contact, told(), length_text(signed_square(greatest.overlap->factor)))});
      return;
    }
  }
  if (!claim_.contact_depths[contact] || (here && !shallower(contact, here->factor))) return;
  std::vector<patch::LineOverlap> corners = lines.corners(x, near_);
  const mpq_class least = std::ranges::min_element(corners, {}, &patch::LineOverlap::factor)->factor;
  if (!shallower(contact, least)) return;
  faults.push_back({Verdict::contact_too_shallow,
                    contact,
                    std::nullopt,
                    std::move(corners),
                    {},
                    fmt::format("contact {} is too shallow: {} is claimed, along the lines near it the bodies overlap "
                                "by {} at least",
                                contact, told(), length_text(signed_square(least)))});
}

// ---- all contacts ----

bool ContactJudge::too_far(const mpq_class& squared, const Reach& reach) {
  const mpq_class& length = reach.length;
  return sign({squared - length * length - reach.squared, -4 * length * length * reach.squared}) > 0;
}

std::optional<MissedPoint> ContactJudge::missed(const Extent& extent, const Point& point, const Reach& reach,
                                                mpq_class& squared) const {
  const Vector& n = extent.direction;
  const std::optional<Outside> outside = outside_of(shadow(n, point), shadows(n, claim_.contacts));
  squared = outside ? outside->squared : mpq_class(0);
  if (!outside || !too_far(squared, reach)) return std::nullopt;
  return MissedPoint{n, point, outside->away};
}

/// Returns the missed corner that is farthest from the contacts, and its squared distance.
std::optional<MissedPoint> ContactJudge::farthest_missed(const Extent& extent, const Reach& reach,
                                                         mpq_class& farthest) const {
  std::optional<MissedPoint> worst;
  for (const Point& corner : extent.corners) {
    mpq_class squared;
    std::optional<MissedPoint> found = missed(extent, corner, reach, squared);
    if (found && squared > farthest) (farthest = std::move(squared), worst = std::move(found));
  }
  return worst;
}

void ContactJudge::judge_extent(std::vector<ContactFault>& faults) const {
  if (extents_.empty() || !promised_) return;
  ContactFault fault{Verdict::misses_extent, std::nullopt, std::nullopt, {}, {}, ""};
  std::optional<mpq_class> least;
  const Extent* best = nullptr;
  for (const Extent& extent : extents_) {
    mpq_class farthest = 0;
    std::optional<MissedPoint> worst = farthest_missed(extent, {near_}, farthest);
    if (worst && (most_ || slack_)) worst = farthest_missed(extent, reach_of(extent), farthest = 0);
    if (!worst) return;
    if (!least || farthest < *least) (least = farthest, best = &extent);
    fault.missed.push_back(*std::move(worst));
  }
  const std::string with =
      slack_ ? fmt::format(" with a slack of {:.4g}", kernels::nearest_binary64({*slack_, 0})) : "";
  fault.sentence = fmt::format("the contacts miss a corner of the patch{} by {}", with, length_text(*least));
  faults.push_back(std::move(fault));
  mpq_class squared;
  if (std::optional<MissedPoint> middle = missed(*best, best->centroid, {near_}, squared))
    faults.push_back({Verdict::tips,
                      std::nullopt,
                      std::nullopt,
                      {},
                      {*std::move(middle)},
                      fmt::format("the bodies tip over: the middle of the patch is {} away from the contacts",
                                  length_text(squared))});
}

mpq_class unlike_squared(const Vector& n, std::span<const Point> xs, std::span<const Point> ys) {
  const std::vector<Point> one = shadows(n, xs), other = shadows(n, ys);
  mpq_class farthest = 0;
  for (const Point& x : one) farthest = std::max(farthest, squared_distance(x, other));
  for (const Point& y : other) farthest = std::max(farthest, squared_distance(y, one));
  return farthest;
}

// ---- proofs ----

bool ContactJudge::proves(const ContactFault& fault) const {
  const kernels::DefaultFloatEnvironment environment;
  if (claim_.contacts.empty() || !claim_.finite) return false;
  using enum Verdict;
  if (fault.finding == misses_extent || fault.finding == tips) return proves_missed(fault);
  if (!claim_.direction || !fault.contact || *fault.contact >= claim_.contacts.size()) return false;
  if (fault.finding == contact_too_shallow) return proves_too_shallow(fault);
  if (!fault.planes) return false;
  const Vector& v = *claim_.direction;
  const mpq_class rise = dot(v, fault.planes->u),
                  limit = patch::bound(*fault.planes, truth_.a.exact(), truth_.b.exact(),
                                       claim_.contacts[*fault.contact], near_);
  if (dot(v, fault.planes->w) != rise) return false;
  if (fault.finding == contact_outside) return rise == 0 && limit < 0;
  return rise == 1 && deeper(*fault.contact, limit);
}

/// Checks that the lines are the corners of the intersection of the shadows of both bodies and of
/// the box. The overlap is too large on each line, and therefore, as it is concave, on all lines
/// between them.
bool ContactJudge::proves_too_shallow(const ContactFault& fault) const {
  const Vector& v = *claim_.direction;
  const Point& x = claim_.contacts[*fault.contact];
  std::vector<Point> box, lines;
  for (const int i : {-1, 1})
    for (const int j : {-1, 1})
      for (const int k : {-1, 1}) box.push_back(shadow(v, {x.x + i * near_, x.y + j * near_, x.z + k * near_}));
  for (const patch::LineOverlap& line : fault.lines) {
    if (line.b - line.a != line.factor * v || !shallower(*fault.contact, line.factor)) return false;
    if (outside_of(line.a, truth_.a.exact()) || outside_of(line.b, truth_.b.exact())) return false;
    lines.push_back(shadow(v, line.a));
  }
  const std::vector<Point> corners =
      common(common(shadows(v, truth_.a.exact()), shadows(v, truth_.b.exact()), v), box, v);
  return !corners.empty() &&
         std::ranges::all_of(corners, [&](const Point& p) { return std::ranges::find(lines, p) != lines.end(); });
}

bool ContactJudge::is_missed(const MissedPoint& missed, const Reach& reach) const {
  if (is_zero(missed.away) || dot(missed.direction, missed.away) != 0) return false;
  std::optional<mpq_class> gap;
  for (const Point& x : claim_.contacts) {
    mpq_class there = dot(missed.away, missed.point - x);
    if (!gap || there < *gap) gap = std::move(there);
  }
  return *gap > 0 && too_far(*gap * *gap / mpq_class(dot(missed.away, missed.away)), reach);
}

bool ContactJudge::proves_missed(const ContactFault& fault) const {
  if (fault.finding == Verdict::tips)
    return fault.missed.size() == 1 && std::ranges::any_of(extents_, [&](const Extent& extent) {
             const MissedPoint& missed = fault.missed[0];
             return missed.direction == extent.direction && missed.point == extent.centroid &&
                    is_missed(missed, {near_});
           });
  return promised_ && !extents_.empty() && std::ranges::all_of(extents_, [&](const Extent& extent) {
           const Reach reach = reach_of(extent);
           return std::ranges::any_of(fault.missed, [&](const MissedPoint& missed) {
             return missed.direction == extent.direction &&
                    std::ranges::find(extent.corners, missed.point) != extent.corners.end() && is_missed(missed, reach);
           });
         });
}

namespace {

constexpr unsigned speed_bits = 40;

mpq_class rounded_up(const mpq_class& squared) { return kernels::enclosed({0, squared}, speed_bits).high; }

/// Returns the points whose hull is the body's core; O for a curved core.
std::vector<Point> points_of(const Body& body) {
  std::vector<Point> points;
  if (body.pieces)
    for (const std::vector<Point>& piece : *body.pieces) points.insert(points.end(), piece.begin(), piece.end());
  else if (const patch::CorePoints core(body); core.known()) points = core.exact();
  else points.emplace_back();
  return points;
}

mpq_class largest_speed(const Body& body, const Twist& twist) {
  mpq_class squared = 0;
  for (const Point& p : points_of(body)) {
    const Point velocity = twist.v + cross(twist.w, p);
    squared = std::max(squared, dot(velocity, velocity));
  }
  const mpq_class radius = body.shape ? shapes::simplified(*body.shape).radius : mpq_class(0);
  return rounded_up(squared) + radius * rounded_up(dot(twist.w, twist.w));
}

Twist reversed(const Twist& twist) { return {-twist.v, -twist.w}; }

/// With dimension 2 x and y alone.
std::string in_brackets(double x, double y, double z, unsigned dimension) {
  return dimension == 2 ? fmt::format("({:.4g}, {:.4g})", x, y) : fmt::format("({:.4g}, {:.4g}, {:.4g})", x, y, z);
}

/// Returns the body's point: that of the core, moved outward by the radius.
std::string point_text(const RoundedPoint& point, unsigned dimension) {
  const auto [x, y, z] = rounded::nearest_binary64(point);
  return in_brackets(x, y, z, dimension);
}

std::string direction_text(const Vector& n, unsigned dimension) {
  const auto share = [&](const mpz_class& c) {
    return kernels::nearest_binary64({0, mpq_class(c * abs(c)) / mpq_class(dot(n, n))});
  };
  return in_brackets(share(n.x), share(n.y), share(n.z), dimension);
}

/// Finds a well-known other rate that equals a wrong claim, by comparing the numbers alone.
class Instead {
 public:
  Instead(const ContactGeometry& geometry, const Motion& motion, const DirectionalDerivative& right, mpq_class claimed,
          const mpq_class& allowed, unsigned dimension)
      : dimension_(dimension),
        geometry_(geometry),
        motion_(motion),
        right_(right),
        squared_(right.value().root),
        claimed_(std::move(claimed)),
        allowed_(allowed),
        within_(0, 0, allowed) {}

  /// Returns a clause on that rate, or "".
  [[nodiscard]] std::string told(const Claim& claim) const {
    if (is(-squared_)) return "the right rate with the other sign";
    for (std::string text : {of_differences(), of_witness(claim), of_patches()})
      if (!text.empty()) return text;
    return "";
  }

 private:
  [[nodiscard]] bool is(const mpq_class& signed_square) const { return !within_.off(claimed_, signed_square); }

  /// Returns the rate at points of A and B along one direction, as a signed square.
  [[nodiscard]] mpq_class rate_at(const Vector& n, const Point& a, const Point& b) const {
    const Point apart = motion_.of_b.v + cross(motion_.of_b.w, b) - motion_.of_a.v - cross(motion_.of_a.w, a);
    const mpq_class rate = dot(n, apart);
    return rate * abs(rate) / dot(n, n);
  }

  /// Compares with difference quotients: at a kink the rate before the given time differs from the
  /// one after it.
  [[nodiscard]] std::string of_differences() const {
    const auto until_now = directional_derivative(geometry_, reversed(motion_.of_a), reversed(motion_.of_b));
    const auto* const found = std::get_if<DirectionalDerivative>(&until_now);
    if (!found) return "";
    const mpq_class before = -found->value().root;
    if (before == squared_) return "";
    if (is(before)) return "the rate until now: that of a difference backwards";
    const mpq_class twice = 2 * claimed_, slack = 2 * allowed_;
    if (kernels::sign_of_sum(twice - slack, -squared_, -before) > 0 ||
        kernels::sign_of_sum(twice + slack, -squared_, -before) < 0)
      return "";
    return fmt::format("the mean of the rates from now on, {}, and until now, {}: that of a central difference",
                       length_text(squared_, 6), length_text(before, 6));
  }

  [[nodiscard]] std::string of_witness(const Claim& claim) const {
    if (!claim.direction || !claim.witness_a || !claim.witness_b) return "";
    if (!is(rate_at(*claim.direction, *claim.witness_a, *claim.witness_b))) return "";
    return "the rate at its own witness points, along its own direction";
  }

  [[nodiscard]] std::string of_patches() const {
    if (geometry_.of_unions) return "";
    for (const Patch& patch : geometry_.patches) {
      std::vector<mpq_class> rates;
      for (std::size_t k = 0; k < patch.corners.size(); ++k)
        rates.push_back(rate_at(patch.direction, patch.a(k).core, patch.b(k).core));
      const auto greatest = std::ranges::max_element(rates);
      if (is(*greatest))
        return fmt::format("the rate along {} alone, where {}", direction_text(patch.direction, dimension_),
                           geometry_.cone ? "each direction that separates the cores counts"
                                          : fmt::format("each shortest way out counts as well, and {} decides",
                                                        direction_text(right_.direction, dimension_)));
      for (std::size_t k = 0; k < rates.size(); ++k)
        if (is(rates[k]))
          return fmt::format("the rate at the contact point {} alone, where each counts{}",
                             point_text(patch.a(k), dimension_), decisive(", and "));
      const RoundedWitness middle = patch.centroid();
      if (is(rate_at(patch.direction, middle.a.core, middle.b.core)))
        return fmt::format("the rate at the middle of the contact patch, {}{}", point_text(middle.a, dimension_),
                           decisive(", where "));
    }
    return "";
  }

  /// Returns a clause on the contact point that decides; "" if cores touch, as several points may
  /// decide together then.
  [[nodiscard]] std::string decisive(std::string_view before) const {
    if (geometry_.cone) return "";
    return fmt::format("{}{} decides", before,
                       point_text(geometry_.patches.at(right_.patch).a(right_.corner), dimension_));
  }

  unsigned dimension_;  // of the bodies that are judged
  const ContactGeometry& geometry_;
  const Motion& motion_;
  const DirectionalDerivative& right_;
  mpq_class squared_, claimed_, allowed_;
  Allowance within_;
};

}  // namespace

mpq_class largest_speed(const Body& a, const Body& b, const Motion& motion) {
  return std::max(largest_speed(shapes::is_halfspace(a) ? b : a, motion.of_a),
                  largest_speed(shapes::is_halfspace(b) ? a : b, motion.of_b));
}

DerivativeJudgement judged_derivative(const Body& a, const Body& b, const Answer& answer, const Motion& motion,
                                      const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                                      const Tolerance& tolerance, unsigned dimension, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const double claimed = reply.derivative.value();
  DerivativeJudgement result;
  result.claimed = std::ldexp(claimed, static_cast<int>(-format.exponent));
  if (!std::isfinite(claimed)) {
    result.sentence = fmt::format("the derivative is {}", claimed);
    return result;
  }
  ContactGeometry geometry = contact_geometry(a, b, answer, monitor);
  geometry.dimension = dimension;  // the motion must not leave the plane
  for (const Kink kink : geometry.kinks) result.kinks.emplace_back(name(kink));
  const auto found = directional_derivative(geometry, motion.of_a, motion.of_b);
  if (const LeftOut* const why = std::get_if<LeftOut>(&found)) {
    result.left_out = name(*why);
    return result;
  }
  const auto& right = std::get<DirectionalDerivative>(found);
  const mpq_class& squared = result.squared.emplace(right.value().root);
  const mpq_class rate = scaled(exact_value(claimed), -format.exponent);
  result.error = kernels::nearest_binary64({rate, -squared});
  const mpq_class share = std::max({tolerance.relative, tolerance.absolute, mpq_class(0)}),
                  rounding = std::max(mpq_class(tolerance.ulps), mpq_class(1, 2)) * ulp_at_root(abs(squared), format),
                  allowed = std::max(mpq_class(share * largest_speed(a, b, motion)), rounding);
  if (!Allowance(0, 0, allowed).off(rate, squared)) return result;
  result.sentence = fmt::format("the derivative is wrong by {:.4g}: {} is claimed, {} is right",
                                std::abs(*result.error), result.claimed, length_text(squared, 6));
  const std::string instead =
      Instead(geometry, motion, right, rate, allowed, dimension).told(exact_claim(reply, conventions, format.exponent));
  if (!instead.empty()) result.sentence += "; it is " + instead;
  return result;
}

}  // namespace fathom::judging
