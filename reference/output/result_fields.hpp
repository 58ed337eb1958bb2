// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of results, once, in the order of JSON: of polytopes and shapes (fathom/result/2,
// approximate ones too), and of unions (fathom/union/1). Results are written by these tables;
// tests/harness/fields_test.cpp compares the schemas with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "reference/text/fields.hpp"
#include "reference/text/json.hpp"

namespace fathom::output {

using text::field;
using text::Json;

// ---- polytopes and shapes ----

struct Result {
  std::string id;
  std::optional<unsigned> dimension;
  std::string_view status;
  Json signed_depth = {}, depth = {}, translation = {}, direction = {}, contact = {}, witness = {};
  Json unit_f64 = {}, translation_f64 = {}, witness_f64 = {};
  Json optima = Json::array();
  std::optional<std::size_t> optima_count = {};
  std::optional<Json> optimal_cone = {}, around = {}, distance = {};
  Json sizes = {};
  std::optional<Json> hull = {};
  Json flat = {};
  std::string_view method = {};
  std::optional<Json> counters = {};
  std::optional<std::string> certificate = {}, delta = {};
  std::optional<std::uint64_t> rays = {};
  std::optional<Json> bound = {}, width = {}, manifold = {}, derivative = {};
};

inline constexpr std::tuple result_fields{
    field("id", &Result::id, "", "Of the case; for mesh files their names as given."),
    field("dimension", &Result::dimension, "",
          "2 of bodies of the plane: then vectors and points have two coordinates, and contacts are those of vertices "
          "and edges."),
    field("status", &Result::status, "",
          "Where O lies with respect to P = B (+) (-A): in its interior; on its boundary, or in a flat P; outside. "
          "undecided: the bounds of a signed depth leave it open."),
    field("signed_depth", &Result::signed_depth, "length",
          "Positive: the depth. 0: the bodies touch. Negative: the distance, with a minus sign."),
    field("depth", &Result::depth, "length", "0 unless penetrating. For width: of the body against itself."),
    field("translation", &Result::translation, "length",
          "Moving A by this makes the interiors disjoint; its length is the depth. null if only bounds are known."),
    field("direction", &Result::direction, "",
          "The outward normal of a nearest facet of P; disjoint: the direction of the distance, from B's nearest point "
          "to A's; touching, and not penetrating where no distance is told: a separating normal, or null for a flat P "
          "without need of one."),
    field("contact", &Result::contact, "",
          "Of the first optimum; disjoint: in the direction of the distance. null of polytopes that touch, of curved "
          "bodies, against a half-space, and of approx where no distance is told."),
    field("witness", &Result::witness, "length",
          "Points of both bodies, of the first optimum or where they touch; null if there are none, or none is known."),
    field("unit_f64", &Result::unit_f64, "ratio", "The unit vector in this direction."),
    field("translation_f64", &Result::translation_f64, "length", "The translation; null if there is none."),
    field("witness_f64", &Result::witness_f64, "length", "The witness points; null if there are none."),
    field("optima", &Result::optima, "",
          "Every direction that attains the depth, or with --optima N the first N, in lexicographic order; the first "
          "is the one shown above."),
    field("optima_count", &Result::optima_count, "", "With --optima: how many there are, listed or not."),
    field("optimal_cone", &Result::optimal_cone, "", "Of shapes whose cores touch."),
    field(
        "around", &Result::around, "",
        "Of bodies of revolution about one axis, unless the direction is that of the axis: whatever a turn about it "
        "makes of the direction is as good. An exact depth may have a direction that is only near to a best one, where "
        "no best one is rational."),
    field("distance", &Result::distance, "length",
          "Of disjoint bodies: the least distance of a point of A from one of B. Moving A by this translation, and by "
          "no shorter one, the bodies touch; h(direction) / |direction| is -distance."),
    field("sizes", &Result::sizes, "length",
          "The lengths of the bodies' boxes along x, y and z, to the nearest binary64; of bodies with discs or balls, "
          "upper bounds within a few units in the last place. null: not finite. Of width, A's alone."),
    field("hull", &Result::hull, "",
          "Of bodies that are meshes with faces: whether the mesh is the boundary of the hull that stands for it."),
    field("flat", &Result::flat, "",
          "The bodies without interior. For a flat A the depth is that of O in P, where the wording by interiors would "
          "give 0."),
    field("method", &Result::method, "", "The one that ran."),
    field("counters", &Result::counters, "", "With --counters."),
    field("certificate", &Result::certificate, "",
          "With --embed-certificate: the text of the answer's certificate (verify/check/FORMAT.md)."),
    field("delta", &Result::delta, "ratio",
          "Of `fathom approx` and `fathom width --delta`: bound <= the true depth <= depth <= (1 + delta) bound. Then "
          "no optimum is claimed, and the witness may be null: the foot of O on the facet's plane need not lie in the "
          "facet."),
    field("rays", &Result::rays, "", "With delta: how many rays were shot."),
    field("bound", &Result::bound, "length", "With delta: a lower bound of the true depth."),
    field("width", &Result::width, "length", "Of `fathom width` only: the same length as depth."),
    field("manifold", &Result::manifold, "",
          "With --patch: all contact points after each listed way out, or of bodies that touch or are apart; and "
          "whether the signed depth is differentiable by the poses."),
    field("derivative", &Result::derivative, "",
          "With --twist: how fast the signed depth changes while the bodies begin to move.")};
static_assert(text::stored_fields(result_fields) == text::member_count<Result>(), "each member of Result has its row");
constexpr const auto& fields_of(const Result*) { return result_fields; }

// ---- unions ----

struct UnionResult {
  std::string id;
  std::optional<unsigned> dimension;
  std::string_view status;
  bool complete;
  Json depth, low, high, optima, apart, deepest_pair, hulls, counters;
  std::optional<Json> hull = {}, solids = {};
  std::optional<std::string> certificate = {};
  std::optional<Json> manifold = {}, derivative = {};
};

inline constexpr std::tuple union_result_fields{
    field("id", &UnionResult::id, "", "The names of the files as given."),
    field("dimension", &UnionResult::dimension, "",
          "2 of bodies of the plane: then vectors and points have two coordinates, and contacts are those of vertices "
          "and edges."),
    field("status", &UnionResult::status, "", "Whether the interiors meet, or the bodies alone, or neither."),
    field("complete", &UnionResult::complete, "",
          "false: the search was interrupted, and low and high enclose the depth."),
    field("depth", &UnionResult::depth, "length", "null unless complete."),
    field("low", &UnionResult::low, "length", "A lower bound of the depth; the depth if complete."),
    field("high", &UnionResult::high, "length", "An upper bound of the depth; the depth if complete."),
    field("optima", &UnionResult::optima, "",
          "All shortest translations, if complete; of touching bodies the one of length 0."),
    field("apart", &UnionResult::apart, "", "null unless disjoint."),
    field("deepest_pair", &UnionResult::deepest_pair, "length",
          "The largest depth of a piece of A and a piece of B: never more than the depth."),
    field("hulls", &UnionResult::hulls, "length", "The depth of the hulls of the bodies: never less than the depth."),
    field("counters", &UnionResult::counters, "", "What the search did, in counts that do not depend on the machine."),
    field("hull", &UnionResult::hull, "", "Of bodies whose pieces are meshes with faces."),
    field("solids", &UnionResult::solids, "", "Of bodies that are the solids of closed meshes, cut into the pieces."),
    field("certificate", &UnionResult::certificate, "",
          "With --embed-certificate, if complete: the text of the answer's certificate (verify/check/FORMAT.md, "
          "sections 12 and 15)."),
    field("manifold", &UnionResult::manifold, "",
          "With --patch: all contact points after each listed way out, or of bodies that touch or are apart; and "
          "whether the signed depth is differentiable by the poses."),
    field("derivative", &UnionResult::derivative, "",
          "With --twist: how fast the signed depth changes while the bodies begin to move.")};
static_assert(text::stored_fields(union_result_fields) == text::member_count<UnionResult>(),
              "each member of UnionResult has its row");
constexpr const auto& fields_of(const UnionResult*) { return union_result_fields; }

// ---- their text ----

/// The fields that the struct has, behind those of `json`.
template <class Struct>
Json with_fields(Json json, const Struct& of) {
  json.reserve(2048);  // results about small bodies take less
  text::for_each_field(fields_of(&of), [&](const auto& row) {
    if (!text::has(row, of)) return;
    const auto& value = text::value_of(row, of);
    if constexpr (requires { *value; }) json[row.name] = *value;
    else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>) json[row.name] = Json::boolean(value);
    else json[row.name] = value;
  });
  return json;
}

/// One line, without its newline: the schema, the version of fathom, and the fields.
template <class Struct>
std::string line_of(std::string_view schema, std::string_view version, const Struct& of) {
  return with_fields({{"schema", schema}, {"fathom", version}}, of).text();
}

}  // namespace fathom::output
