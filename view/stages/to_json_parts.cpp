// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/stages/to_json_parts.hpp"

#include <algorithm>
#include <cmath>

namespace fathom::stages {
namespace {

// Of so many facets, the nearest, the exact squared distance is given: it is long.
constexpr std::size_t exact_facets = 500;

void write_facet(text::JsonStream& json, const StagedFacet& facet, bool exactly) {
  static constexpr std::array<std::string_view, 4> kinds{"facet_of_a", "facet_of_b", "edges", "merged"};
  json.object([&] {
    json.key("vertices"), json.array_of(facet.vertices);
    json.key("normal"), json.numbers(facet.normal, places_digits);
    json.key("distance"), json.number(facet.distance, places_digits);
    if (exactly && facet.squared > 0) json.key("distance_squared"), json.exact(facet.squared);
    json.key("kind"), json.string(kinds[static_cast<std::size_t>(facet.kind)]);
    json.key("a"), json.array_of(facet.a);
    json.key("b"), json.array_of(facet.b);
    json.key("pairs"), json.array_of(facet.pairs);
    json.key("optimal"), json.boolean(facet.optimal);
  });
}

void write_sum(text::JsonStream& json, const StagedSum& sum) {
  static constexpr std::array<std::string_view, 4> kinds{"none", "P", "Q", "sampled"};
  json.object([&] {
    json.key("kind"), json.string(kinds[static_cast<std::size_t>(sum.kind)]);
    json.key("vertices"), json.array_of(sum.vertices, [&](const Place& p) { json.numbers(p, places_digits); });
    json.key("origin"), json.numbers({0, 0, 0}, places_digits);
    json.key("facets"), json.array([&] {
      for (std::size_t i = 0; i < sum.facets.size(); ++i) write_facet(json, sum.facets[i], i < exact_facets || sum.facets[i].optimal);
    });
  });
}

void write_involved(text::JsonStream& json, const StagedInvolved& involved) {
  const auto features = [&](const auto& list) { json.array_of(list, [&](const auto& points) { json.array_of(points); }); };
  json.object([&] {
    json.key("a"), features(involved.a);
    json.key("b"), features(involved.b);
    json.key("decided_by"), json.array_of(involved.decided_by, [&](const std::string& monomial) { json.string(monomial); });
  });
}

void write_coincidence(text::JsonStream& json, const StagedCoincidence& coincidence) {
  json.object([&] {
    json.key("kind"), json.string(coincidence.kind);
    json.key("count"), json.integer(coincidence.count);
    json.key("listed"), json.array_of(coincidence.listed, [&](const StagedInvolved& involved) { write_involved(json, involved); });
  });
}

void write_decision(text::JsonStream& json, const StagedDecision& decision) {
  json.object([&] {
    json.key("predicate"), json.string(decision.predicate);
    json.key("zero"), json.integer(decision.zero);
    json.key("monomials"), json.array_of(decision.monomials, [&](const StagedMonomial& monomial) {
      json.object([&] {
        json.key("name"), json.string(monomial.name);
        json.key("count"), json.integer(monomial.count);
      });
    });
  });
}

void write_bound(text::JsonStream& json, const StagedBound& bound, const Stages& stages) {
  json.object([&] {
    json.key("stage"), json.string(bound.stage);
    json.key("what"), json.string(bound.what);
    json.key("count"), json.integer(bound.count);
    json.key("bound"), json.string(bound.bound);
    json.key("bound_value");
    if (std::isfinite(bound.bound_value)) json.number(bound.bound_value, places_digits);
    else json.null();
    json.key("source"), json.string(bound.source);
    const auto seconds = std::ranges::find(stages.seconds, bound.stage, [](const auto& stage) { return std::string_view(stage.first); });
    if (seconds != stages.seconds.end()) json.key("seconds"), json.number(seconds->second, places_digits);
  });
}

}  // namespace

void write_parts(text::JsonStream& json, const Stages& stages) {
  json.key("sum"), write_sum(json, stages.sum);
  json.key("coincidences"), json.array_of(stages.coincidences, [&](const StagedCoincidence& c) { write_coincidence(json, c); });
  json.key("decided"), json.array_of(stages.decided, [&](const StagedDecision& d) { write_decision(json, d); });
}

void write_costs(text::JsonStream& json, const Stages& stages) {
  json.key("bounds"), json.array_of(stages.bounds, [&](const StagedBound& bound) { write_bound(json, bound, stages); });
  if (stages.seconds.empty()) return;
  json.key("seconds"), json.object([&] {
    for (const auto& [stage, seconds] : stages.seconds) json.key(stage), json.number(seconds, places_digits);
  });
}

}  // namespace fathom::stages
