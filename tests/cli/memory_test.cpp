// SPDX-License-Identifier: GPL-3.0-or-later
// Where memory ends under GMP: its number is whole, the next operator new throws, and once all is
// given back everything works again.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <new>
#include <utility>
#include <vector>

#include "cli/io/process.hpp"

namespace fathom::cli {
namespace {

std::size_t address_space_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * 4096;
}

void allow(std::size_t more) {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = more == 0 ? limit.rlim_max : address_space_in_use() + more;
  ::setrlimit(RLIMIT_AS, &limit);
}

/// All of the memory, until it goes.
class Hog {
 public:
  Hog() {
    allow(std::size_t{1} << 20);
    for (std::size_t size = std::size_t{1} << 24; size >= sizeof(Block); size /= 2)
      while (auto* const block = static_cast<Block*>(std::malloc(size))) last_ = new (block) Block{last_};
  }
  ~Hog() {
    while (last_) std::free(std::exchange(last_, last_->before));
    allow(0);
  }

 private:
  struct Block {
    Block* before;
  };
  Block* last_ = nullptr;
};

bool operator_new_throws() {
  try {
    ::operator delete(::operator new(1));
  } catch (const std::bad_alloc&) {
    return true;
  }
  return false;
}

TEST(Memory, NumbersAreServedFromTheReserveAndThenOperatorNewThrows) {
  guard_memory();
  const mpz_class wanted = (mpz_class(1) << 100'000) + 1;
  for (int round = 0; round < 3; ++round) {  // the reserve starts anew
    std::vector<mpz_class> numbers(500);     // of 12,504 bytes: 6 MB
    bool before = false, after = false;
    {
      const Hog hog;
      for (mpz_class& number : numbers) {
        number = 1;
        number <<= 100'000;
        number += 1;
      }
      before = operator_new_throws();
    }
    after = operator_new_throws();
    EXPECT_TRUE(before && !after) << round;
    for (const mpz_class& number : numbers) ASSERT_EQ(number, wanted);
  }
}

TEST(MemoryDeathTest, WhereTheReserveEndsTheProcessDoesToo) {
  const auto exhaust = [] {
    guard_memory();
    const Hog hog;
    std::exit((mpz_class(1) << 1'000'000'000) == 0 ? 1 : 0);
  };
  EXPECT_EXIT(exhaust(), testing::ExitedWithCode(3), "^fathom: out of memory\n$");
}

void run_out() { throw std::bad_alloc(); }
void run_out_quietly() noexcept { run_out(); }

TEST(MemoryDeathTest, WhereNoExceptionCanLeaveTheProcessEnds) {
  const auto out = [] {
    guard_memory();
    run_out_quietly();
  };
  EXPECT_EXIT(out(), testing::ExitedWithCode(3), "^fathom: out of memory\n$");
}

}  // namespace
}  // namespace fathom::cli
