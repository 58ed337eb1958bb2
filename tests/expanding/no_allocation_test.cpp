// SPDX-License-Identifier: GPL-3.0-or-later
// With memory that has grown, neither placing bodies on a narrow lattice nor the search allocates:
// operator new and GMP's allocation are counted.
#include <gmp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "reference/expanding/expander.hpp"
#include "verify/families/families.hpp"

namespace {

std::size_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* counted_again(void* memory, std::size_t, std::size_t size) {
  ++allocations;
  return std::realloc(memory, size);
}
void freed(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace fathom::expanding {
namespace {

struct Counts {
  std::size_t placing, search;
};

Counts allocations_of(kernels::Context& context, const Case& input, Workspace::Parts& parts) {
  const std::size_t before = allocations;
  if (!polytope::place_narrow(input.a.points, input.b.points, parts.placed)) return {0, 0};
  const std::size_t placed = allocations;
  const auto search = [&]<class Integer>(const polytope::PlacedPairIn<Integer>& pair) {
    polytope::DifferencesIn<Integer> differences = pair.differences();
    Expander expander(context, differences, parts.memory<Integer>(), 1000);
    if (expander.start()) expander.find_nearest();
    if (expander.start()) expander.find_origin();
  };
  polytope::with_pair(parts.placed, input.a.points, input.b.points, parts.scan, search);
  return {placed - before, allocations - placed};
}

TEST(Workspace, LetsNothingAllocateOnceItIsWarm) {
  mp_set_memory_functions(counted, counted_again, freed);
  kernels::Context context;
  Workspace workspace;
  const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const families::Family& family : families::families())
      for (const unsigned size : {8U, 40U}) all.push_back(family.make(1, size));
    return all;
  }();
  std::size_t cold = 0;
  for (const Case& input : cases) {
    const Counts counts = allocations_of(context, input, *workspace.parts);
    cold += counts.placing + counts.search;
  }
  EXPECT_GT(cold, 100U) << "allocations are counted";
  for (const Case& input : cases) {
    const Counts counts = allocations_of(context, input, *workspace.parts);
    EXPECT_EQ(counts.placing, 0U) << input.id;
    EXPECT_EQ(counts.search, 0U) << input.id;
  }
}

}  // namespace
}  // namespace fathom::expanding
