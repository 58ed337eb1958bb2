// SPDX-License-Identifier: GPL-3.0-or-later
// The passes that make a case smaller. Each offers candidates to the search, which rejects larger
// and invalid ones.
#include "verify/harness/shrink/shrink.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "fathom/plane.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

/// The points of a body without words; of a rounded one of the plane those of its core.
std::vector<Point> corners_of(const Body& body) {
  std::vector<Point> corners;
  for_each_hull(body, [&](const std::vector<Point>& points) { corners = points; });
  return corners;
}

/// Applies use(mpq_class&) to the radii of bodies of the plane that have one: of both, or of one.
/// Bodies whose radius becomes 0 are their cores.
template <class SomeCase, class Use>
void for_each_radius(SomeCase& pair, const Use& use, Body Case::*only = nullptr) {
  for (Body Case::*which : {&Case::a, &Case::b}) {
    auto& body = pair.*which;
    if ((only && which != only) || body.dimension != 2 || !body.shape) continue;
    use(body.shape->radius);
    if constexpr (!std::is_const_v<SomeCase>)
      if (body.shape->radius == 0) body = in_plane(Body{core_of(body)});
  }
}

// ---- delta debugging of the points (Zeller and Hildebrandt 2002: ddmin, its complements only)
// ----

std::vector<Point> extreme(const std::vector<Point>& points) {
  const polytope::Polytope hull = polytope::hull_of(points);
  std::vector<Point> result;
  for (const std::uint32_t id : hull.input_ids) result.push_back(points[id]);
  return result;
}

void drop_inner(Search& search) {
  const Case before = search.best();
  Case both = before;
  for (Body* body : {&both.a, &both.b})
    for_each_hull(*body, [](std::vector<Point>& points) { points = extreme(points); });
  if (search.offer(both)) return;
  search.offer({before.id, both.a, before.b});
  search.offer({before.id, before.a, both.b});
}

/// Tries to drop each chunk of this length once. Returns whether any was dropped.
bool drop_chunks(Search& search, Body Case::*body, std::size_t length) {
  bool dropped = false;
  std::size_t begin = 0;
  for (std::size_t count; begin < (count = corners_of(search.best().*body).size()) && !search.over();) {
    const std::size_t end = std::min(count, begin + length);
    Case candidate = search.best();
    if (end - begin < count)  // something must be left
      for_each_hull(candidate.*body, [&](std::vector<Point>& points) {
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(begin),
                     points.begin() + static_cast<std::ptrdiff_t>(end));
      });
    if (search.offer(std::move(candidate))) dropped = true;
    else begin += length;
  }
  return dropped;
}

void drop_by_halves(Search& search, Body Case::*body) {
  std::size_t length = (corners_of(search.best().*body).size() + 1) / 2;
  while (length > 0 && !search.over()) {
    const bool dropped = drop_chunks(search, body, length);
    if (length == 1 && !dropped) return;
    length = length == 1 ? 1 : (length + 1) / 2;
  }
}

/// Drops all points that are not extreme, of both bodies or of one; then chunks of points, ever
/// smaller, down to single points (ddmin).
void drop_points(Search& search) {
  drop_inner(search);
  drop_by_halves(search, &Case::a);
  drop_by_halves(search, &Case::b);
}

// ---- bodies to the origin, scaled by powers of two ----

constexpr std::size_t vertices_tried = 8;

/// Returns the corners and the centre of the bounding box of all points, and their mean.
std::vector<Point> centres(const Case& pair) {
  std::vector<Point> points = corners_of(pair.a);
  std::ranges::copy(corners_of(pair.b), std::back_inserter(points));
  Point low, middle, mean;
  for (const auto axis : axes) {
    const auto less = [axis](const Point& p, const Point& q) { return p.*axis < q.*axis; };
    const auto [least, most] = std::ranges::minmax_element(points, less);
    low.*axis = (*least).*axis;
    middle.*axis = ((*least).*axis + (*most).*axis) / 2;
    for (const Point& p : points) mean.*axis += p.*axis;
    mean.*axis /= static_cast<unsigned long>(points.size());
  }
  return {low, middle, mean};
}

/// Returns the case moved by -to, with coordinates rounded if they are not exact.
std::optional<Case> moved(Case pair, const Point& to, Precision precision) {
  bool fits = true;
  for (Body* body : {&pair.a, &pair.b})
    for_each_hull(*body, [&](std::vector<Point>& points) {
      for (Point& p : points)
        for (const auto axis : axes) {
          const std::optional<mpq_class> value = rounded(mpq_class(p.*axis - to.*axis), precision);
          fits = fits && value;
          if (value) p.*axis = *value;
        }
    });
  return fits ? std::optional(std::move(pair)) : std::nullopt;
}

/// Moves both bodies so that a vertex, or a centre, lies at the origin, and rounds coordinates that
/// are not exact then.
void move_to_origin(Search& search) {
  const Case before = search.best();
  std::vector<Point> places = centres(before);
  for (const Body* body : {&before.a, &before.b}) {
    const std::vector<Point> corners = corners_of(*body);
    places.insert(places.end(), corners.begin(),
                  corners.begin() + static_cast<std::ptrdiff_t>(std::min(corners.size(), vertices_tried)));
  }
  // Moves along one axis at a time as well, because the verdict may depend on the position along
  // another.
  for (const Point& place : places) {
    if (std::optional<Case> candidate = moved(before, place, search.precision())) search.offer(*std::move(candidate));
    for (const auto axis : axes) {
      Point along;
      along.*axis = place.*axis;
      if (std::optional<Case> candidate = moved(search.best(), along, search.precision()))
        search.offer(*std::move(candidate));
    }
  }
}

/// Scales by a power of two: to about 1, or to integers.
void rescale(Search& search) {
  const mpq_class largest = largest_coordinate(search.best());
  if (largest == 0) return;
  std::optional<long> finest;
  for_each_coordinate(search.best(), [&](const mpq_class& value) {
    if (value != 0) finest = std::min(finest.value_or(lowest_bit(value)), lowest_bit(value));
  });
  for (const long exponent : {-*finest, -exponent_of(largest)}) {
    Case candidate = search.best();
    for_each_coordinate(candidate, [&](mpq_class& value) { value = scaled(value, exponent); });
    for_each_radius(candidate, [&](mpq_class& radius) { radius = scaled(radius, exponent); });
    search.offer(std::move(candidate));
  }
}

// ---- simpler coordinates ----

// Rounding all values at once keeps shapes roughly; replacing a value wherever it occurs keeps
// coplanar faces coplanar.
constexpr long integer_extents[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 30, 50, 100, 200, 500, 1000};
constexpr long grid_bits[] = {0, 1, 2, 3, 4, 6, 8, 11, 14, 18, 23, 30, 40};

/// Rounds to the coarsest of the small integer grids on which the verdict persists.
void round_to_integers(Search& search) {
  const Case before = search.best();
  const mpq_class largest = largest_coordinate(before);
  if (largest == 0) return;
  for (const long size : integer_extents) {
    Case candidate = before;
    const auto round = [&](mpq_class& value) { value = nearest_integer(value * size / largest); };
    for_each_coordinate(candidate, round);
    for_each_radius(candidate, round);
    if (search.over() || search.offer(std::move(candidate))) return;
  }
}

/// Rounds to the coarsest grid of a power of two: the whole case, one body, or one axis.
void round_to_grids(Search& search, std::vector<Body Case::*> bodies, std::vector<mpq_class Point::*> chosen) {
  const Case before = search.best();
  const mpq_class largest = largest_coordinate(before);
  if (largest == 0) return;
  const long top = exponent_of(largest);
  for (const long bits : grid_bits) {
    Case candidate = before;
    for (Body Case::*body : bodies)
      for_each_hull(candidate.*body, [&](std::vector<Point>& points) {
        for (Point& p : points)
          for (mpq_class Point::*axis : chosen) p.*axis = to_multiple(p.*axis, top - bits);
      });
    if (search.over() || search.offer(std::move(candidate))) return;
  }
}

/// Returns all values on the axis, those with the highest cost first.
std::vector<mpq_class> values_on(const Case& pair, mpq_class Point::*axis) {
  std::vector<mpq_class> values;
  for (const Body* body : {&pair.a, &pair.b})
    for (const Point& p : corners_of(*body)) values.push_back(p.*axis);
  std::ranges::sort(values, [](const mpq_class& p, const mpq_class& q) {
    const std::size_t left = cost(p), right = cost(q);
    return left != right ? left > right : p < q;
  });
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Returns replacements for `value`: simpler numbers, and the next values on the axis on both
/// sides.
std::vector<mpq_class> replacements(const mpq_class& value, const std::vector<mpq_class>& on_axis) {
  std::vector<mpq_class> result = simpler(value);
  const mpq_class *below = nullptr, *above = nullptr;
  for (const mpq_class& other : on_axis) {
    if (other < value && (!below || other > *below)) below = &other;
    if (other > value && (!above || other < *above)) above = &other;
  }
  for (const mpq_class* near : {below, above})
    if (near && cost(*near) <= cost(value)) result.push_back(*near);
  return result;
}

void simplify_everywhere(Search& search, mpq_class Point::*axis) {
  const std::vector<mpq_class> values = values_on(search.best(), axis);
  for (const mpq_class& value : values)
    for (const mpq_class& other : replacements(value, values)) {
      Case candidate = search.best();
      for (Body* body : {&candidate.a, &candidate.b})
        for_each_hull(*body, [&](std::vector<Point>& points) {
          for (Point& p : points)
            if (p.*axis == value) p.*axis = other;
        });
      if (search.over() || search.offer(std::move(candidate))) break;
    }
}

void simplify_singly(Search& search, Body Case::*body, mpq_class Point::*axis) {
  for (std::size_t i = 0, count = corners_of(search.best().*body).size(); i < count; ++i) {
    const mpq_class value = corners_of(search.best().*body)[i].*axis;
    for (const mpq_class& other : replacements(value, values_on(search.best(), axis))) {
      Case candidate = search.best();
      for_each_hull(candidate.*body, [&](std::vector<Point>& points) { points[i].*axis = other; });
      if (search.over() || search.offer(std::move(candidate))) break;
    }
  }
}

/// Rounds all coordinates to small integers, or to few bits in their own scale; or those of one
/// body, or on one axis.
void round_together(Search& search) {
  round_to_integers(search);
  round_to_grids(search, {&Case::a, &Case::b}, {axes.begin(), axes.end()});
  for (Body Case::*body : {&Case::a, &Case::b}) round_to_grids(search, {body}, {axes.begin(), axes.end()});
  for (mpq_class Point::*axis : axes) round_to_grids(search, {&Case::a, &Case::b}, {axis});
}

void simplify_radius(Search& search, Body Case::*body) {
  std::vector<mpq_class> radii;
  for_each_radius(
      search.best(), [&](const mpq_class& radius) { radii.push_back(radius); }, body);
  for (const mpq_class& radius : radii)
    for (const mpq_class& other : simpler(radius)) {
      Case candidate = search.best();
      for_each_radius(
          candidate, [&](mpq_class& radius) { radius = abs(other); }, body);
      if (search.over() || search.offer(std::move(candidate))) break;
    }
}

/// Replaces values one by one on each axis, wherever they occur, then single coordinates: by 0, a
/// value that occurs already, an integer, fewer bits, half of it; then radii.
void simplify_values(Search& search) {
  for (mpq_class Point::*axis : axes) simplify_everywhere(search, axis);
  for (Body Case::*body : {&Case::a, &Case::b})
    for (mpq_class Point::*axis : axes) simplify_singly(search, body, axis);
  for (Body Case::*body : {&Case::a, &Case::b}) simplify_radius(search, body);
}

// ---- cases whose bodies have names ----

constexpr Body Case::*bodies[] = {&Case::a, &Case::b};
constexpr long integer_lengths[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128};

/// Returns the best case with another description of one body; nullopt if it describes no body, or
/// the body has no description.
std::optional<Case> with_words(const Case& best, Body Case::*body,
                               const std::function<void(files::NamedBody&)>& change) {
  if (!(best.*body).words) return std::nullopt;
  files::NamedBody words = *(best.*body).words;
  change(words);
  try {
    Case result = best;
    result.*body = files::body_of(std::move(words));
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

bool offer(Search& search, std::optional<Case> candidate) { return candidate && search.offer(*std::move(candidate)); }
bool offer_words(Search& search, Body Case::*body, const std::function<void(files::NamedBody&)>& change) {
  return offer(search, with_words(search.best(), body, change));
}

/// Returns the best case with its numbers changed; nullopt if they describe no bodies then.
std::optional<Case> with_numbers(const Case& best, const std::function<void(mpq_class&)>& change) {
  try {
    Case result = best;
    for_each_number(result, change);
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Returns the number of vertices of a hull by name, or of a body without description.
std::size_t vertices_of(const Body& body) {
  return body.words ? body.words->fields.vertices.size() : body.points.size();
}

void drop_vertices(Search& search, Body Case::*body) {
  for (std::size_t length = (vertices_of(search.best().*body) + 1) / 2; length > 0; length /= 2)
    for (std::size_t begin = 0; begin < vertices_of(search.best().*body) && !search.over();) {
      const auto drop = [&](std::vector<Point>& points) {
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
        points.erase(first, first + static_cast<std::ptrdiff_t>(std::min(length, points.size() - begin)));
      };
      bool dropped = false;
      if ((search.best().*body).words) {
        dropped = offer_words(search, body, [&](files::NamedBody& words) { drop(words.fields.vertices); });
      } else {
        Case candidate = search.best();
        drop((candidate.*body).points.edit());
        dropped = search.offer(std::move(candidate));
      }
      if (!dropped) begin += length;
    }
}

void drop_parts(Search& search, Body Case::*body) {
  offer_words(search, body, [](files::NamedBody& words) { words.fields.numbers.erase("margin"); });
  for (std::size_t i = 0; (search.best().*body).words && i < (search.best().*body).words->terms.size();) {
    const bool dropped = offer_words(search, body, [i](files::NamedBody& words) {
      words.terms.erase(words.terms.begin() + static_cast<std::ptrdiff_t>(i));
    });
    if (!dropped) ++i;
  }
  drop_vertices(search, body);
}

/// Removes the rotation, or rounds it to few bits.
void put_upright(Search& search, Body Case::*body) {
  offer_words(search, body, [](files::NamedBody& words) {
    for (std::size_t axis = 0; words.matrix && axis < 3; ++axis)
      (axis == 0 ? words.place.x : axis == 1 ? words.place.y : words.place.z) = (*words.matrix)[axis][3];
    words.matrix.reset();
    words.turn = {1, 0, 0, 0};
  });
  for (const long most : {1, 2, 4, 16}) {
    const bool simpler = offer_words(search, body, [most](files::NamedBody& words) {
      const auto parts = {&words.turn.w, &words.turn.x, &words.turn.y, &words.turn.z};
      mpq_class largest = 0;
      for (const mpq_class* part : parts) largest = std::max(largest, mpq_class(abs(*part)));
      for (mpq_class* part : parts)
        *part = nearest_integer(*part * most / largest);  // the quaternion must not become zero
    });
    if (simpler || search.over()) return;
  }
}

/// Moves both bodies so that the place, or the first point, of one of them is at the origin; along
/// one axis at a time as well.
void move_shapes(Search& search) {
  for (Body Case::*body : bodies)
    for (const unsigned axes : {7U, 1U, 2U, 4U}) {
      const Case before = search.best();
      const auto along = [&](Body& of, std::size_t axis, const mpq_class& by) {
        if (of.words) {
          files::NamedBody words = *of.words;
          place_along(words, axis) -= by;
          of = files::body_of(std::move(words));
        } else {
          for (Point& p : of.points.edit()) (axis == 0 ? p.x : axis == 1 ? p.y : p.z) -= by;
        }
      };
      Case candidate = before;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((axes >> axis & 1U) == 0) continue;
        files::NamedBody words = (before.*body).words ? *(before.*body).words : files::NamedBody{};
        if (!(before.*body).words && (before.*body).points.size() > 0) words.place = (before.*body).points[0];
        const mpq_class by = place_along(words, axis);
        for (Body Case::*moved : bodies) along(candidate.*moved, axis, by);
      }
      // Numbers that are not exact are rounded.
      offer(search, with_numbers(candidate, [&](mpq_class& value) {
              value = rounded(value, search.precision()).value_or(value);
            }));
    }
}

void round_lengths(Search& search) {
  const Case before = search.best();
  const mpq_class largest = largest_coordinate(before);
  if (largest == 0) return;
  for (const long size : integer_lengths) {
    Case candidate = before;
    try {
      for_each_coordinate(candidate, [&](mpq_class& value) { value = nearest_integer(value * size / largest); });
    } catch (const std::invalid_argument&) {  // a length became 0
      continue;
    }
    if (search.over() || search.offer(std::move(candidate))) return;
  }
}

/// Simplifies number by number: in all places that have it, and then in one.
void simplify_numbers(Search& search) {
  for (const bool everywhere : {true, false})
    for (std::size_t i = 0;; ++i) {
      std::optional<mpq_class> value;
      std::size_t at = 0;
      for_each_number(search.best(), [&](const mpq_class& number) {
        if (at++ == i) value = number;
      });
      if (!value || search.over()) break;
      for (const mpq_class& other : simpler(*value)) {
        std::size_t place = 0;
        const auto change = [&](mpq_class& number) {
          if (place++ == i || (everywhere && number == *value)) number = other;
        };
        if (search.over() || offer(search, with_numbers(search.best(), change))) break;
      }
    }
}

/// The passes for bodies by name, in the place of all others: drops margins, terms and vertices,
/// removes rotations and translations, rounds lengths to small integers, and then simplifies number
/// by number.
void simplify_shapes(Search& search) {
  for (Body Case::*body : bodies) drop_parts(search, body);
  for (Body Case::*body : bodies) put_upright(search, body);
  move_shapes(search);
  round_lengths(search);
  simplify_numbers(search);
}

}  // namespace

Shrunk shrink(const Case& pair, Verdict verdict, const Examine& examine,
              const std::function<void(const Shrunk&)>& on_better, const std::function<bool()>& stop,
              const ShrinkSettings& settings) {
  const bool of_shapes = has_words(pair);
  for (const Body* body : {&pair.a, &pair.b})
    if (!body->words && corners_of(*body).empty())
      throw std::invalid_argument("shrink: a body without points or words");
  Case seen = pair;
  for_each_coordinate(seen, [&](mpq_class& value) {
    const std::optional<mpq_class> near = rounded(value, settings.precision);
    if (!near) throw std::invalid_argument("shrink: a coordinate is too large for the precision");
    value = *near;
  });
  Search search(verdict, examine, on_better, stop, settings);
  if (!search.begin(std::move(seen))) return search.result();
  // The loop ends because every kept step makes the size smaller.
  for (std::size_t before = search.result().kept + 1; before != search.result().kept && !search.over();) {
    before = search.result().kept;
    if (of_shapes) simplify_shapes(search);
    else
      for (const auto pass : {drop_points, move_to_origin, rescale, round_together, simplify_values}) pass(search);
  }
  return search.result();
}

}  // namespace fathom::harness
