// SPDX-License-Identifier: GPL-3.0-or-later
// Plans shards: families alternate, so that every file has cases of each and all files take about
// equally long.

#include "verify/golden/shards/plan.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "fathom/signed_depth.hpp"
#include "reference/shapes/core.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// The cases that a level adds to those of lower levels.
struct LevelShare {
  unsigned each;           ///< cases of each family
  unsigned most;           ///< the largest size except for a few cases
  unsigned one_in_larger;  ///< one case in this many is up to five times as large; 0 for none
};

/// The recipe parameters of a family.
struct Habit {
  Source source;
  std::string_view family;
  unsigned usual_size;
  bool sized = true;   ///< whether the size matters
  bool seeded = true;  ///< whether the seed matters
  bool contacts = false;
};

using Habits = std::vector<Habit>;

namespace {

constexpr std::array levels{Level::L0, Level::L1, Level::L2, Level::L3, Level::P0,
                            Level::P1, Level::U0, Level::C0, Level::F0};

/// Returns the levels up to this one in its chain.
std::vector<Level> chain_to(Level level) {
  std::vector<Level> chain;
  for (const Level other : levels)
    if (name_of(other).front() == name_of(level).front() && other <= level) chain.push_back(other);
  return chain;
}

// Makes about 250 records; in L3 about 3000, so that one folder can hold all files; in U0, whose
// certificates are long, about 75.
constexpr std::size_t recipes_in_a_shard(Level level) {
  return level == Level::L3 ? 1500 : level == Level::U0 ? 50 : 150;
}

constexpr unsigned least_size = 4;

constexpr LevelShare share_of(Level level) {
  switch (level) {
    case Level::L0: return {3, 12, 0};
    case Level::L1: return {55, 30, 0};
    case Level::L2: return {780, 40, 10};
    case Level::L3: return {45'000, 40, 10};
    case Level::P0: return {8, 8, 0};
    case Level::P1: return {80, 30, 0};
    case Level::U0: return {6, 6, 0};
    case Level::F0: return {16, 8, 0};
    case Level::C0: break;
  }
  return {4, 8, 0};
}

// The depths of nearly all facets of P nearly tie: the proof has to separate each from the nearest,
// and grows with the square of the size.
constexpr std::array<std::string_view, 5> costly{"crossed_patch", "crossed_ties", "crossed_shrinking_ties",
                                                 "crossed_vanishing_ties", "crossed_noisy_ties"};
constexpr unsigned most_if_costly = 60;

// Families for contacts: polytopes, and shapes with polytopes as cores. Each kind of contact,
// parallel and nearly so; ties; apart and touching; in doubles as engines use them, or exact.
constexpr std::array<std::string_view, 34> touching_families{"faces_parallel",
                                                             "faces_tilted_hair",
                                                             "faces_tilted_slightly",
                                                             "faces_tilted",
                                                             "contact_facet_vertex",
                                                             "contact_vertex_facet",
                                                             "contact_facet_edge",
                                                             "contact_edge_facet",
                                                             "contact_facet_facet",
                                                             "contact_edge_edge",
                                                             "touching_vertex_face",
                                                             "touching_edge_edge",
                                                             "touching_edge_face",
                                                             "touching_face_face",
                                                             "nearly_touching",
                                                             "exact_ties",
                                                             "near_ties",
                                                             "near_tie_boxes",
                                                             "boxes_aligned",
                                                             "boxes_posed",
                                                             "platonic_aligned",
                                                             "random_disjoint",
                                                             "polygon_polygon",
                                                             "spheres",
                                                             "capsules",
                                                             "sphere_capsule",
                                                             "capsule_box",
                                                             "capsule_hull",
                                                             "rounded_boxes",
                                                             "rounded_hulls",
                                                             "rounded_triangle_sphere",
                                                             "inverse_side_side",
                                                             "inverse_side_face",
                                                             "inverse_rounded_edges"};

// Families with a few very large cases, in L2.
constexpr std::array<std::string_view, 7> giants{"random_ball", "random_sphere", "prisms_posed",  "needles",
                                                 "plates",      "crossed_fans",  "crossed_prisms"};
constexpr std::array<unsigned, 2> giant_sizes{500, 1000};

constexpr std::uint64_t seeds_of_a_release = 1'000'000;

bool same_pieces(const Body& p, const Body& q) {
  return p.pieces && q.pieces ? *p.pieces == *q.pieces : p.pieces == q.pieces;
}
bool same_body(const Body& p, const Body& q) { return p.points == q.points && p.shape == q.shape && same_pieces(p, q); }
bool same_bodies(const Case& p, const Case& q) { return same_body(p.a, q.a) && same_body(p.b, q.b); }

Habit habit_of(Source source, const families::Family& family) {
  Habit habit{source, family.name, family.usual_size};
  const Case case_of_5 = family.make(1, 5);
  const auto differs = [&](std::uint64_t seed, unsigned size) {
    return !same_bodies(case_of_5, family.make(seed, size));
  };
  habit.seeded = differs(2, 5) || differs(3, 5);
  habit.sized = differs(1, 23) && differs(1, 12);
  return habit;
}

Habits habits(Level level) {
  constexpr std::array sources{Source::family, Source::shape_family, Source::union_family, Source::plane_family};
  const Kind kind = level < Level::P0    ? Kind::polytopes
                    : level < Level::U0  ? Kind::shapes
                    : level == Level::U0 ? Kind::unions
                                         : Kind::plane;
  Habits result;
  const auto add = [&](const families::Family& family) {
    result.push_back(habit_of(sources.at(static_cast<std::size_t>(family.kind())), family));
    result.back().contacts = level == Level::C0;
  };
  if (level == Level::C0) {
    for (const std::string_view name : touching_families) add(*families::find_family(name));
    return result;
  }
  for (const families::Family& family : families::families(kind))
    if (family.name != "catalogue") add(family);  // its entries are included by name
  return result;
}

/// Returns whether the family has a case `index`, counted through all levels up to this one.
/// Without a seed there is one case of each size, or one of the usual size.
bool has_case(const Habit& habit, const LevelShare& share, unsigned index) {
  if (habit.seeded) return true;
  return habit.sized ? least_size + index <= share.most : index == 0 && habit.usual_size <= share.most;
}

unsigned size_of(const LevelShare& share, std::uint64_t seed) {
  families::Random random(seed);
  const bool larger = share.one_in_larger != 0 && random.next() % share.one_in_larger == 0;
  const unsigned most = larger ? 5 * share.most : share.most;
  return static_cast<unsigned>(random.between(least_size, most));
}

/// Returns the recipe of case `index`, which must exist.
Recipe recipe(const Habit& habit, const LevelShare& share, std::uint64_t seed, unsigned index) {
  Recipe result{habit.source, std::string(habit.family), habit.usual_size, seed * seeds_of_a_release + index,
                habit.contacts};
  if (!habit.seeded) {
    result.seed = 0;  // independent of the seed of the release
    if (habit.sized) result.size = least_size + index;
  } else if (habit.sized) {
    result.size = size_of(share, result.seed);
    if (std::ranges::find(costly, result.name) != costly.end()) result.size = std::min(result.size, most_if_costly);
  }
  return result;
}

}  // namespace

/// The recipes that a level adds, in order: those with a name, then the cases of all families in
/// rounds, then the giants.
class Additions {
 public:
  Additions(Level level, std::uint64_t seed, std::shared_ptr<const Habits> families)
      : share_(share_of(level)), seed_(seed), families_(std::move(families)) {
    for (const Level below : chain_to(level))
      if (below != level) first_ += share_of(below).each;
    if (level == Level::L0) add_named();
    if (level == Level::P0) add_named_shapes();
    if (level == Level::U0) add_named_unions();
    if (level == Level::C0) add_named_contacts();
    starts_.push_back(head_.size());
    for (unsigned i = 0; i < share_.each; ++i) starts_.push_back(starts_.back() + cases_of(i));
    if (level == Level::L2) add_giants();
  }

  [[nodiscard]] std::size_t size() const { return starts_.back() + tail_.size(); }

  [[nodiscard]] std::vector<Recipe> part(std::size_t begin, std::size_t end) const {
    std::vector<Recipe> result;
    for (std::size_t i = begin; i < std::min(end, head_.size()); ++i) result.push_back(head_[i]);
    const auto after = std::upper_bound(starts_.begin(), starts_.end(), std::max(begin, head_.size()));
    for (auto start = after - 1; start + 1 != starts_.end() && *start < end; ++start)
      add_round(static_cast<unsigned>(start - starts_.begin()), begin, end, result);
    for (std::size_t i = std::max(begin, starts_.back()); i < end; ++i) result.push_back(tail_[i - starts_.back()]);
    return result;
  }

 private:
  void add_named() {
    for (const Case& real : real_cases()) head_.push_back({Source::real, real.id});
    for (const families::CatalogueEntry& entry : families::catalogue())
      head_.push_back({Source::catalogue, std::string(entry.name)});
  }
  void add_named_shapes() {
    for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue())
      head_.push_back({Source::shape_catalogue, entry.shapes.id});
  }
  void add_named_unions() {
    for (const families::UnionCatalogueEntry& entry : families::union_catalogue())
      head_.push_back({Source::union_catalogue, entry.pair.id});
  }
  /// Adds the catalogue of polytopes, and of that of shapes the pairs whose cores are polytopes or
  /// half-spaces.
  void add_named_contacts() {
    for (const families::CatalogueEntry& entry : families::catalogue())
      head_.push_back({Source::catalogue, std::string(entry.name), 0, 0, true});
    const auto flat_faced = [](const families::NamedBody& body) {
      const Shape shape = shapes::simplified(families::shape_of(body));
      return shapes::is_halfspace(shape) || shapes::polytope_points(shape, most_expanded_points);
    };
    for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue())
      if (flat_faced(entry.shapes.pair.a) && flat_faced(entry.shapes.pair.b))
        head_.push_back({Source::shape_catalogue, entry.shapes.id, 0, 0, true});
  }
  void add_giants() {
    for (const unsigned size : giant_sizes) {
      for (const std::string_view name : giants)
        tail_.push_back({Source::family, std::string(name), size, seed_ * seeds_of_a_release + first_ + share_.each});
    }
  }
  [[nodiscard]] std::size_t cases_of(unsigned round) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(*families_, [&](const Habit& habit) { return has_case(habit, share_, first_ + round); }));
  }
  /// Appends the cases of one round, one of each family, as far as their places are in [begin,
  /// end).
  void add_round(unsigned round, std::size_t begin, std::size_t end, std::vector<Recipe>& result) const {
    std::size_t place = starts_[round];
    for (const Habit& habit : *families_) {
      if (!has_case(habit, share_, first_ + round)) continue;
      if (place >= begin && place < end) result.push_back(recipe(habit, share_, seed_, first_ + round));
      ++place;
    }
  }

  LevelShare share_;
  std::uint64_t seed_;
  std::shared_ptr<const Habits> families_;
  unsigned first_ = 0;               // cases of each family in lower levels
  std::vector<Recipe> head_, tail_;  // before and after the rounds
  std::vector<std::size_t> starts_;  // the place of the first case of each round, and finally of the tail
};

namespace {

std::string shard_name(Level level, std::size_t number) {
  const std::string digits = std::to_string(number);
  return "golden-" + std::string(name_of(level)) + "-" + std::string(4 - std::min<std::size_t>(4, digits.size()), '0') +
         digits;
}

}  // namespace

std::string_view name_of(Level level) {
  constexpr std::array<std::string_view, levels.size()> names{"L0", "L1", "L2", "L3", "P0", "P1", "U0", "C0", "F0"};
  return names[static_cast<std::size_t>(level)];
}

std::optional<Level> find_level(std::string_view name) {
  const auto found = std::ranges::find(levels, name, [](Level level) { return name_of(level); });
  return found == levels.end() ? std::nullopt : std::optional(*found);
}

std::vector<Recipe> ShardPlan::recipes() const { return additions->part(begin, end); }

std::vector<ShardPlan> plan(Level level, std::uint64_t seed) {
  const auto families = std::make_shared<const Habits>(habits(level));
  std::vector<ShardPlan> shards;
  for (const Level part : chain_to(level)) {
    const auto additions = std::make_shared<const Additions>(part, seed, families);
    const std::size_t all = additions->size(), most = recipes_in_a_shard(part), count = (all + most - 1) / most;
    for (std::size_t i = 0; i < count; ++i)  // shards of one level differ by one recipe at most
      shards.push_back({shard_name(part, i), part, additions, all * i / count, all * (i + 1) / count});
  }
  return shards;
}

// ---- the order of records ----

std::string RecordOrder::expected() const {
  if (seen_ < awaited_.size()) return awaited_[seen_];
  return begun_ < recipes_->size() ? id_of((*recipes_)[begun_]) : "";
}

std::optional<std::string> RecordOrder::next(std::string_view id, const std::vector<std::string>& ids) {
  const std::string awaited = expected();
  if (awaited.empty()) return "the plan has no more records";
  if (id != awaited) return "expected the record " + awaited;
  if (seen_ == awaited_.size()) {
    awaited_ = ids;
    seen_ = 0;
    ++begun_;
  }
  ++seen_;
  return std::nullopt;
}

std::optional<std::string> RecordOrder::at_end() const {
  const std::string awaited = expected();
  return awaited.empty() ? std::nullopt : std::optional("the record " + awaited + " is missing");
}

}  // namespace fathom::golden
