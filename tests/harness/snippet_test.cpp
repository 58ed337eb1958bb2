// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in a snippet. That they compile, and show the wrong number again:
// snippet_heavy_test.cpp.
#include <gtest/gtest.h>

#include <limits>

#include "fathom/numbers.hpp"
#include "tests/harness/snippet_cases.hpp"
#include "verify/harness/shrink/reproducer.hpp"

namespace fathom::harness {
namespace {

using namespace fathom::testing;

bool holds(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Snippet, HoldsThePointsTheTruthAndTheClaim) {
  const Case pair = real_case("real::fcl-545-unit");
  const Outcome outcome = claimed(pair, 1.0392);
  for (const SubjectInfo& info : subjects()) {
    const std::string text = snippet(info, pair, outcome);
    EXPECT_TRUE(holds(text.substr(0, 300), "// real::fcl-545-unit: " + info.name)) << text;
    EXPECT_TRUE(holds(text, "// truth:   penetrating, depth^2 = ")) << text;
    EXPECT_TRUE(holds(text, "// claim:   overlap, depth 1.0392, direction (0, 0, 1)\n")) << text;
    EXPECT_TRUE(holds(text, "// verdict: " + std::string(name(outcome.verdict)) + ": ")) << text;
    for (const Body* body : {&pair.a, &pair.b})
      for (const Point& p : body->points) EXPECT_TRUE(holds(text, hex_text(round_binary64(p.x, Rounding::rn)))) << text;
    EXPECT_FALSE(holds(text, "@")) << text;
    EXPECT_EQ(holds(text, "std::vector<std::vector<int>> faces"), info.wants_faces);
  }
}

TEST(Snippet, TakesTheSettingsOfTheHello) {
  const Case pair = real_case("real::fcl-545-unit");
  const Outcome outcome = claimed(pair, 1);
  SubjectInfo info = subject("libccd", "libccd-epa");
  EXPECT_TRUE(holds(snippet(info, pair, outcome), "options.epa_tolerance = 0.0001;"));
  info.settings = {{"epa_tolerance", "1e-12"}, {"max_iterations", "500"}};
  const std::string text = snippet(info, pair, outcome);
  EXPECT_TRUE(holds(text, "options.epa_tolerance = 1e-12;"));
  EXPECT_TRUE(holds(text, "options.max_iterations = 500UL;"));
  EXPECT_TRUE(holds(text, "epa_tolerance = 1e-12, max_iterations = 500)"));
  EXPECT_TRUE(holds(snippet(subject("libccd", "libccd-mpr"), pair, outcome), "ccdMPRPenetration(&a"));
}

TEST(Snippet, IsNoPlaceForCodeOfTheSubject) {
  const Case real = real_case("real::fcl-545-unit");
  const Case pair{"id\n#include \"evil\"\\", real.a, real.b};
  SubjectInfo info = subject("libccd", "libccd\nint evil;");
  info.settings = {{"epa_tolerance", "0; evil()"}, {"key\nevil", "value\\"}};
  Outcome outcome = claimed(pair, 1);
  outcome.judgement->sentence = "two\nevil lines\\";
  const std::string text = snippet(info, pair, outcome);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    EXPECT_TRUE(!holds(line, "evil") || line.starts_with("//")) << line;
    EXPECT_FALSE(line.starts_with("//") && line.ends_with("\\")) << line;
    begin = end + 1;
  }
}

TEST(Snippet, OfACrashKnowsTheTruthAllTheSame) {
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome;
  outcome.verdict = Verdict::crash;
  outcome.detail = "killed by signal 11";
  const std::string text = snippet(subject("", "home-made"), pair, outcome);
  EXPECT_TRUE(holds(text, "depth = 0.6\n")) << text;
  EXPECT_TRUE(holds(text, "// claim:   none\n")) << text;
  EXPECT_TRUE(holds(text, "// verdict: crash: killed by signal 11\n")) << text;
  EXPECT_TRUE(holds(text, "No answer was recorded")) << text;
}

TEST(Snippet, OfAVariantCallsTwice) {
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome = claimed(pair, 1);
  outcome.variant = "swap";
  outcome.verdict = Verdict::not_invariant;
  const std::string text = snippet(subject("ode", "ode-collide", true), pair, outcome);
  EXPECT_TRUE(holds(text, "answer(\"A and B\", a, b);")) << text;
  EXPECT_TRUE(holds(text, "answer(\"the variant swap\", other_a, other_b);")) << text;
}

TEST(Snippet, WritesNumbersThatAreNoNumbers) {
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome = claimed(pair, std::numeric_limits<double>::quiet_NaN());
  outcome.reply->direction = Triple{-std::numeric_limits<double>::infinity(), 0, 0};
  const std::string text = snippet(subject("", "home-made"), pair, outcome);
  EXPECT_TRUE(holds(text, "reply.depth = NAN;")) << text;
  EXPECT_TRUE(holds(text, "{{-HUGE_VAL, 0x0p+0, 0x0p+0}}")) << text;
}

}  // namespace
}  // namespace fathom::harness
