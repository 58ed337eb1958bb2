// SPDX-License-Identifier: GPL-3.0-or-later
// The part of union_stages.hpp that writes JSON.
#include "reference/text/json.hpp"
#include "view/stages/union_stages.hpp"

namespace fathom::stages {
namespace {

constexpr int digits = 0;  // the shortest text: pieces may be small beside the whole
constexpr int digits_of_sums = 7;

void write_pieces(text::JsonStream& json, const std::vector<StagedPiece>& pieces) {
  json.array_of(pieces, [&](const StagedPiece& piece) {
    json.object([&] {
      json.key("ids"), json.array_of(piece.ids);
      json.key("vertices"), json.array_of(piece.vertices, [&](const Place& p) { json.numbers(p, digits); });
      json.key("edges"), json.array_of(piece.edges, [&](const auto& edge) { json.array_of(edge, [&](Index v) { json.integer(v); }); });
      json.key("facets"), json.array_of(piece.facets, [&](const Indices& facet) { json.array_of(facet); });
    });
  });
}

void write_pair(text::JsonStream& json, Index a, Index b) {
  json.key("pieces"), json.array([&] { json.integer(a), json.integer(b); });
}

void write_way(text::JsonStream& json, const StagedUnionWay& way) {
  json.object([&] {
    json.key("translation"), json.numbers(way.translation, digits);
    json.key("clearance"), json.boolean(way.clearance);
    json.key("contacts"), json.array_of(way.touching, [&](const StagedTouch& touch) {
      json.object([&] {
        write_pair(json, touch.a, touch.b);
        json.key("direction"), json.numbers(touch.direction, digits);
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
    json.key("through"), json.array_of(sum.through, [&](const auto& pair) { json.array_of(pair, [&](Index i) { json.integer(i); }); });
  });
}

}  // namespace

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
