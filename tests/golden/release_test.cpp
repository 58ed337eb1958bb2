// SPDX-License-Identifier: GPL-3.0-or-later
// Law: the pages of a shard and of a release are read only in the one form in which they are
// written, field by field.

#include "verify/golden/release/release.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "verify/digest/sha256.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {
namespace {

constexpr std::uint64_t seed = UINT64_MAX;  // beyond what a JSON number may hold

Manifest manifest_of_plan(const ShardPlan& shard) {
  Manifest manifest{shard.name, shard.level, std::string(data_version), seed, shard.count(), 2 * shard.count(),
                    "1.5.4",    {}};
  for (const std::string_view suffix : suffixes_of(shard.level)) {
    const std::size_t i = manifest.files.size();
    manifest.files.push_back(
        {shard.name + std::string(suffix), {10 + i, std::string(64, 'a')}, {100 + i, std::string(64, 'b')}});
  }
  return manifest;
}

TEST(Dataset, ManifestsComeBack) {
  for (const Level level : {Level::L0, Level::P0}) {
    const ShardPlan shard = plan(level, seed).front();
    const Manifest manifest = manifest_of_plan(shard);
    EXPECT_EQ(manifest.files.size(), level == Level::L0 ? 3u : 2u);
    const std::string text = manifest_text(manifest);
    ASSERT_TRUE(parse_manifest(text));
    EXPECT_EQ(*parse_manifest(text), manifest);
    EXPECT_FALSE(not_of_plan(manifest, shard, seed));
  }
}

TEST(Dataset, ShardsOfShapesHaveNoCsv) {
  Manifest manifest = manifest_of_plan(plan(Level::P0, seed).front());
  manifest.files.push_back(manifest.files.back());
  EXPECT_FALSE(parse_manifest(manifest_text(manifest)));
  manifest = manifest_of_plan(plan(Level::L0, seed).front());
  manifest.files.resize(2);
  EXPECT_FALSE(parse_manifest(manifest_text(manifest)));
}

TEST(Dataset, ManifestsOfOtherPlansAreSeen) {
  const ShardPlan shard = plan(Level::L0, seed).front();
  const Manifest good = manifest_of_plan(shard);
  EXPECT_TRUE(not_of_plan(good, shard, seed - 1));
  EXPECT_TRUE(not_of_plan(good, plan(Level::L0, seed).back(), seed));
  const auto refused = [&](auto change) {
    Manifest wrong = good;
    change(wrong);
    return not_of_plan(wrong, shard, seed).has_value();
  };
  EXPECT_TRUE(refused([](Manifest& m) { m.version = "0.9.0"; }));
  EXPECT_TRUE(refused([](Manifest& m) { m.name += "0"; }));
  EXPECT_TRUE(refused([](Manifest& m) { m.level = Level::L1; }));
  EXPECT_TRUE(refused([](Manifest& m) { ++m.recipes; }));
  EXPECT_TRUE(refused([](Manifest& m) { std::swap(m.files[0], m.files[1]); }));
  EXPECT_TRUE(refused([](Manifest& m) { m.files[2].name = "../golden"; }));
}

/// Every way to leave out one line, or to change one character, is refused.
template <class Parse>
void expect_one_form(const std::string& text, Parse parse) {
  ASSERT_TRUE(parse(text));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string wrong = text;
    wrong[i] = wrong[i] == ' ' ? '\t' : ' ';
    EXPECT_FALSE(parse(wrong) && *parse(wrong) == *parse(text)) << "character " << i;
  }
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
    std::string wrong = text;
    wrong.erase(begin, text.find('\n', begin) + 1 - begin);
    EXPECT_FALSE(parse(wrong)) << wrong;
  }
  EXPECT_FALSE(parse(text + '\n'));
  EXPECT_FALSE(parse(text + text));
  EXPECT_FALSE(parse(""));
  EXPECT_FALSE(parse("[]"));
}

TEST(Dataset, OneForm) {
  const std::vector<ShardPlan> shards = plan(Level::L0, seed);
  expect_one_form(manifest_text(manifest_of_plan(shards[0])), parse_manifest);
  Dataset dataset{Level::L0, std::string(data_version), seed, {}};
  dataset.shards.push_back(manifest_of_plan(shards[0]));
  const std::string text = dataset_text(dataset);
  const auto parse_again = [](std::string_view page) {
    const std::optional<Dataset> found = parse_dataset(page);
    return found ? std::optional(dataset_text(*found)) : std::nullopt;
  };
  expect_one_form(text, parse_again);
  ASSERT_TRUE(parse_dataset(text));
  EXPECT_EQ(parse_dataset(text)->seed, seed);
  EXPECT_EQ(records_in(*parse_dataset(text)), 2 * shards[0].count());
}

// ---- sums ----

TEST(Sums, OneForm) {
  const std::vector<Sum> sums = {{"a.json", digest::digest_of("a").sha256}, {"b.zst", digest::digest_of("b").sha256}};
  const std::string text = sums_text({sums[1], sums[0]});
  EXPECT_EQ(text, sums[0].sha256 + "  a.json\n" + sums[1].sha256 + "  b.zst\n");
  ASSERT_TRUE(parse_sums(text));
  EXPECT_EQ(*parse_sums(text), sums);
  const std::string line = sums[0].sha256 + "  ";
  for (const std::string& wrong :
       {text.substr(1), text.substr(0, text.size() - 1), text + '\n', text + text,
        sums[1].sha256 + "  b.zst\n" + line + "a.json\n", line + "\n", line + ".hidden\n", line + "../up\n",
        line + "a b\n", line + "a\r\n", sums[0].sha256 + " *a\n", std::string(64, 'A') + "  a\n",
        std::string(64, 'g') + "  a\n", std::string("short  a\n"), "\n" + text})
    EXPECT_FALSE(parse_sums(wrong)) << wrong;
}

// Law: what was written comes back line by line, whatever the sizes; and a file that is anything
// else than one whole frame is refused.

namespace fs = std::filesystem;

class ZstdFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("zstd_file_test_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::vector<std::string>& pieces) {
    fs::remove(folder_ / "file");
    ZstdWriter writer(folder_, "file");
    for (const std::string& piece : pieces) writer.write(piece);
    writer.finish();
    of_file_ = writer.of_file();
    of_content_ = writer.of_content();
    EXPECT_FALSE(fs::exists(folder_ / "file")) << "no name before it is whole";
    writer.commit();
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> found;
    ZstdReader reader(folder_ / "file");
    while (const auto line = reader.line()) found.emplace_back(*line);
    EXPECT_EQ(reader.number(), found.size());
    EXPECT_EQ(reader.of_content(), of_content_);
    return found;
  }
  std::string bytes() const {
    std::ifstream file(folder_ / "file", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string fault_of(const std::string& content) const {
    std::ofstream(folder_ / "file", std::ios::binary) << content;
    try {
      ZstdReader reader(folder_ / "file");
      while (reader.line()) continue;
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  digest::Digest of_file_, of_content_;
};

TEST_F(ZstdFile, LinesComeBack) {
  for (const std::size_t size : {0, 1, 100, 131071, 131072, 300000}) {
    const std::vector<std::string> expected = {"first", std::string(size, 'x'), "", "last"};
    write({expected[0] + '\n', expected[1] + '\n', "\nla", "st\n"});
    EXPECT_EQ(lines(), expected) << size;
    EXPECT_EQ(of_file_, digest::digest_of(bytes()));
    EXPECT_EQ(of_content_, digest::digest_of("first\n" + expected[1] + "\n\nlast\n"));
  }
  write({});
  EXPECT_TRUE(lines().empty());
}

TEST_F(ZstdFile, BytesDoNotDependOnThePieces) {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += std::to_string(i * 7919) + '\n';
  write({text});
  const std::string whole = bytes();
  std::vector<std::string> pieces;
  for (std::size_t i = 0; i < text.size(); i += 997) pieces.push_back(text.substr(i, 997));
  write(pieces);
  EXPECT_EQ(bytes(), whole);
}

TEST_F(ZstdFile, OnlyOneWholeFrame) {
  write({"some\n", "lines\n"});
  const std::string good = bytes();
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_EQ(fault_of(good.substr(0, length)), "the Zstandard frame is cut off") << length;
  EXPECT_EQ(fault_of(good + '\0'), "something follows the Zstandard frame");
  EXPECT_EQ(fault_of(good + good), "something follows the Zstandard frame");
  EXPECT_NE(fault_of("x" + good), "");
  std::size_t faults =
      0;  // some bits say how much memory a reader needs: another value there may still yield the content
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string wrong = good;
    wrong[i] = static_cast<char>(wrong[i] ^ 1);
    const bool refused = !fault_of(wrong).empty();
    if (!refused) {
      EXPECT_EQ(lines(), (std::vector<std::string>{"some", "lines"})) << "byte " << i;
    }
    faults += refused;
  }
  EXPECT_GE(faults, good.size() - 1);
  EXPECT_EQ(fault_of(good), "");
  write({"no line feed"});
  EXPECT_EQ(fault_of(bytes()), "the last line has no line feed");
}

TEST_F(ZstdFile, NothingStaysOfAFileThatIsNotFinished) {
  {
    ZstdWriter writer(folder_, "file");
    writer.write("lost\n");
    EXPECT_THROW(ZstdWriter(folder_, "file"), FileError) << "somebody is writing it";
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_THROW(ZstdWriter(folder_ / "nowhere", "file"), FileError);
  EXPECT_THROW(ZstdReader(folder_ / "file"), FileError);
  EXPECT_THROW(ZstdReader{folder_}, FileError) << "a folder";
}

}  // namespace
}  // namespace fathom::golden
