// SPDX-License-Identifier: GPL-3.0-or-later
// Families take turns, so that every file has cases of each and all files take about equally long.
#include "verify/golden/shards/plan.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"
#include "verify/golden/release/real_cases.hpp"

namespace fathom::golden {
namespace {

using families::Family;

constexpr std::array levels{Level::L0, Level::L1, Level::L2};
constexpr std::size_t recipes_in_a_shard = 150;  // about 250 records
constexpr unsigned least_size = 4;

/// What a level adds to those below it.
struct Share {
  unsigned each;           ///< cases of each family
  unsigned most;           ///< the largest size except for a few cases
  unsigned one_in_larger;  ///< one case in this many is up to five times as large; 0 for none
};

constexpr Share share_of(Level level) {
  switch (level) {
    case Level::L0: return {3, 12, 0};
    case Level::L1: return {55, 30, 0};
    case Level::L2: break;
  }
  return {780, 40, 10};
}

// Nearly all facets of P nearly tie: the proof has to separate each from the nearest, and grows with the square of the size.
constexpr std::array<std::string_view, 4> costly{"crossed_patch", "crossed_ties", "crossed_shrinking_ties", "crossed_vanishing_ties"};
constexpr unsigned most_if_costly = 60;

// Families that the data does not draw on before its next version.
constexpr std::array<std::string_view, 1> not_yet{"crossed_noisy_ties"};

// A few very large cases, in L2.
constexpr std::array<std::string_view, 7> giants{"random_ball", "random_sphere", "prisms_posed",  "needles",
                                                 "plates",      "crossed_fans",  "crossed_prisms"};
constexpr std::array<unsigned, 2> giant_sizes{500, 1000};

constexpr std::uint64_t seeds_of_a_release = 1'000'000;

/// How a family fills its share.
struct Habit {
  const Family* family;
  bool sized = true;   ///< whether the size matters
  bool seeded = true;  ///< whether the seed matters
};

bool same_points(const Case& p, const Case& q) { return p.a.points == q.a.points && p.b.points == q.b.points; }

Habit habit_of(const Family& family) {
  Habit habit{&family};
  const Case case_of_5 = family.make(1, 5);
  const auto differs = [&](std::uint64_t seed, unsigned size) { return !same_points(case_of_5, family.make(seed, size)); };
  habit.seeded = differs(2, 5) || differs(3, 5);
  habit.sized = differs(1, 23) && differs(1, 12);
  return habit;
}

std::vector<Habit> habits() {
  std::vector<Habit> result;
  for (const Family& family : families::families()) {
    const bool by_name = family.name == "catalogue";  // its entries are all there by name
    if (!by_name && std::ranges::find(not_yet, family.name) == not_yet.end()) result.push_back(habit_of(family));
  }
  return result;
}

unsigned size_of(const Share& share, std::uint64_t seed) {
  families::Random random(seed);
  const bool larger = share.one_in_larger != 0 && random.next() % share.one_in_larger == 0;
  const unsigned most = larger ? 5 * share.most : share.most;
  return static_cast<unsigned>(random.between(least_size, most));
}

/// Returns case number `index` of a family, counted through all levels, or nullopt if its share is used up.
std::optional<Recipe> recipe(const Habit& habit, const Share& share, std::uint64_t seed, unsigned index) {
  Recipe result{Source::family, std::string(habit.family->name), habit.family->usual_size, seed * seeds_of_a_release + index};
  if (!habit.seeded) {
    // One case of each size, whatever the seed.
    result.seed = 0;
    if (habit.sized) result.size = least_size + index;
    if (result.size > share.most || (!habit.sized && index > 0)) return std::nullopt;
  } else if (habit.sized) {
    result.size = size_of(share, result.seed);
    if (std::ranges::find(costly, result.name) != costly.end()) result.size = std::min(result.size, most_if_costly);
  }
  return result;
}

/// What a level adds, in order.
std::vector<Recipe> additions(Level level, std::uint64_t seed, std::span<const Habit> families) {
  std::vector<Recipe> result;
  if (level == Level::L0) {
    for (const Case& real : real_cases()) result.push_back({Source::real, real.id});
    for (const families::CatalogueEntry& entry : families::catalogue()) result.push_back({Source::catalogue, std::string(entry.name)});
  }
  unsigned first = 0;
  for (const Level below : levels) {
    if (below == level) break;
    first += share_of(below).each;
  }
  const Share share = share_of(level);
  for (unsigned index = first; index < first + share.each; ++index) {
    for (const Habit& habit : families) {
      if (auto next = recipe(habit, share, seed, index)) result.push_back(*std::move(next));
    }
  }
  if (level == Level::L2) {
    for (const unsigned size : giant_sizes) {
      for (const std::string_view name : giants) {
        result.push_back({Source::family, std::string(name), size, seed * seeds_of_a_release + first + share.each});
      }
    }
  }
  return result;
}

std::string shard_name(Level level, std::size_t number) {
  const std::string digits = std::to_string(number);
  return "golden-" + std::string(name_of(level)) + "-" + std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits;
}

}  // namespace

std::string_view name_of(Level level) {
  constexpr std::array<std::string_view, levels.size()> names{"L0", "L1", "L2"};
  return names[static_cast<std::size_t>(level)];
}

std::optional<Level> find_level(std::string_view name) {
  const auto found = std::ranges::find(levels, name, [](Level level) { return name_of(level); });
  return found == levels.end() ? std::nullopt : std::optional(*found);
}

std::vector<ShardPlan> plan(Level level, std::uint64_t seed) {
  const std::vector<Habit> families = habits();
  std::vector<ShardPlan> shards;
  for (const Level part : levels) {
    std::vector<Recipe> recipes = additions(part, seed, families);
    const std::size_t count = (recipes.size() + recipes_in_a_shard - 1) / recipes_in_a_shard;
    for (std::size_t i = 0; i < count; ++i) {
      // Shards of one level differ by one recipe at most.
      const auto begin = recipes.begin() + static_cast<std::ptrdiff_t>(recipes.size() * i / count);
      const auto end = recipes.begin() + static_cast<std::ptrdiff_t>(recipes.size() * (i + 1) / count);
      shards.push_back({shard_name(part, i), part, {std::make_move_iterator(begin), std::make_move_iterator(end)}});
    }
    if (part == level) break;
  }
  return shards;
}

}  // namespace fathom::golden
