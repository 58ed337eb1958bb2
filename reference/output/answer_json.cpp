// SPDX-License-Identifier: GPL-3.0-or-later
// Fields as in the schemas, and in their order.

#include "reference/output/answer_json.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/number/infinitesimal.hpp"
#include "reference/patch/patch.hpp"

namespace fathom::output {
namespace {

constexpr std::string_view result_schema = "fathom/result/2";

// ---- lengths ----

/// The lengths of an answer about two polytopes or shapes.
struct Lengths {
  Json signed_depth, depth, distance;  ///< distance: of disjoint bodies
};

/// Of polytopes: sign * sqrt(root), rounded in all ways by one integer root.
Lengths lengths_of(const Depth& depth, const std::optional<unsigned>& digits) {
  const mpq_class signed_squared = signed_square(depth), squared = signed_squared > 0 ? signed_squared : mpq_class(0);
  const kernels::Roundings rounded = kernels::roundings_of_root(squared);
  Lengths lengths{{}, length(squared, rounded, digits), {}};
  if (const Distance* const apart = depth.distance()) {
    const kernels::Roundings rounded_distance = kernels::roundings_of_root(apart->squared);
    lengths.signed_depth = signed_depth_object(apart_by(rounded_distance));
    lengths.distance = length(apart->squared, rounded_distance, digits);
  } else {
    lengths.signed_depth = signed_depth_object(penetrating_by(rounded));
  }
  lengths.signed_depth["exact"] = exact_object({0, signed_squared});
  return lengths;
}

/// What of an enclosed length is certain: nothing but its bounds, unless both round to the same
/// number.
Json enclosed_length(const Bounds& bounds, const std::optional<unsigned>& digits) {
  const mpq_class low = bounds.low > 0 ? bounds.low : mpq_class(0), high = bounds.high > 0 ? bounds.high : mpq_class(0);
  if (low == high) return length(low * low, digits);
  const double nearest = round_binary64(low);
  const bool known = nearest == round_binary64(high) && std::isfinite(nearest) && nearest != 0;
  Json result{{"squared", Json()}, {"value", known ? Json(nearest) : Json()}, {"rounded", Json()}};
  if (digits)
    result["enclosure"] = Json::array({enclose(Surd{low, 0}, *digits).low, enclose(Surd{high, 0}, *digits).high});
  return result;
}

Json length_of(const SignedDepth& depth, bool of_distance, const std::optional<unsigned>& digits) {
  if (!depth.status()) return {{"squared", Json()}, {"value", Json()}, {"rounded", Json()}};
  if (const Bounds* const bounds = depth.bounds())
    return enclosed_length(of_distance ? Bounds{-bounds->high, -bounds->low} : *bounds, digits);
  const Surd value = of_distance ? Surd{-depth.exact()->rational, -depth.exact()->root} : *depth.exact();
  return surd_length(sign(value) > 0 ? value : Surd{0, 0}, digits);
}

Lengths lengths_of(const SignedDepth& depth, const std::optional<unsigned>& digits) {
  return {signed_depth_object(depth), length_of(depth, false, digits),
          depth.status() == Status::disjoint ? length_of(depth, true, digits) : Json()};
}

// ---- places: of polytopes rational, of shapes rational but for a root ----

Json place(const Point& point, unsigned dimension = 3) { return exact(point, dimension); }
Json place(const AlongNormal& vector, unsigned dimension = 3) { return vector_object(vector, dimension); }
Json place(const RoundedPoint& point, unsigned dimension = 3) { return point_object(point, dimension); }

/// The field of results about bodies of the plane.
std::optional<unsigned> dimension_field(const Answer& answer) {
  return answer.prisms ? std::optional(answer.dimension()) : std::nullopt;
}

/// For each listed optimum, or of the distance: moving A by it, the bodies touch.
std::vector<Point> ways_of(const Depth& depth) {
  if (depth.distance()) return {depth.contact_translation()};
  std::vector<Point> ways;
  for (const Optimum& optimum : depth.optima()) ways.push_back(optimum.translation());
  return ways;
}
std::vector<AlongNormal> ways_of(const SignedDepth& depth) { return depth.translations(); }

/// What A is moved by where nothing is in the way.
Point staying(const Depth&) { return {}; }
AlongNormal staying(const SignedDepth& depth) { return {depth.direction(), 0, 0}; }

std::optional<Witness> witness_of(const Depth& depth) { return depth.contact_points(); }
std::optional<RoundedWitness> witness_of(const SignedDepth& depth) { return depth.witness(); }

template <class SomeWitness>
Json witness_json(const std::optional<SomeWitness>& witness, unsigned dimension) {
  return witness ? Json{{"a", place(witness->a, dimension)}, {"b", place(witness->b, dimension)}} : Json();
}

Json counters_object(const Counters& counters) {
  Json result;
  Json stages = Json::array();
  for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
    if (stage.ran()) stages.push_back(stage.stage);
    for (const kernels::Count& count : stage.counts) result[count.name] = count.value;
  }
  result["stages"] = stages;
  Json predicates = Json::object();
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    Json decided = Json::object();
    for (const auto& [packed, count] : tiers.decided) decided[kernels::Monomial::unpacked(packed).text()] = count;
    predicates[predicate_names[i]] = {
        {"calls", tiers.calls}, {"exact", tiers.exact}, {"zero", tiers.zero}, {"decided_by", decided}};
  }
  result["predicates"] = predicates;
  return result;
}

Json cone_object(const OptimalCone& cone, unsigned dimension = 3) {
  Json rays = Json::array();
  for (const Vector& ray : cone.rays) rays.push_back(exact(ray, dimension));
  const bool has_axis = cone.lineality == Lineality::line || cone.lineality == Lineality::plane;
  return {
      {"lineality", lineality_name(cone)}, {"axis", has_axis ? exact(cone.axis, dimension) : Json()}, {"rays", rays}};
}

// ---- contact manifolds ----

/// What is told with --patch and --twist, of any kinds of bodies.
template <class SomeResult>
void add_manifold(SomeResult& result, const AnsweredCase& answered, const Shown& shown) {
  if (!answered.manifold) return;
  if (shown.patch) result.manifold = manifold_object(*answered.manifold);
  if (answered.manifold->derivative)
    result.derivative = derivative_object(*answered.manifold->derivative, answered.answer.dimension());
}

Json on_face(const std::vector<std::uint32_t>& ids) { return ids.empty() ? Json() : Json(ids); }

Json corner_object(const Patch& patch, std::size_t k, unsigned dimension) {
  return {{"a", place(patch.a(k), dimension)},
          {"b", place(patch.b(k), dimension)},
          {"on_a", on_face(patch.corners[k].on_a)},
          {"on_b", on_face(patch.corners[k].on_b)}};
}

/// Adds what of the meshes holds a contact, of bodies that are solids.
template <class Met>
Json with_features(Json json, const Met& met) {
  for (const auto& [key, features] : {std::pair("mesh_a", &met.mesh_a), std::pair("mesh_b", &met.mesh_b)})
    if (!features->empty())
      json[key] = Json::array_of(*features, [](const MeshFeature& f) {
        return Json{{"kind", name(f.kind)}, {"ids", f.ids}};
      });
  return json;
}

Json patch_object(const Manifold& manifold, const Patch& patch) {
  const unsigned dimension = manifold.geometry.dimension;
  const auto pair = [&](const RoundedWitness& points) { return witness_json(std::optional(points), dimension); };
  Json corners = Json::array();
  for (std::size_t k = 0; k < patch.corners.size(); ++k) corners.push_back(corner_object(patch, k, dimension));
  Json result{{"rank", patch.rank()}, {"direction", exact(patch.direction, dimension)}};
  if (manifold.geometry.of_unions) {
    result["optimum"] = patch.way;
    result["pieces"] = std::vector<std::uint32_t>{patch.pieces.first, patch.pieces.second};
  }
  result["corners"] = corners;
  result["centroid"] = pair(patch.centroid());
  result["size"] = patch.rank() == 0 ? Json() : length(patch.squared(), std::nullopt);
  if (!manifold.with_slack.empty()) {
    const auto& corners = manifold.with_slack[static_cast<std::size_t>(&patch - manifold.geometry.patches.data())];
    result["with_slack"] = corners ? Json::array_of(*corners, pair) : Json();
  }
  return with_features(std::move(result), patch);
}

// ---- polytopes and shapes ----

/// `found`: what `answered` holds, Depth or SignedDepth.
template <class Found>
std::string found_json(const AnsweredCase& answered, const Found& found, const Shown& shown) {
  const unsigned dimension = answered.answer.dimension();
  const std::optional<Status> status = found.status();
  const Depth* const core = answered.answer.core();
  const Penetration* const cores = core ? core->penetration() : nullptr;
  const Lengths lengths = lengths_of(found, shown.digits);
  const auto ways = ways_of(found);
  const auto first = ways.empty() ? std::nullopt : std::optional(ways.front());
  const auto translation =
      status == Status::touching || status == Status::disjoint ? std::optional(staying(found)) : first;
  const Json translation_json = translation ? place(*translation, dimension) : Json();
  const auto witness = witness_of(found);
  const auto shown_witness = status == Status::disjoint ? std::nullopt : witness;
  const Vector direction = found.direction();
  const Json direction_json = exact(direction, dimension);
  const Json contact = found.contact() ? contact_object(*found.contact()) : Json();

  Json optima = Json::array();
  for (std::size_t i = 0; status == Status::penetrating && i < ways.size(); ++i)
    optima.push_back({{"direction", i == 0 || !cores ? direction_json : exact(cores->optima[i].direction, dimension)},
                      {"translation", i == 0 ? translation_json : place(ways[i], dimension)},
                      {"contact", cores ? contact_object(cores->optima[i].contact) : contact}});
  Result result{answered.id,
                dimension_field(answered.answer),
                answered.answer.status_name(),
                lengths.signed_depth,
                lengths.depth,
                translation_json,
                direction_json,
                contact,
                witness_json(shown_witness, dimension),
                unit_f64(direction, dimension),
                translation_f64(translation, dimension),
                witness_f64(shown_witness, dimension),
                optima};
  if (shown.optima && cores) result.optima_count = cores->optima.size() + cores->unlisted;
  else if (shown.optima) result.optima_count = status == Status::penetrating ? ways.size() : 0;
  if constexpr (std::is_same_v<Found, SignedDepth>) {
    if (found.cone) result.optimal_cone = cone_object(*found.cone, dimension);
    if (const Vector* const axis = found.around()) result.around = Json{{"axis", exact(*axis)}};
  }
  if (status == Status::disjoint) {
    Json& distance = result.distance.emplace(lengths.distance);
    distance["direction"] = direction_json;
    distance["translation"] = first ? place(*first, dimension) : Json();
    distance["witness"] = witness_json(witness, dimension);
    distance["unit_f64"] = result.unit_f64;
    distance["translation_f64"] = translation_f64(first, dimension);
    distance["witness_f64"] = witness_f64(witness, dimension);
  }
  result.sizes = sizes_object(answered.bodies.sizes);
  result.hull = hull_object(answered.bodies.hull);
  result.flat = flat_array(answered.facts);
  result.method = method_name(found);
  if (shown.counters) result.counters = counters_object(counters_of(found));
  if (shown.certificate) result.certificate = answered.certificate;
  if (shown.width) result.width = lengths.depth;
  add_manifold(result, answered, shown);
  return result_line(result);
}

// ---- unions ----

Json contact_json(const PieceContact& c, unsigned dimension) {
  return with_features({{"pieces", std::vector<std::uint32_t>{c.a, c.b}},
                        {"direction", exact(c.direction, dimension)},
                        {"contact", contact_object(c.contact)}},
                       c);
}

Json optimum_json(const UnionOptimum& optimum, unsigned dimension) {
  Json contacts = Json::array();
  for (const PieceContact& c : optimum.contacts) contacts.push_back(contact_json(c, dimension));
  return {{"translation", exact(optimum.translation, dimension)},
          {"clearance", Json::boolean(optimum.clearance)},
          {"contacts", contacts}};
}

Json distance_json(const UnionDistance& apart, const Shown& shown, unsigned dimension) {
  const Distance& d = apart.distance;
  return with_features({{"distance", length(d.squared, shown.digits)},
                        {"pieces", std::vector<std::uint32_t>{apart.a, apart.b}},
                        {"translation", exact(d.translation, dimension)},
                        {"witness", witness_object(d.witness, dimension)},
                        {"contact", contact_object(d.contact)}},
                       apart);
}

std::string found_json(const AnsweredCase& answered, const UnionDepth& depth, const Shown& shown) {
  const unsigned dimension = answered.answer.dimension();
  Json optima = Json::array();
  for (std::size_t i = 0; i < depth.optima.size() && (!shown.optima || i < *shown.optima); ++i)
    optima.push_back(optimum_json(depth.optima[i], dimension));
  const UnionBounds& bounds = *depth.bounds;
  const UnionCounters& c = depth.counters;
  UnionResult result{answered.id,
                     dimension_field(answered.answer),
                     name(depth.status),
                     depth.complete,
                     depth.complete ? length(depth.low, shown.digits) : Json(),
                     length(depth.low, shown.digits),
                     length(depth.high, shown.digits),
                     optima,
                     depth.apart ? distance_json(*depth.apart, shown, dimension) : Json(),
                     {{"depth", length(bounds.deepest_pair, std::nullopt)},
                      {"pieces", std::vector<std::uint32_t>{bounds.a, bounds.b}}},
                     length(bounds.hulls, std::nullopt),
                     {{"nodes", c.nodes},
                      {"nearest_points", c.nearest_points},
                      {"pairs", c.pairs},
                      {"pairs_touched", c.pairs_touched}},
                     hull_object(answered.bodies.hull),
                     solids_object(answered.bodies)};
  if (shown.certificate && depth.complete) result.certificate = answered.certificate;
  add_manifold(result, answered, shown);
  return line_of("fathom/union/1", FATHOM_VERSION, result);
}

}  // namespace

std::string result_line(const Result& result) { return line_of(result_schema, FATHOM_VERSION, result); }

std::string_view lineality_name(const OptimalCone& cone) {
  constexpr std::array<std::string_view, 4> names{"none", "line", "plane", "all"};
  return names.at(static_cast<std::size_t>(cone.lineality));
}

std::string_view method_name(const Depth& depth) { return depth.method ? name(*depth.method) : "shallow"; }

std::string_view method_name(const SignedDepth& depth) {
  if (const Depth* const cores = std::get_if<Depth>(&depth.core)) return method_name(*cores);
  return std::holds_alternative<PlaneSupport>(depth.core) ? "support" : "enclosure";
}

Manifold manifold_of(const Body& a, const Body& b, const Answer& answer, const std::optional<Motion>& motion,
                     Monitor* monitor, const std::optional<mpq_class>& slack) {
  Manifold manifold{contact_geometry(a, b, answer, monitor), {}};
  if (slack)
    for (const Patch& patch : manifold.geometry.patches)
      manifold.with_slack.push_back(patch::with_slack(a, b, patch, *slack));
  manifold.weights = vertex_weights(a, b, manifold.geometry);
  if (motion) manifold.derivative = directional_derivative(manifold.geometry, motion->of_a, motion->of_b);
  return manifold;
}

std::string certificate_of(const Body& a, const Body& b, const Answer& answer, const Manifold* manifold,
                           std::span<const Twist> motions, std::string_view id, Monitor* monitor) {
  if (!manifold || !manifold->geometry.tells_smoothness() || answer.prisms)
    return certificate_text(a, b, answer, id, monitor);
  return certificate_text(a, b, answer, manifold->geometry, motions, id, monitor);
}

namespace {

/// By a turn of the plane it is one number.
Json gradient_f64(const Gradient& gradient, unsigned dimension) {
  const std::array<double, 3> by_w = rounded::nearest_binary64(gradient.by_rotation());
  return {{"v", numbers(rounded::nearest_binary64(gradient.by_translation()), dimension)},
          {"w", dimension == 2 ? (std::isfinite(by_w[2]) ? Json(by_w[2]) : Json()) : numbers(by_w)}};
}

}  // namespace

Json manifold_object(const Manifold& manifold) {
  const ContactGeometry& g = manifold.geometry;
  const std::optional<Gradient> gradient = g.gradient();
  const bool smoothness = g.tells_smoothness();
  Json result{{"patches", g.no_patches ? Json() : Json::array_of(g.patches, [&](const Patch& patch) {
                 return patch_object(manifold, patch);
               })}};
  result["smooth"] = smoothness ? Json::boolean(g.smooth()) : Json();
  result["kinks"] = smoothness ? Json::array_of(g.kinks, [](Kink kink) { return Json(name(kink)); }) : Json();
  const unsigned dimension = g.dimension;
  result["gradient"] =
      gradient ? Json{{"normal", exact(gradient->normal, dimension)}, {"point", exact(gradient->point, dimension)}}
               : Json();
  result["gradient_f64"] = gradient ? gradient_f64(*gradient, dimension) : Json();
  result["vertex_weights"] =
      manifold.weights ? Json{{"a", weights_array(manifold.weights->a)}, {"b", weights_array(manifold.weights->b)}}
                       : Json();
  if (g.cone) result["optimal_cone"] = cone_object(*g.cone, dimension);
  if (g.no_patches) result["left_out"] = name(*g.no_patches);
  return result;
}

Json derivative_object(const std::variant<DirectionalDerivative, LeftOut>& derivative, unsigned dimension) {
  if (const LeftOut* const reason = std::get_if<LeftOut>(&derivative)) return {{"left_out", name(*reason)}};
  const DirectionalDerivative& d = std::get<DirectionalDerivative>(derivative);
  const Surd value = d.value();
  const auto unsigned_zero = [](double x) { return x == 0 ? 0.0 : x; };
  Json rate = signed_depth_object(
      {unsigned_zero(round_binary64(value, Rounding::rd)), unsigned_zero(round_binary64(value, Rounding::ru))});
  rate["exact"] = exact_object(value);
  const double nearest = unsigned_zero(round_binary64(value));
  const bool told = std::isfinite(nearest) && (nearest != 0 || d.sign() == 0);
  return {{"rate", rate},
          {"value", told ? Json(nearest) : Json()},
          {"direction", exact(d.direction, dimension)},
          {"patch", d.patch},
          {"corner", d.corner}};
}

std::string answer_json(const AnsweredCase& answered, const Shown& shown) {
  return std::visit([&](const auto& found) { return found_json(answered, found, shown); }, answered.answer.found);
}

std::string json_error(const std::string& id, std::size_t line, std::string_view error) {
  return error_object(result_schema, id, line, error);
}

}  // namespace fathom::output
