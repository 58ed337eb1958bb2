// SPDX-License-Identifier: GPL-3.0-or-later
// Many threads, each case once; exceptions end the run where they should, and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <stdexcept>
#include <thread>

#include "verify/harness/examiner.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A plan over the cases "0", "1", ... whose subject passes everything.
class Runs : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr int count = 50;

  Runs() {
    plan_.jobs = GetParam();
    plan_.next = [this]() -> std::optional<Case> {
      if (next_ == count) return std::nullopt;
      const int i = next_++;
      return Case{std::to_string(i), {{{i, 0, 0}}}, {{{0, 0, 0}}}};
    };
    plan_.worker = [this]() -> Worker {
      ++workers_;
      return {[this](const Case& pair, long) { return examine(pair); }, [this] { ++finished_; }};
    };
    plan_.found = [this](const Case&, const Case& seen, const Outcome& outcome, bool known) {
      EXPECT_EQ(seen.id, outcome.id);
      ++found_[outcome.id + (outcome.variant.empty() ? "" : "~" + outcome.variant) + (known ? " known" : "")];
    };
    plan_.fault = [this](const Case& pair, const std::exception_ptr& error) {
      try {
        std::rethrow_exception(error);
      } catch (const Refused&) {
        ++faults_[pair.id];
      }
    };
    plan_.left_out = [this](const Case&, const std::string&) { ++left_out_; };
  }

  Outcome examine(const Case& pair) {
    std::this_thread::yield();
    if (refuse_ && std::stoi(pair.id) % 10 == 3) throw Refused("no");
    if (break_ && pair.id == "20") throw std::runtime_error("broken");
    Outcome outcome = outcome_for(pair);
    outcome.verdict = Verdict::pass;
    return outcome;
  }

  [[nodiscard]] bool each_once() const {
    return std::ranges::all_of(found_, [](const auto& entry) { return entry.second == 1; });
  }

  RunPlan plan_;
  int next_ = 0;
  std::atomic<unsigned> workers_ = 0, finished_ = 0;
  bool refuse_ = false, break_ = false;
  std::map<std::string, int> found_, faults_;
  int left_out_ = 0;
};

TEST_P(Runs, EachCaseOnce) {
  run(plan_);
  EXPECT_EQ(found_.size(), std::size_t{count});
  EXPECT_TRUE(each_once());
  EXPECT_EQ(workers_, GetParam());
  EXPECT_EQ(finished_, GetParam());
}

TEST_P(Runs, FaultsOfSingleCases) {
  refuse_ = true;
  run(plan_);
  EXPECT_EQ(found_.size(), std::size_t{count - 5});
  EXPECT_EQ(faults_.size(), 5U);
  EXPECT_TRUE(each_once());
}

TEST_P(Runs, OtherFaultsEndIt) {
  break_ = true;
  EXPECT_THROW(run(plan_), std::runtime_error);
  EXPECT_FALSE(found_.contains("20"));
  EXPECT_TRUE(each_once());
  if (GetParam() == 1) {
    EXPECT_EQ(next_, 21) << "no case is taken after it";
  }
}

TEST_P(Runs, SourcesAndExaminersMayFail) {
  plan_.worker = []() -> Worker { throw Refused("no subject"); };
  EXPECT_THROW(run(plan_), Refused);
  EXPECT_TRUE(found_.empty());
}

TEST_P(Runs, VariantsAndWhatIsKnown) {
  plan_.variants = {"swap", "permute"};
  Outcome before = outcome_for({"7", {{{7, 0, 0}}}, {{{0, 0, 0}}}});
  before.verdict = Verdict::pass;
  plan_.known = [&](const std::string& id, const std::string& variant, const std::string& digest) {
    return id == "7" && variant.empty() && digest == before.digest ? &before : nullptr;
  };
  run(plan_);
  EXPECT_EQ(found_.size(), std::size_t{2 * count});
  EXPECT_EQ(left_out_, count) << "single points have no other order";
  EXPECT_TRUE(each_once());
  EXPECT_TRUE(found_.contains("7 known"));
  EXPECT_TRUE(found_.contains("7~swap"));
}

INSTANTIATE_TEST_SUITE_P(Jobs, Runs, testing::Values(1U, 2U, 7U));

}  // namespace
}  // namespace fathom::harness
