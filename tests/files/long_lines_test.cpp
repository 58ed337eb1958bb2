// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and cases beyond the limit of 256 MiB are refused and passed over; an input whose line has
// no end is given up.
#include <gtest/gtest.h>

#include <istream>
#include <limits>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/file_io.hpp"

namespace fathom::files {
namespace {

/// Texts, each a number of times, from little memory.
class Generated : public std::streambuf {
 public:
  struct Piece {
    std::string text;
    std::size_t times = 1;
  };
  explicit Generated(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

 private:
  int_type underflow() override {
    while (at_ < pieces_.size() && (pieces_[at_].times == 0 || pieces_[at_].text.empty())) ++at_;
    if (at_ == pieces_.size()) return traits_type::eof();
    std::string& text = pieces_[at_].text;
    --pieces_[at_].times;
    setg(text.data(), text.data(), text.data() + text.size());
    return traits_type::to_int_type(text[0]);
  }

  std::vector<Piece> pieces_;
  std::size_t at_ = 0;
};

const std::string good = R"({"id":"good","a":{"vertices":[[0,0,0]]},"b":{"vertices":[[0,0,0]]}})";

/// Of each case its id, or the sentence on what is wrong.
std::vector<std::string> outline(Generated& buffer) {
  std::istream input(&buffer);
  CaseStream stream(input, "c");
  std::vector<std::string> result;
  while (const std::optional<CaseItem> item = stream.next())
    result.push_back(item->ok() ? item->id : item->error().what());
  return result;
}

using Outline = std::vector<std::string>;

constexpr std::size_t block = std::size_t{1} << 16;

TEST(LongLines, ALineMayBeAsLongAsTheLimitAndNoLonger) {
  const Generated::Piece blanks{std::string(block, ' '), longest_line / block - 1};
  Generated most({{good}, blanks, {std::string(block - good.size(), ' ')}, {"\n" + good}});
  EXPECT_EQ(outline(most), (Outline{"good", "good"}));
  Generated more({{good}, blanks, {std::string(block - good.size() + 1, ' ')}, {"\n" + good}});
  EXPECT_EQ(outline(more), (Outline{"c:1: expected a case of at most 256 MiB, found a longer one", "good"}));
}

TEST(LongLines, ACaseOfManyLinesHasTheSameLimit) {
  const Generated::Piece line{" \"x\": [\"" + std::string(block, 'x') + "\"],\n", longest_line / block};
  Generated buffer({{"\n\n{\n"}, line, {good.substr(1) + "\n" + good}});
  EXPECT_EQ(outline(buffer), (Outline{"c:3: expected a case of at most 256 MiB, found a longer one", "good"}));
}

TEST(LongLines, OneWithoutAnEnd) {
  Generated buffer({{std::string(block, '\0'), std::numeric_limits<std::size_t>::max()}});
  EXPECT_EQ(outline(buffer), Outline{"c:1: expected a case of at most 256 MiB, found one without an end"});
}

}  // namespace
}  // namespace fathom::files
