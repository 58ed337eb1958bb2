// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer tells: doubles, exact numbers, JSON, its certificate.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "c/boundary.hpp"
#include "cli/output/answer.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/shape_output.hpp"
#include "cli/output/union_output.hpp"
#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/surd.hpp"
#include "kernels/point_algebra.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/rounded/coordinates.hpp"
#include "verify/check/unreadable.hpp"

namespace fathom::c {
namespace {

using rounded::CoordinatePair;
using rounded::Coordinates;
using rounded::coordinates;

constexpr const char* only_bounds = "only bounds of the signed depth are known: nothing follows from them exactly";

constexpr const char* stopped = "the search was stopped: only bounds of the depth are known";

std::vector<AlongNormal> translations_of(const SignedDepth& depth) {
  std::vector<AlongNormal> all = depth.translations();
  if (all.empty()) throw Absence(only_bounds);
  return all;
}

/// What is known, unless the search was stopped.
const UnionDepth& complete(const UnionDepth& depth) {
  if (!depth.complete) throw Absence(stopped);
  return depth;
}

Vector direction_of(const Depth& depth) { return depth.direction(); }
Vector direction_of(const SignedDepth& depth) { return depth.direction(); }
Vector direction_of(const UnionDepth& depth) {
  if (depth.apart) return depth.apart->distance.direction;
  if (complete(depth).status == Status::touching) throw Absence("the unions touch: there is no one direction, but one for each two pieces");
  return primitive_along(depth.optima.front().translation);
}

Coordinates translation_of(const Depth& depth) {
  return coordinates(depth.distance() ? depth.distance()->translation : depth.translation());
}
Coordinates translation_of(const SignedDepth& depth) { return coordinates(translations_of(depth).front()); }
Coordinates translation_of(const UnionDepth& depth) {
  return coordinates(depth.apart ? depth.apart->distance.translation : complete(depth).optima.front().translation);
}

CoordinatePair witness_of(const Depth& depth) {
  return coordinates(depth.distance() ? depth.distance()->witness : depth.witness().value());
}
CoordinatePair witness_of(const SignedDepth& depth) {
  const std::optional<RoundedWitness> witness = depth.witness();
  if (!witness) throw Absence(only_bounds);
  return coordinates(*witness);
}
CoordinatePair witness_of(const UnionDepth& depth) {
  if (!depth.apart) throw Absence("unions have a pair of witness points only if they are disjoint");
  return coordinates(depth.apart->distance.witness);
}

std::size_t optima_of(const Depth& depth) { return depth.optima().size(); }
std::size_t optima_of(const SignedDepth& depth) { return depth.status() == Status::penetrating ? depth.translations().size() : 0; }
std::size_t optima_of(const UnionDepth& depth) { return depth.status == Status::penetrating && depth.complete ? depth.optima.size() : 0; }

/// A shortest way out.
struct WayOut {
  Vector direction;
  Coordinates translation;
};

WayOut way_out(const Depth& depth, std::size_t index) {
  const Optimum& way = depth.optima()[index];
  return {way.direction, coordinates(way.translation())};
}
WayOut way_out(const SignedDepth& depth, std::size_t index) {
  const AlongNormal way = depth.translations()[index];
  return {way.normal, coordinates(way)};
}
WayOut way_out(const UnionDepth& depth, std::size_t index) {
  const Point& way = depth.optima[index].translation;
  return {primitive_along(way), coordinates(way)};
}

void copy(const Coordinates& from, double* to) { std::ranges::copy(rounded::nearest_binary64(from), to); }

// ---- exact texts ----

std::string text_of(const Surd& value) {
  std::string text = kernels::exact_surd_text(value);
  std::erase(text, ' ');
  return text;
}

std::string text_of(const Coordinates& values) { return text_of(values[0]) + " " + text_of(values[1]) + " " + text_of(values[2]); }

std::string signed_depth_text(const Depth& depth) { return text_of(Surd{0, signed_square(depth)}); }
std::string signed_depth_text(const SignedDepth& depth) {
  if (const Surd* const value = depth.exact()) return text_of(*value);
  return "[" + exact_text(depth.bounds()->low) + "," + exact_text(depth.bounds()->high) + "]";
}
std::string signed_depth_text(const UnionDepth& depth) {
  if (depth.apart) return text_of(Surd{0, mpq_class(-depth.apart->distance.squared)});
  if (depth.complete) return text_of(Surd{0, depth.low});
  return "[" + text_of(Surd{0, depth.low}) + "," + text_of(Surd{0, depth.high}) + "]";
}

/// Asks `question` of what was found.
template <class Question>
auto told(const fathom_answer& answer, Question question) {
  return std::visit(question, answer.found);
}

std::string exact_of(const fathom_answer& answer, int quantity) {
  switch (quantity) {
    case FATHOM_SIGNED_DEPTH: return told(answer, [](const auto& found) { return signed_depth_text(found); });
    case FATHOM_DIRECTION: {
      const Vector n = told(answer, [](const auto& found) { return direction_of(found); });
      return n.x.get_str() + " " + n.y.get_str() + " " + n.z.get_str();
    }
    case FATHOM_TRANSLATION: return text_of(told(answer, [](const auto& found) { return translation_of(found); }));
    case FATHOM_WITNESS_A: return text_of(told(answer, [](const auto& found) { return witness_of(found); })[0]);
    case FATHOM_WITNESS_B: return text_of(told(answer, [](const auto& found) { return witness_of(found); })[1]);
    case FATHOM_DEEPEST_PAIR: return text_of(Surd{0, bounds_of(answer).deepest_pair});
    case FATHOM_HULLS: return text_of(Surd{0, bounds_of(answer).hulls});
    default: throw std::invalid_argument("quantity: expected one from 0 to 6, found " + std::to_string(quantity));
  }
}

/// The answer in JSON.
struct Json {
  const fathom_answer& answer;
  const std::string& id;
  cli::Request request;

  [[nodiscard]] cli::AboutBodies bodies() const { return cli::about_bodies(Case{id, *answer.a, *answer.b}, false); }

  std::string operator()(const Depth& depth) const { return cli::json_result({id, depth, {}, bodies()}, request); }
  std::string operator()(const SignedDepth& depth) const {
    BodyFacts facts;
    facts.flat_a = is_flat(files::shape_of(*answer.a));
    facts.flat_b = is_flat(files::shape_of(*answer.b));
    return cli::shape_json({id, depth, facts, {}, bodies()}, request);
  }
  std::string operator()(UnionDepth depth) const {
    if (answer.listed && *answer.listed < depth.optima.size()) depth.optima.resize(*answer.listed);
    return cli::union_json({id, std::move(depth), bodies()}, request);
  }
};

std::string json_of(const fathom_answer& answer, const std::string& id) {
  cli::Request request;
  request.json = true;
  request.optima = answer.listed;
  return told(answer, Json{answer, id, request});
}

/// The certificate of the answer.
struct Proof {
  const Body &a, &b;
  const std::string& id;
  Monitor* monitor;

  std::string operator()(const Depth& depth) const { return certificate_text(a, b, depth, id, monitor); }
  std::string operator()(const SignedDepth& depth) const {
    return certificate_text(files::shape_of(a), files::shape_of(b), depth, id, ShapeFormat::shortest, monitor);
  }
  std::string operator()(const UnionDepth& depth) const {
    return certificate_text(pieces_of(a), pieces_of(b), complete(depth), id, monitor);
  }
};

std::string certificate_of(const fathom_answer& answer, const std::string& id, const fathom_options& options) {
  CallersMonitor monitor(options);
  std::string text = told(answer, Proof{*answer.a, *answer.b, id, &monitor});
  try {
    fathom_check::require_readable(text);
  } catch (const fathom_check::Unreadable& refusal) {
    throw Absence(refusal.what());
  }
  return text;
}

}  // namespace

RoundedDepth rounded(const Depth& depth) {
  const Surd value{0, signed_square(depth)};
  return {round_binary64(value), round_binary64(value, Rounding::rd), round_binary64(value, Rounding::ru)};
}

RoundedDepth rounded(const SignedDepth& depth) {
  const double low = depth.low_binary64(), high = depth.high_binary64();
  if (const Surd* const value = depth.exact()) return {round_binary64(*value), low, high};
  const double least = round_binary64(depth.bounds()->low), most = round_binary64(depth.bounds()->high);
  return {least == most ? least : std::numeric_limits<double>::quiet_NaN(), low, high};
}

RoundedDepth rounded(const UnionDepth& depth) {
  const mpq_class low = depth.apart ? mpq_class(-depth.apart->distance.squared) : depth.low, high = depth.apart ? low : depth.high;
  const double least = round_binary64(Surd{0, low}), most = round_binary64(Surd{0, high});
  return {least == most ? least : std::numeric_limits<double>::quiet_NaN(), round_binary64(Surd{0, low}, Rounding::rd),
          round_binary64(Surd{0, high}, Rounding::ru)};
}

int status_of(const Depth& depth) { return static_cast<int>(depth.status()); }
int status_of(const SignedDepth& depth) { return depth.status() ? static_cast<int>(*depth.status()) : FATHOM_UNDECIDED; }
int status_of(const UnionDepth& depth) { return static_cast<int>(depth.status); }

std::size_t ways_out(const fathom_answer& answer) {
  const std::size_t all = told(answer, [](const auto& found) { return optima_of(found); });
  return answer.listed ? std::min(all, *answer.listed) : all;
}

void require_way_out(const fathom_answer& answer, std::size_t index) {
  const std::size_t count = ways_out(answer);
  if (index < count) return;
  throw std::invalid_argument("index: expected one below " + std::to_string(count) + ", the number of optima, found " +
                              std::to_string(index));
}

const UnionBounds& bounds_of(const fathom_answer& answer) {
  const auto* const unions = std::get_if<UnionDepth>(&answer.found);
  if (!unions) throw Absence("no body is a union of pieces: there is one pair, and the hulls are the bodies");
  return unions->bounds.value();
}

}  // namespace fathom::c

using namespace fathom::c;

const char* fathom_status_name(int status) {
  if (status == FATHOM_UNDECIDED) return "undecided";
  return status < 0 || status > FATHOM_DISJOINT ? nullptr : fathom::name(static_cast<fathom::Status>(status)).data();
}

int fathom_answer_status(const fathom_answer* answer) {
  return answer ? told(*answer, [](const auto& found) { return status_of(found); }) : -1;
}

int fathom_answer_signed_depth(const fathom_answer* answer, double* nearest, double* low, double* high) {
  return guarded([&] {
    require(answer, "answer");
    const RoundedDepth value = told(*answer, [](const auto& found) { return rounded(found); });
    if (nearest) *nearest = value.nearest;
    if (low) *low = value.low;
    if (high) *high = value.high;
  });
}

int fathom_answer_direction(const fathom_answer* answer, double direction[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(direction, "direction");
    copy(fathom::rounded::unit(told(*answer, [](const auto& found) { return direction_of(found); })), direction);
  });
}

int fathom_answer_translation(const fathom_answer* answer, double translation[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(translation, "translation");
    copy(told(*answer, [](const auto& found) { return translation_of(found); }), translation);
  });
}

int fathom_answer_witness(const fathom_answer* answer, double a[3], double b[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(a, "a");
    require(b, "b");
    const CoordinatePair witness = told(*answer, [](const auto& found) { return witness_of(found); });
    copy(witness[0], a);
    copy(witness[1], b);
  });
}

size_t fathom_answer_optima(const fathom_answer* answer) {
  std::size_t count = 0;
  guarded([&] {
    require(answer, "answer");
    count = ways_out(*answer);
  });
  return count;
}

int fathom_answer_optimum(const fathom_answer* answer, size_t index, double direction[3], double translation[3]) {
  return guarded([&] {
    require(answer, "answer");
    require_way_out(*answer, index);
    const WayOut way = told(*answer, [index](const auto& found) { return way_out(found, index); });
    if (direction) copy(fathom::rounded::unit(way.direction), direction);
    if (translation) copy(way.translation, translation);
  });
}

int fathom_answer_exact(const fathom_answer* answer, int quantity, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    return exact_of(*answer, quantity);
  });
}

int fathom_answer_json(const fathom_answer* answer, const char* id, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    return json_of(*answer, id ? id : "");
  });
}

int fathom_answer_certificate(const fathom_answer* answer, const char* id, const fathom_options* options, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    return certificate_of(*answer, id ? id : "", options_from(options));
  });
}
