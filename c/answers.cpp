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
#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/surd.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/rounded/coordinates.hpp"

namespace fathom::c {
namespace {

using rounded::CoordinatePair;
using rounded::Coordinates;
using rounded::coordinates;

constexpr const char* only_bounds = "only bounds of the signed depth are known: nothing follows from them exactly";

const Depth* of_polytopes(const fathom_answer& answer) { return std::get_if<Depth>(&answer.found); }
const SignedDepth& of_shapes(const fathom_answer& answer) { return std::get<SignedDepth>(answer.found); }

Vector direction_of(const fathom_answer& answer) {
  const Depth* const depth = of_polytopes(answer);
  return depth ? depth->direction() : of_shapes(answer).direction();
}

Coordinates translation_of(const fathom_answer& answer) {
  if (const Depth* const depth = of_polytopes(answer))
    return coordinates(depth->distance() ? depth->distance()->translation : depth->translation());
  const std::vector<AlongNormal> all = of_shapes(answer).translations();
  if (all.empty()) throw Absence(only_bounds);
  return coordinates(all.front());
}

CoordinatePair witness_of(const fathom_answer& answer) {
  if (const Depth* const depth = of_polytopes(answer))
    return coordinates(depth->distance() ? depth->distance()->witness : depth->witness().value());
  const std::optional<RoundedWitness> witness = of_shapes(answer).witness();
  if (!witness) throw Absence(only_bounds);
  return coordinates(*witness);
}

/// A shortest way out.
struct WayOut {
  Vector direction;
  Coordinates translation;
};

std::vector<AlongNormal> ways_of_shapes(const fathom_answer& answer) {
  const SignedDepth& depth = of_shapes(answer);
  return depth.status() == Status::penetrating ? depth.translations() : std::vector<AlongNormal>{};
}

std::size_t ways_out(const fathom_answer& answer) {
  const Depth* const depth = of_polytopes(answer);
  return depth ? depth->optima().size() : ways_of_shapes(answer).size();
}

WayOut way_out(const fathom_answer& answer, std::size_t index) {
  const std::size_t count = ways_out(answer);
  if (index >= count)
    throw std::invalid_argument("index: expected one below " + std::to_string(count) + ", the number of optima, found " +
                                std::to_string(index));
  if (const Depth* const depth = of_polytopes(answer))
    return {depth->optima()[index].direction, coordinates(depth->optima()[index].translation())};
  const AlongNormal way = ways_of_shapes(answer)[index];
  return {way.normal, coordinates(way)};
}

void copy(const Coordinates& from, double* to) { std::ranges::copy(rounded::nearest_binary64(from), to); }

// ---- exact texts ----

std::string text_of(const Surd& value) {
  std::string text = kernels::exact_surd_text(value);
  std::erase(text, ' ');
  return text;
}

std::string text_of(const Coordinates& values) { return text_of(values[0]) + " " + text_of(values[1]) + " " + text_of(values[2]); }

std::string signed_depth_text(const fathom_answer& answer) {
  if (const Depth* const depth = of_polytopes(answer)) return text_of(Surd{0, signed_square(*depth)});
  const SignedDepth& depth = of_shapes(answer);
  if (const Surd* const value = depth.exact()) return text_of(*value);
  return "[" + exact_text(depth.bounds()->low) + "," + exact_text(depth.bounds()->high) + "]";
}

std::string exact_of(const fathom_answer& answer, int quantity) {
  switch (quantity) {
    case FATHOM_SIGNED_DEPTH: return signed_depth_text(answer);
    case FATHOM_DIRECTION: {
      const Vector n = direction_of(answer);
      return n.x.get_str() + " " + n.y.get_str() + " " + n.z.get_str();
    }
    case FATHOM_TRANSLATION: return text_of(translation_of(answer));
    case FATHOM_WITNESS_A: return text_of(witness_of(answer)[0]);
    case FATHOM_WITNESS_B: return text_of(witness_of(answer)[1]);
    default: throw std::invalid_argument("quantity: expected one from 0 to 4, found " + std::to_string(quantity));
  }
}

std::string json_of(const fathom_answer& answer, const std::string& id) {
  cli::Request request;
  request.json = true;
  request.optima = answer.listed;
  const cli::AboutBodies bodies = cli::about_bodies(Case{id, *answer.a, *answer.b}, false);
  if (const Depth* const depth = of_polytopes(answer)) return cli::json_result({id, *depth, {}, bodies}, request);
  BodyFacts facts;
  facts.flat_a = is_flat(files::shape_of(*answer.a));
  facts.flat_b = is_flat(files::shape_of(*answer.b));
  return cli::shape_json({id, of_shapes(answer), facts, {}, bodies}, request);
}

std::string certificate_of(const fathom_answer& answer, const std::string& id, const fathom_options& options) {
  CallersMonitor monitor(options);
  if (const Depth* const depth = of_polytopes(answer)) return certificate_text(*answer.a, *answer.b, *depth, id, &monitor);
  return certificate_text(files::shape_of(*answer.a), files::shape_of(*answer.b), of_shapes(answer), id, ShapeFormat::shortest, &monitor);
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

int status_of(const Depth& depth) { return static_cast<int>(depth.status()); }
int status_of(const SignedDepth& depth) { return depth.status() ? static_cast<int>(*depth.status()) : FATHOM_UNDECIDED; }

}  // namespace fathom::c

using namespace fathom::c;

const char* fathom_status_name(int status) {
  if (status == FATHOM_UNDECIDED) return "undecided";
  return status < 0 || status > FATHOM_DISJOINT ? nullptr : fathom::name(static_cast<fathom::Status>(status)).data();
}

int fathom_answer_status(const fathom_answer* answer) {
  return answer ? std::visit([](const auto& found) { return status_of(found); }, answer->found) : -1;
}

int fathom_answer_signed_depth(const fathom_answer* answer, double* nearest, double* low, double* high) {
  return guarded([&] {
    require(answer, "answer");
    const RoundedDepth value = std::visit([](const auto& found) { return rounded(found); }, answer->found);
    if (nearest) *nearest = value.nearest;
    if (low) *low = value.low;
    if (high) *high = value.high;
  });
}

int fathom_answer_direction(const fathom_answer* answer, double direction[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(direction, "direction");
    copy(fathom::rounded::unit(direction_of(*answer)), direction);
  });
}

int fathom_answer_translation(const fathom_answer* answer, double translation[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(translation, "translation");
    copy(translation_of(*answer), translation);
  });
}

int fathom_answer_witness(const fathom_answer* answer, double a[3], double b[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(a, "a");
    require(b, "b");
    const CoordinatePair witness = witness_of(*answer);
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
    const WayOut way = way_out(*answer, index);
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
