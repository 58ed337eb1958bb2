// SPDX-License-Identifier: GPL-3.0-or-later
// Cases whose bodies have names: margins, terms and vertices dropped, bodies put upright and moved to the origin, numbers made simpler.
#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/shrink/passes.hpp"
#include "verify/harness/shrink/search.hpp"

namespace fathom::harness {
namespace {

constexpr Body Case::*bodies[] = {&Case::a, &Case::b};
constexpr long integer_lengths[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128};

/// The best case with other words for one body; nullopt where they make no body, or the body has none.
std::optional<Case> with_words(const Case& best, Body Case::*body, const std::function<void(files::NamedBody&)>& change) {
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

/// The best case with other numbers; nullopt where they make no bodies.
std::optional<Case> with_numbers(const Case& best, const std::function<void(mpq_class&)>& change) {
  try {
    Case result = best;
    for_each_number(result, change);
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// The vertices of a hull by name, or of a body without one.
std::size_t vertices_of(const Body& body) { return body.words ? body.words->fields.vertices.size() : body.points.size(); }

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
    const bool dropped = offer_words(
        search, body, [i](files::NamedBody& words) { words.terms.erase(words.terms.begin() + static_cast<std::ptrdiff_t>(i)); });
    if (!dropped) ++i;
  }
  drop_vertices(search, body);
}

/// Without a turn; or with one by few bits.
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
      for (mpq_class* part : parts) *part = nearest_integer(*part * most / largest);  // a turn is no quaternion of zeros
    });
    if (simpler || search.over()) return;
  }
}

/// Both bodies moved so that one of them has its place, or its first point, at the origin; along one axis at a time as well.
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
      // What is not exact is rounded.
      offer(search, with_numbers(candidate, [&](mpq_class& value) { value = rounded(value, search.precision()).value_or(value); }));
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

/// Number by number, in all places that have it and then in one.
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

}  // namespace

void simplify_shapes(Search& search) {
  for (Body Case::*body : bodies) drop_parts(search, body);
  for (Body Case::*body : bodies) put_upright(search, body);
  move_shapes(search);
  round_lengths(search);
  simplify_numbers(search);
}

}  // namespace fathom::harness
