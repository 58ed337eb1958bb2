// SPDX-License-Identifier: GPL-3.0-or-later
// Law: what was written comes back line by line, whatever the sizes; and a file that is anything
// else than one whole frame is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "verify/golden/io/files.hpp"

namespace fathom::golden {
namespace {

namespace fs = std::filesystem;

class ZstdFile : public testing::Test {
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
