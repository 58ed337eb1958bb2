// SPDX-License-Identifier: GPL-3.0-or-later
// Families of shapes: the same on every machine, and in doubles where they say so.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "fathom/signed_depth.hpp"
#include "verify/families/families.hpp"

namespace fathom::families {
namespace {

bool is_inverse(std::string_view name) { return name.starts_with("inverse_"); }

void each_number(const NamedBody& body, const std::function<void(const mpq_class&)>& use) {
  const auto point = [&use](const Point& p) {
    for (const mpq_class* x : {&p.x, &p.y, &p.z}) use(*x);
  };
  for (const auto& [name, values] : body.fields.numbers)
    for (const mpq_class& value : values) use(value);
  for (const Point& p : body.fields.vertices) point(p);
  for (const NamedBody& term : body.terms) each_number(term, use);
  for (const mpq_class* x : {&body.turn.w, &body.turn.x, &body.turn.y, &body.turn.z}) use(*x);
  point(body.place);
}

/// FNV-1a of all names and numbers as text.
std::uint64_t hash(const ShapeCase& shapes) {
  std::uint64_t value = 0xcbf29ce484222325U;
  const auto add = [&value](const std::string& text) {
    for (const char c : text + ' ') value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  };
  for (const NamedBody* body : {&shapes.pair.a, &shapes.pair.b}) {
    add(body->shape);
    add(std::to_string(static_cast<int>(body->fields.axis)));
    for (const NamedBody& term : body->terms) add(term.shape);
    each_number(*body, [&add](const mpq_class& x) { add(x.get_str()); });
  }
  return value;
}

TEST(ShapeFamilies, PosedHullsDifferInTheirPosesAlone) {
  const Family& family = *find_family("hulls_posed");
  const NamedPair first = family.make_shapes(1, 7).pair, second = family.make_shapes(2, 7).pair;
  for (const auto body : {&NamedPair::a, &NamedPair::b}) {
    EXPECT_EQ((first.*body).shape, "hull");
    EXPECT_EQ((first.*body).fields.vertices, (second.*body).fields.vertices);
    EXPECT_FALSE((first.*body).turn == (second.*body).turn && (first.*body).place == (second.*body).place);
  }
  EXPECT_NE(first.a.fields.vertices, first.b.fields.vertices);
  EXPECT_NE(first.a.fields.vertices, family.make_shapes(1, 8).pair.a.fields.vertices);
}

TEST(ShapeFamilies, SameSeedSameCaseOtherSeedOtherCase) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    std::set<std::uint64_t> hashes;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, 5);
      EXPECT_EQ(shapes.id, std::string(family.name) + "-n5-s" + std::to_string(seed));
      EXPECT_EQ(hash(shapes), hash(family.make_shapes(seed, 5))) << shapes.id;
      hashes.insert(hash(shapes));
    }
    EXPECT_EQ(hashes.size(), 8U) << family.name;
  }
}

/// Published cases must stay what they are.
TEST(ShapeFamilies, CasesNeverChange) {
  std::uint64_t all = 0;
  for (const Family& family : fathom::families::families(Kind::shapes))
    all = all * 31 + hash(family.make_shapes(2, 10));
  EXPECT_EQ(all, 993028135343414840U) << "some family changed";
}

TEST(ShapeFamilies, HullsHaveTheirSize) {
  for (const unsigned size : {0U, 3U, 4U, 25U})
    EXPECT_EQ(find_family("capsule_hull")->make_shapes(1, size).pair.b.fields.vertices.size(), std::max(4U, size));
}

TEST(ShapeFamilies, NumbersAreBinary64UnlessConstructed) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    EXPECT_EQ(family.make_shapes(1, 8).pair.known.has_value(), is_inverse(family.name)) << family.name;
    if (is_inverse(family.name)) continue;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, 8);
      for (const NamedBody* body : {&shapes.pair.a, &shapes.pair.b})
        each_number(*body, [&shapes](const mpq_class& x) { EXPECT_EQ(mpq_class(x.get_d()), x) << shapes.id; });
    }
  }
}

/// How deep, as tests see it.
enum class Situation { apart, nearly, touching, shallow, deep };

std::optional<Situation> situation_of(const SignedDepth& depth) {
  if (depth.status() == Status::touching) return Situation::touching;
  const double low = depth.low_binary64(), high = depth.high_binary64();
  if (high < 0) return low > -0.0625 ? Situation::nearly : Situation::apart;
  if (low > 0) return high < 0.0625 ? Situation::shallow : Situation::deep;
  return std::nullopt;
}

TEST(ShapeFamilies, EverySituationOccurs) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    if (is_inverse(family.name)) continue;
    std::map<Situation, int> seen;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Case pair = family.make(seed, 8);
      const auto shape = [](const Body& body) { return body.shape ? *body.shape : hull(body.points); };
      if (const auto situation = situation_of(signed_depth(shape(pair.a), shape(pair.b)))) ++seen[*situation];
    }
    for (const Situation situation :
         {Situation::apart, Situation::nearly, Situation::touching, Situation::shallow, Situation::deep})
      EXPECT_GE(seen[situation], 1) << family.name << ", situation " << static_cast<int>(situation);
  }
}

}  // namespace
}  // namespace fathom::families
