// SPDX-License-Identifier: GPL-3.0-or-later
// Every snippet compiles against the library that is installed; some are run, and show the wrong
// number again.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "reference/files/shape_names.hpp"
#include "tests/harness/snippet_cases.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {
namespace {

using namespace fathom::testing;

struct Ran {
  int code = -1;
  std::string said;
};

Ran run_shell(const std::string& command) {
  Ran ran;
  std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return ran;
  char buffer[4096];
  while (std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) ran.said.append(buffer, count);
  const int status = pclose(pipe);
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}

/// The header without which a library's snippet cannot be compiled here.
std::string header_of(const SubjectInfo& info) {
  if (info.library == "libccd") return "/usr/include/ccd/ccd.h";
  if (info.library == "fcl") return "/usr/include/fcl/fcl.h";
  if (info.library == "bullet") return "/usr/include/bullet/BulletCollision/NarrowPhaseCollision/btGjkEpa2.h";
  if (info.library == "ode") return "/usr/include/ode/ode.h";
  return "";
}

class Snippets : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "fathom-snippet-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
    // As the public headers are installed.
    const std::filesystem::path root = std::filesystem::path(FATHOM_TEST_DATA).parent_path().parent_path();
    std::filesystem::create_directory_symlink(root / "include/fathom", folder / "fathom");
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// The command of the snippet's own comment, with `more` options.
  Ran compile(const SubjectInfo& info, const std::string& text, const std::string& more) const {
    std::ofstream(folder / "case.cpp") << text;
    std::string command = "g++ -std=c++20 case.cpp -I.";
    if (!info.library.empty()) {
      const std::size_t begin = text.find("// compile: ") + 12;
      command = text.substr(begin, text.find('\n', begin) - begin);
    }
    return run_shell("cd " + folder.string() + " && " + command + " -Wall " + more);
  }
  std::filesystem::path folder;
};

TEST_F(Snippets, Compile) {
  const Case pair = real_case("real::fcl-545-unit");
  for (const SubjectInfo& info : subjects()) {
    if (!header_of(info).empty() && !std::filesystem::exists(header_of(info))) {
      std::printf("skipped %s: %s is not installed\n", info.name.c_str(), header_of(info).c_str());
      continue;
    }
    const Ran ran = compile(info, snippet(info, pair, claimed(pair, 1)), "-fsyntax-only");
    EXPECT_EQ(ran.code, 0) << info.name << '\n' << ran.said;
  }
}

TEST_F(Snippets, CompileForASubjectThatRounds) {
  SubjectInfo info = subject("", "mine");
  info.rounding = {{"vertices", mpq_class(1, 20)}};
  const Case pair = real_case("real::fcl-545-unit");
  Outcome outcome = claimed(pair, 1);
  outcome.reply->contacts = {{{0.5, 0.5, 0.5}, 1.0}, {{0.25, 0.5, 0.5}, {}}};
  const std::string text = snippet(info, pair, outcome);
  for (const char* line :
       {"const mpq_class radius_a(\"1/20\"), radius_b(\"1/20\");",
        "fathom::truth_about(rounded(a, radius_a), rounded(b, radius_b));", "truth.added_a = radius_a;"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
  const Ran ran = compile(info, text, "-fsyntax-only");
  EXPECT_EQ(ran.code, 0) << ran.said;
}

TEST_F(Snippets, CompileForShapes) {
  for (const char* name : {"capsule_hull", "tapered_capsule_box", "cylinder_capsule", "cone_cylinder", "frusta",
                           "ellipsoid_box", "sums", "rounded_boxes", "shapes_halfspace"}) {
    const Case pair = families::find_family(name)->make(1, 8);
    Outcome outcome;
    outcome.id = pair.id;
    Reply& reply = outcome.reply.emplace();
    reply.overlap = true;
    reply.depth = 1;
    reply.direction = Triple{0, 0, 1};
    outcome.judgement = judge(truth_about(files::shape_of(pair.a), files::shape_of(pair.b)), reply);
    outcome.verdict = outcome.judgement->verdict;
    const std::string text = snippet(subject("", "mine"), pair, outcome);
    EXPECT_NE(text.find("const fathom::Shape a = "), std::string::npos) << text;
    const Ran ran = compile(subject("", "mine"), text, "-fsyntax-only");
    EXPECT_EQ(ran.code, 0) << pair.id << '\n' << ran.said << text;
  }
}

struct Wrong {
  SubjectInfo info;
  const char* id;
  double depth;       ///< the claim
  const char* shown;  ///< what the program prints of it
};

class RunSnippets : public Snippets, public ::testing::WithParamInterface<Wrong> {};
INSTANTIATE_TEST_SUITE_P(
    Real, RunSnippets,
    ::testing::Values(Wrong{subject("libccd", "libccd-epa"), "real::libccd-25-binary64", 0, "overlap 1 depth 0 "},
                      Wrong{subject("bullet", "bullet64-epa"), "real::parry-epa3-2", 1.2, " depth 1.2"},
                      Wrong{subject("ode", "ode-collide", true), "real::fcl-545-unit", 1.03923, "depth 1.0392"}));

TEST_P(RunSnippets, ShowTheWrongNumberAgain) {
  const auto& [info, id, depth, shown] = GetParam();
  if (!std::filesystem::exists(header_of(info))) GTEST_SKIP() << header_of(info) << " is not installed";
  const Case pair = real_case(id);
  const Ran compiled = compile(info, snippet(info, pair, claimed(pair, depth)), "-o case");
  ASSERT_EQ(compiled.code, 0) << compiled.said;
  const Ran ran = run_shell((folder / "case").string());
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.said.find(shown), std::string::npos) << ran.said;
}

}  // namespace
}  // namespace fathom::harness
