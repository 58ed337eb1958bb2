// SPDX-License-Identifier: GPL-3.0-or-later
// Stages as JSON: of convex bodies, schema fathom/stages/1, in the order of its fields; then of
// unions.
#include <algorithm>
#include <cmath>

#include "kernels/context.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/text/json.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {
namespace {

constexpr std::string_view unit_sentence = "A place is (input - center) * 2^exponent; a length is input * 2^exponent.";

// Digits of places, relative to the largest coordinate of both bodies; more if a body is small
// beside it, or much thinner than long.
constexpr int usual_digits = 6, most_digits = 17;

constexpr int places_digits = 7;  // of lengths and angles

double largest_coordinate(const StagedBody& body) {
  double most = 0;
  for (const Place& p : body.vertices) most = std::max({most, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return most;
}

// Returns the least of the body's extents along the axes that is not 0; infinity if all are 0.
double least_extent(const StagedBody& body) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::ranges::minmax_element(body.vertices, {}, [axis](const Place& p) { return p[axis]; });
    if (low != body.vertices.end() && (*high)[axis] > (*low)[axis])
      least = std::min(least, (*high)[axis] - (*low)[axis]);
  }
  return least;
}

int digits_for(const StagedBody& body, double largest) {
  const double extent = least_extent(body);
  if (largest == 0 || !std::isfinite(extent)) return usual_digits;
  return std::clamp(usual_digits + static_cast<int>(std::ceil(std::log10(largest / extent))), usual_digits,
                    most_digits);
}

void write_body(text::JsonStream& json, const StagedBody& body, bool of_a, double largest) {
  const int digits = digits_for(body, largest);
  json.object([&] {
    json.key("rank"), json.integer(body.rank);
    if (body.sampled) json.key("sampled"), json.boolean(true);
    json.key("ids"), json.array_of(body.ids);
    json.key("vertices"), json.array_of(body.vertices, [&](const Place& p) { json.numbers(p, digits); });
    json.key("edges"),
        json.array_of(body.edges, [&](const auto& edge) { json.array_of(edge, [&](Index v) { json.integer(v); }); });
    json.key("facets"), json.array_of(body.facets, [&](const Indices& facet) { json.array_of(facet); });
    json.key("arcs_of"), json.string(of_a ? "-A" : "B");
    json.key("nodes"), json.array_of(body.nodes, [&](const Place& n) { json.numbers(n, usual_digits); });
    json.key("arcs"), json.array_of(body.arcs, [&](const auto& arc) {
      json.array_of(arc, [&](const std::optional<Index>& node) { json.integer_or_null(node); });
    });
    if (!body.circles.empty())
      json.key("circles"), json.array_of(body.circles, [&](const Place& n) { json.numbers(n, usual_digits); });
  });
}

void write_features(text::JsonStream& json, const std::optional<Contact>& contact) {
  if (!contact) {
    json.null();
    return;
  }
  json.object([&] {
    json.key("a"), json.array_of(contact->a);
    json.key("b"), json.array_of(contact->b);
  });
}

void write_contact(text::JsonStream& json, const StagedContact& contact) {
  json.object([&] {
    json.key("direction"), json.numbers(contact.direction, places_digits);
    json.key("translation"), json.numbers(contact.translation, places_digits);
    json.key("features"), write_features(json, contact.features);
    json.key("kind");
    if (contact.features) json.string(name(contact.features->kind));
    else json.null();
    json.key("optima"), json.array_of(contact.optima, [&](const StagedOptimum& optimum) {
      json.object([&] {
        json.key("direction"), json.numbers(optimum.direction, places_digits);
        json.key("translation"), json.numbers(optimum.translation, places_digits);
        if (!optimum.contact) return;
        json.key("features"), write_features(json, optimum.contact);
        json.key("kind"), json.string(name(optimum.contact->kind));
      });
    });
  });
}

void write_diagram(text::JsonStream& json, const StagedDiagram& diagram) {
  json.object([&] {
    json.key("nodes"), json.array_of(diagram.nodes, [&](const StagedNode& node) {
      json.array([&] {
        json.integer(node.node), json.number(node.longitude, places_digits), json.number(node.latitude, places_digits);
      });
    });
    json.key("arcs"), json.array_of(diagram.arcs, [&](const StagedArc& arc) {
      json.array([&] { json.integer(arc.edge), json.integer_or_null(arc.from), json.integer_or_null(arc.to); });
    });
  });
}

void write_chart(text::JsonStream& json, const StagedChart& chart) {
  json.object([&] {
    json.key("hemisphere"), json.string(chart.upper ? "upper" : "lower");
    json.key("frame"), json.object([&] {
      json.key("v"), json.numbers(chart.v, usual_digits);
      json.key("z"), json.numbers(chart.z, usual_digits);
    });
    json.key("a"), write_diagram(json, chart.a);
    json.key("b"), write_diagram(json, chart.b);
    json.key("walls"), json.array_of(chart.walls, [&](const StagedWall& wall) {
      json.array([&] { json.string(wall.of_a ? "a" : "b"), json.integer(wall.node); });
    });
  });
}

void write_closest(text::JsonStream& json, const ClosestPair& closest, bool exactly) {
  json.object([&] {
    json.key("a"), json.integer(closest.a);
    json.key("b"), json.integer(closest.b);
    json.key("distance"), json.number(closest.distance, places_digits);
    if (exactly) json.key("distance_squared"), json.exact(closest.squared);
  });
}

void write_pair(text::JsonStream& json, const StagedPair& pair, bool won) {
  json.object([&] {
    json.key("chart"), json.integer(pair.chart);
    json.key("stored_of"), json.string(pair.stored_of_a ? "a" : "b");
    json.key("rising"), json.boolean(pair.rising);
    json.key("a"), json.array_of(pair.a);
    json.key("b"), json.array_of(pair.b);
    json.key("strip"), json.array_of(pair.strip, [&](const std::optional<Index>& wall) { json.integer_or_null(wall); });
    json.key("closest");
    if (pair.closest) write_closest(json, *pair.closest, won || pair.crossings() > 1);
    else json.null();
    json.key("evaluated"), json.integer(pair.evaluated);
    json.key("engine");
    if (pair.fate == PairFate::none) json.null();
    else json.string(pair.fate == PairFate::scanned ? "scanned" : pair.fate == PairFate::cleared ? "cleared" : "cut");
  });
}

void write_run(text::JsonStream& json, const std::array<Index, 2>& run) {
  json.array_of(run, [&](Index i) { json.integer(i); });
}

void write_level(text::JsonStream& json, const StagedLevel& level, std::size_t depth) {
  static constexpr std::array<std::string_view, 4> fates{"cleared", "refined", "scanned", "won"};
  json.object([&] {
    json.key("level"), json.integer(depth);
    json.key("side");
    if (level.cut_a) json.string(*level.cut_a ? "a" : "b");
    else json.null();
    json.key("blocks"), json.array_of(level.blocks, [&](const StagedBlock& block) {
      json.object([&] {
        json.key("rows"), write_run(json, block.rows);
        json.key("columns"), write_run(json, block.columns);
        json.key("fate"), json.string(fates[static_cast<std::size_t>(block.fate)]);
      });
    });
  });
}

void write_cutting(text::JsonStream& json, const StagedCutting& cutting) {
  json.object([&] {
    json.key("pair"), json.integer(cutting.pair);
    json.key("of"), json.string(cutting.winner ? "winner" : "largest");
    json.key("as_searched"), json.boolean(cutting.as_searched);
    json.key("levels"), json.array([&] {
      for (std::size_t k = 0; k < cutting.levels.size(); ++k) write_level(json, cutting.levels[k], k);
    });
  });
}

void write_feature(text::JsonStream& json, const StagedFeature& feature) {
  static constexpr std::array<std::string_view, 3> kinds{"vertex", "edge", "facet"};
  json.object([&] {
    json.key("kind"), json.string(kinds[static_cast<std::size_t>(feature.kind)]);
    json.key("index"), json.integer(feature.index);
  });
}

void write_winner(text::JsonStream& json, const StagedWinner& winner) {
  static constexpr std::array<std::string_view, 3> kinds{"edges", "facet_of_a", "facet_of_b"};
  json.object([&] {
    json.key("kind"), json.string(kinds[static_cast<std::size_t>(winner.kind)]);
    json.key("pair"), json.integer_or_null(winner.pair);
    json.key("a"), write_feature(json, winner.a);
    json.key("b"), write_feature(json, winner.b);
  });
}

// The number of facets, the nearest ones, whose exact squared distance, a long number, is written.
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
      for (std::size_t i = 0; i < sum.facets.size(); ++i)
        write_facet(json, sum.facets[i], i < exact_facets || sum.facets[i].optimal);
    });
  });
}

void write_shape_feature(text::JsonStream& json, const ShapeFeature& feature) {
  json.object([&] {
    json.key("feature"), json.string(feature.what);
    if (feature.length) json.key("length"), json.string(kernels::exact_surd_text(*feature.length));
    if (!is_zero(feature.direction)) json.key("direction"), json.exact(feature.direction);
    if (feature.point) json.key("point"), json.exact(*feature.point);
  });
}

void write_involved(text::JsonStream& json, const StagedInvolved& involved) {
  const auto features = [&](const auto& list) {
    json.array_of(list, [&](const auto& points) { json.array_of(points); });
  };
  json.object([&] {
    json.key("a"), features(involved.a);
    json.key("b"), features(involved.b);
    json.key("decided_by"),
        json.array_of(involved.decided_by, [&](const std::string& monomial) { json.string(monomial); });
    if (!involved.shapes) return;
    json.key("features"), json.object([&] {
      json.key("a"), write_shape_feature(json, involved.shapes->a);
      json.key("b"), write_shape_feature(json, involved.shapes->b);
    });
  });
}

void write_coincidence(text::JsonStream& json, const StagedCoincidence& coincidence) {
  json.object([&] {
    json.key("kind"), json.string(coincidence.kind);
    json.key("count"), json.integer(coincidence.count);
    json.key("listed"),
        json.array_of(coincidence.listed, [&](const StagedInvolved& involved) { write_involved(json, involved); });
  });
}

void write_decision(text::JsonStream& json, const StagedDecision& decision) {
  json.object([&] {
    json.key("predicate"), json.string(decision.predicate);
    json.key("calls"), json.integer(decision.calls);
    json.key("exact"), json.integer(decision.exact);
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
    const auto seconds =
        std::ranges::find(stages.seconds, bound.stage, [](const auto& stage) { return std::string_view(stage.first); });
    if (seconds != stages.seconds.end()) json.key("seconds"), json.number(seconds->second, places_digits);
  });
}

void write_head(text::JsonStream& json, const Stages& stages) {
  json.key("schema"), json.string("fathom/stages/1");
  json.key("id"), json.string(stages.id);
  json.key("status"), json.string(name(stages.status));
  json.key("depth");
  if (stages.depth) json.number(*stages.depth, 0);
  else json.null();
  json.key("depth_squared");
  if (stages.squared) json.exact(*stages.squared);
  else json.null();
  json.key("scale"), json.object([&] {
    const Point& center = stages.scale.center;
    json.key("center"), json.array([&] { json.exact(center.x), json.exact(center.y), json.exact(center.z); });
    json.key("exponent"), json.integer(stages.scale.exponent);
    json.key("unit"), json.string(unit_sentence);
  });
}

void write_counts(text::JsonStream& json, const Counters& counters) {
  json.object([&] {
    for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
      for (const kernels::Count& count : stage.counts) json.key(count.name), json.integer(count.value);
    }
  });
}

constexpr int digits_of_pieces = 0;  // the shortest exact text, because pieces may be small beside the whole
constexpr int digits_of_sums = 7;

void write_pieces(text::JsonStream& json, const std::vector<StagedPiece>& pieces) {
  json.array_of(pieces, [&](const StagedPiece& piece) {
    json.object([&] {
      json.key("ids"), json.array_of(piece.ids);
      json.key("vertices"), json.array_of(piece.vertices, [&](const Place& p) { json.numbers(p, digits_of_pieces); });
      json.key("edges"),
          json.array_of(piece.edges, [&](const auto& edge) { json.array_of(edge, [&](Index v) { json.integer(v); }); });
      json.key("facets"), json.array_of(piece.facets, [&](const Indices& facet) { json.array_of(facet); });
    });
  });
}

void write_pair(text::JsonStream& json, Index a, Index b) {
  json.key("pieces"), json.array([&] { json.integer(a), json.integer(b); });
}

void write_way(text::JsonStream& json, const StagedUnionWay& way) {
  json.object([&] {
    json.key("translation"), json.numbers(way.translation, digits_of_pieces);
    json.key("clearance"), json.boolean(way.clearance);
    json.key("contacts"), json.array_of(way.touching, [&](const StagedTouch& touch) {
      json.object([&] {
        write_pair(json, touch.a, touch.b);
        json.key("direction"), json.numbers(touch.direction, digits_of_pieces);
        json.key("kind"), json.string(name(touch.contact.kind));
        json.key("a"), json.array_of(touch.contact.a);
        json.key("b"), json.array_of(touch.contact.b);
      });
    });
  });
}

void write_sum(text::JsonStream& json, const PieceSum& sum) {
  json.object([&] {
    write_pair(json, sum.a, sum.b);
    json.key("inside"), json.boolean(sum.inside);
    json.key("distance"), json.number(sum.distance, digits_of_sums);
    json.key("distance_squared"), json.exact(sum.squared);
    json.key("touches"), json.array_of(sum.touches);
    json.key("vertices"), json.array_of(sum.vertices, [&](const Place& p) { json.numbers(p, digits_of_sums); });
    json.key("facets"), json.array_of(sum.facets, [&](const Indices& facet) { json.array_of(facet); });
    json.key("through"),
        json.array_of(sum.through, [&](const auto& pair) { json.array_of(pair, [&](Index i) { json.integer(i); }); });
  });
}

}  // namespace

std::string to_json(const Stages& stages) {
  text::JsonStream json;
  json.object([&] {
    write_head(json, stages);
    const double largest = std::max(largest_coordinate(stages.a), largest_coordinate(stages.b));
    json.key("a"), write_body(json, stages.a, true, largest);
    json.key("b"), write_body(json, stages.b, false, largest);
    json.key("contact"), write_contact(json, stages.contact);
    json.key("charts"), json.array_of(stages.charts, [&](const StagedChart& chart) { write_chart(json, chart); });
    json.key("pairs"), json.array([&] {
      for (Index i = 0; i < stages.pairs.size(); ++i)
        write_pair(json, stages.pairs[i], stages.winner && stages.winner->pair == i);
    });
    json.key("cutting");
    if (stages.cutting) write_cutting(json, *stages.cutting);
    else json.null();
    json.key("winner");
    if (stages.winner) write_winner(json, *stages.winner);
    else json.null();
    json.key("sum"), write_sum(json, stages.sum);
    const auto coincide = [&](const StagedCoincidence& c) { write_coincidence(json, c); };
    json.key("coincidences"), json.array_of(stages.coincidences, coincide);
    if (!stages.cores.empty()) json.key("cores"), json.array_of(stages.cores, coincide);
    json.key("decided"), json.array_of(stages.decided, [&](const StagedDecision& d) { write_decision(json, d); });
    json.key("counts"), write_counts(json, stages.counters);
    json.key("bounds"),
        json.array_of(stages.bounds, [&](const StagedBound& bound) { write_bound(json, bound, stages); });
    if (!stages.seconds.empty())
      json.key("seconds"), json.object([&] {
        for (const auto& [stage, seconds] : stages.seconds) json.key(stage), json.number(seconds, places_digits);
      });
    json.key("left_out"), json.array_of(stages.left_out, [&](const std::string& sentence) { json.string(sentence); });
  });
  return json.take();
}

std::string to_json(const UnionStages& stages) {
  text::JsonStream json;
  json.object([&] {
    json.key("schema"), json.string("fathom/union_stages/1");
    json.key("id"), json.string(stages.id);
    json.key("status"), json.string(name(stages.status));
    json.key("scale"), json.object([&] {
      const Point& center = stages.scale.center;
      json.key("center"), json.array([&] { json.exact(center.x), json.exact(center.y), json.exact(center.z); });
      json.key("exponent"), json.integer(stages.scale.exponent);
    });
    json.key("a"), write_pieces(json, stages.a);
    json.key("b"), write_pieces(json, stages.b);
    json.key("ways"), json.array_of(stages.ways, [&](const StagedUnionWay& way) { write_way(json, way); });
    json.key("sums"), json.array_of(stages.sums, [&](const PieceSum& sum) { write_sum(json, sum); });
    json.key("left_out"), json.array_of(stages.left_out, [&](const std::string& sentence) { json.string(sentence); });
  });
  return json.take();
}

}  // namespace fathom::stages
