// SPDX-License-Identifier: GPL-3.0-or-later
// The running minimum against a twin that remembers all offers and sorts them when asked.

#include "kernels/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernels/context.hpp"
#include "kernels/id.hpp"
#include "kernels/messages.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

struct Plane {
  Vector normal;
  mpz_class height;
  friend std::ostream& operator<<(std::ostream& out, const Plane& p) {
    return out << '<' << p.normal << ", x> = " << p.height;
  }
};

/// Squared distance of a plane from O.
mpq_class squared_distance(const Plane& p) {
  mpq_class r(p.height * p.height, dot(p.normal, p.normal));
  r.canonicalize();
  return r;
}

mpq_class squared_distance(const NearestPlanes& nearest) {
  mpq_class r(nearest.numerator(), nearest.denominator());
  r.canonicalize();
  return r;
}

std::vector<Vector> directions_of(const NearestPlanes& nearest) {
  return {nearest.directions().begin(), nearest.directions().end()};
}

/// The twin: least distance, and the primitive normals at that distance, sorted, each once.
std::pair<mpq_class, std::vector<Vector>> naive(const std::vector<Plane>& planes) {
  std::pair<mpq_class, std::vector<Vector>> result;
  auto& [least, normals] = result;
  for (const Plane& p : planes) {
    if (p.height > 0 && (normals.empty() || squared_distance(p) < least)) {
      least = squared_distance(p);
      normals.assign(1, Vector{});
    }
  }
  normals.clear();
  for (const Plane& p : planes) {
    if (p.height > 0 && squared_distance(p) == least) normals.push_back(primitive(p.normal));
  }
  std::sort(normals.begin(), normals.end(), lexicographically_less);
  normals.erase(std::unique(normals.begin(), normals.end()), normals.end());
  return result;
}

void expect_as_naive(const std::vector<Plane>& planes) {
  NearestPlanes nearest;
  std::vector<Plane> so_far;
  for (const Plane& p : planes) {
    const bool among = nearest.offer(p.normal, p.height);
    so_far.push_back(p);
    const auto [least, normals] = naive(so_far);
    ASSERT_EQ(nearest.empty(), normals.empty());
    ASSERT_EQ(among, p.height > 0 && squared_distance(p) == least) << p;
    if (normals.empty()) continue;
    ASSERT_EQ(squared_distance(nearest), least) << p;
    ASSERT_EQ(directions_of(nearest), normals) << p;
  }
}

TEST(NearestPlanes, IsTheMinimumOfAllOffers) {
  for (const Size size : all_sizes) {
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] {
      std::vector<Plane> planes;
      const int count = *rc::gen::inRange(0, 12);
      for (int i = 0; i < count; ++i) planes.push_back({*directions(size), *integers(size)});
      expect_as_naive(planes);
    }));
  }
}

// The same distance in many directions: permuted components, multiples, and neighbours by one unit.
TEST(NearestPlanes, KeepsTiesOfLargeNumbers) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Size size = *rc::gen::element(Size::word, Size::long_);
    const Vector n = *directions(size);
    const mpz_class h = abs(*integers(size)) + 1;
    std::vector<Plane> planes{{n, h}};
    const int count = *rc::gen::inRange(1, 8);
    for (int i = 0; i < count; ++i) {
      const mpz_class s = *rc::gen::element(mpz_class(1), mpz_class(7), power_of_two(90));
      const Vector turned = *rc::gen::element(n, -n, Vector{n.y, n.z, n.x}, Vector{n.y, n.x, mpz_class(-n.z)});
      const int off = *rc::gen::element(0, 0, 0, 1, -1);
      planes.push_back({s * turned, mpz_class(s * h + off)});
    }
    expect_as_naive(planes);
  }));
}

TEST(NearestPlanes, IgnoresPlanesThroughOAndBeyond) {
  NearestPlanes nearest;
  EXPECT_FALSE(nearest.offer(Vector{1, 0, 0}, 0));
  EXPECT_FALSE(nearest.offer(Vector{1, 0, 0}, -1));
  EXPECT_TRUE(nearest.empty());
  EXPECT_TRUE(nearest.offer(Vector{0, 0, 5}, 10));
  EXPECT_FALSE(nearest.offer(Vector{0, 0, 1}, -2));
  EXPECT_FALSE(nearest.offer(Vector{1, 0, 0}, 0));
  EXPECT_EQ(squared_distance(nearest), 4);
}

TEST(NearestPlanes, ListsEachDirectionOnceAndInOrder) {
  NearestPlanes nearest;
  EXPECT_TRUE(nearest.offer(Vector{0, 0, 3}, 6));
  EXPECT_TRUE(nearest.offer(Vector{0, 0, 1}, 2));
  EXPECT_TRUE(nearest.offer(Vector{0, -2, 0}, 4));
  EXPECT_TRUE(nearest.offer(Vector{-1, 0, 0}, 2));
  EXPECT_TRUE(nearest.offer(Vector{4, 0, 0}, 8));
  EXPECT_TRUE(nearest.offer(Vector{0, 1, 0}, 2));
  EXPECT_EQ(directions_of(nearest), (std::vector<Vector>{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_FALSE(nearest.offer(Vector{3, 4, 0}, 11));
  EXPECT_EQ(nearest.directions().size(), 5U);
  EXPECT_TRUE(nearest.offer(Vector{3, 4, 0}, 9));
  EXPECT_EQ(directions_of(nearest), (std::vector<Vector>{{3, 4, 0}}));
}

using Apple = Id<struct AppleTag>;
using Pear = Id<struct PearTag>;
using Apples = IdVector<Apple, int>;

static_assert(sizeof(Apple) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<Apple>,
              "an id is as cheap as the number");
static_assert(!std::is_convertible_v<std::uint32_t, Apple> && !std::is_convertible_v<Apple, std::uint32_t>,
              "a number is no id");
static_assert(!std::is_constructible_v<Apple, Pear> && !std::is_assignable_v<Apple&, Pear>,
              "ids of two kinds do not mix");

template <class Left, class Right>
concept Comparable = requires(Left left, Right right) {
  left == right;
};
template <class Left, class Right>
concept Ordered = requires(Left left, Right right) {
  left < right;
};
static_assert(Comparable<Apple, Apple> && !Comparable<Apple, Pear> && !Comparable<Apple, int>);
static_assert(Ordered<Apple, Apple> && !Ordered<Apple, Pear> && !Ordered<Apple, int>);

template <class Vector, class Index>
concept Indexed = requires(Vector vector, Index index) {
  vector[index];
};
static_assert(Indexed<Apples, Apple> && Indexed<const Apples, Apple>);
static_assert(!Indexed<Apples, Pear> && !Indexed<Apples, std::size_t> && !Indexed<Apples, int>);

TEST(Id, NoneIsNoIdAndGreaterThanAll) {
  EXPECT_TRUE(Apple::none().is_none());
  EXPECT_FALSE(Apple().is_none());
  EXPECT_LT(Apple(UINT32_MAX - 1), Apple::none());
  EXPECT_EQ(Apple(3).next(), Apple(4));
}

TEST(Id, NumbersBecomeIdsInTheirOrder) {
  EXPECT_EQ(to_ids<Apple>({4, 0, 9}), (std::vector{Apple(4), Apple(0), Apple(9)}));
}

TEST(IdVector, FindsElementsByTheirIds) {
  Apples apples{5, 6, 7};
  std::vector<Apple> ids;
  for (const Apple i : apples.ids()) ids.push_back(i);
  EXPECT_EQ(ids, (std::vector<Apple>{Apple(0), Apple(1), Apple(2)}));
  apples[Apple(1)] = 8;
  EXPECT_EQ(apples, (std::vector<int>{5, 8, 7}));
}

}  // namespace
}  // namespace fathom::kernels

namespace {
std::atomic<std::thread::id> fed;  // if set, no other thread gets memory that it asks for gently
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  const std::thread::id only = fed;
  return only == std::thread::id() || only == std::this_thread::get_id() ? ::operator new(size) : nullptr;
}

namespace fathom::kernels {
namespace {

const Direction x(Vector{1, 0, 0}), y(Vector{0, 1, 0}), diagonal(Vector{1, 1, 0});

void ask(Context& context, int times) {
  const Perturbation perturbation;
  const PerturbedKernel kernel(perturbation, context.counters.predicates);
  for (int i = 0; i < times; ++i) std::ignore = kernel.side_of_arc(x, diagonal);
  std::ignore = kernel.unperturbed().side_of_arc(x, y);                        // zero
  std::ignore = kernel.side_of_arc(Direction(x.exact(), Role::node_of_a), y);  // decided by an infinitesimal
}

TEST(RunBoth, RunsBothAndSumsTheirCounts) {
  PredicateCounts counts[2];
  for (const bool worth_it : {false, true}) {
    Context context;
    std::thread::id first, second;
    run_both(
        worth_it, context,
        [&](Context& own) {
          first = std::this_thread::get_id();
          EXPECT_EQ(&own, &context);
          ask(own, 5);
        },
        [&](Context& own) {
          second = std::this_thread::get_id();
          EXPECT_EQ(&own != &context, worth_it);
          ask(own, 7);
        });
    EXPECT_EQ(first, std::this_thread::get_id());
    EXPECT_EQ(first != second, worth_it);
    counts[worth_it] = context.counters.predicates;
  }
  const auto id = static_cast<std::size_t>(Predicate::side_of_arc);
  for (const PredicateCounts& c : counts) {
    EXPECT_EQ(c[id].calls, 16U);
    EXPECT_EQ(c[id].zero, 4U);
    ASSERT_EQ(c[id].decided.size(), 1U);
    EXPECT_EQ(c[id].decided.begin()->second, 2U);
  }
}

TEST(RunBoth, AThreadWithoutMemoryLeavesItsWorkToTheCaller) {
  std::thread::id second;
  int calls = 0;
  fed = std::this_thread::get_id();
  Context context;
  run_both(
      true, context, [](Context&) {},
      [&](Context&) {
        second = std::this_thread::get_id();
        ++calls;
      });
  fed = std::thread::id();
  EXPECT_EQ(second, std::this_thread::get_id());
  EXPECT_EQ(calls, 1);
}

TEST(RunBoth, MayBeNested) {
  Context context;
  const auto once = [](Context& own) { ask(own, 1); };
  const auto both = [&](Context& own) { run_both(true, own, once, once); };
  run_both(true, context, both, both);
  EXPECT_EQ(context.counters.predicates[static_cast<std::size_t>(Predicate::side_of_arc)].calls, 12U);
}

TEST(RunBoth, PassesExceptionsOnWhenBothHaveEnded) {
  const auto thrown = [](bool worth_it, bool by_first, bool by_second) {
    bool ended = false;
    const auto work = [](bool throws, const char* name) {
      if (throws) throw std::runtime_error(name);
    };
    std::string what;
    try {
      Context context;
      run_both(
          worth_it, context, [&](Context&) { work(by_first, "first"); },
          [&](Context&) {
            ended = true;
            work(by_second, "second");
          });
    } catch (const std::runtime_error& e) {
      what = e.what();
    }
    EXPECT_TRUE(ended || (!worth_it && by_first));
    return what;
  };
  for (const bool worth_it : {false, true}) {
    EXPECT_EQ(thrown(worth_it, false, false), "");
    EXPECT_EQ(thrown(worth_it, true, false), "first");
    EXPECT_EQ(thrown(worth_it, false, true), "second");
    EXPECT_EQ(thrown(worth_it, true, true), "first");
  }
}

TEST(NearMisses, OneSlipForThreeLetters) {
  for (const char* text : {"depht", "dept", "Depth", "depths", "xepth"}) EXPECT_TRUE(is_near(text, "depth")) << text;
  for (const char* text : {"", "death_", "dpeht", "deep", "penetration_depth", "d"})
    EXPECT_FALSE(is_near(text, "depth")) << text;
  EXPECT_TRUE(is_near("driection_", "direction"));
  EXPECT_FALSE(is_near("c", "a"));
  EXPECT_EQ(slips("kitten", "sitting"), 3U);
}

}  // namespace
}  // namespace fathom::kernels
