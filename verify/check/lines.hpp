// SPDX-License-Identifier: Apache-2.0
// An input, line by line. Memory is bounded by the longest line that is allowed, and so is what is
// read ahead.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace fathom_check {

class Lines {
 public:
  enum class Kind { whole, cut_off, too_long, none };

  /// Reads from a stream, which must outlive this.
  explicit Lines(std::istream& input, std::size_t longest) : input_(&input), longest_(longest) {}
  /// Reads from a text, which must outlive this.
  Lines(std::string_view text, std::size_t longest) : block_(text), longest_(longest) {}

  /// Goes on to the next line. `cut_off`: the last one, without a line feed. `too_long`: its rest
  /// is skipped. `none`: the end.
  Kind advance();
  /// The line at hand, without its line feed; valid until the next call.
  [[nodiscard]] std::string_view text() const { return text_; }
  /// Its number, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] Kind kind() const { return kind_; }
  /// Whether the stream broke: a directory, a disk fault.
  [[nodiscard]] bool broken() const { return input_ != nullptr && input_->bad(); }

 private:
  bool refill();

  std::istream* input_ = nullptr;
  std::vector<char> buffer_;
  std::string_view block_;  ///< read, and not yet handed out
  std::string joined_;      ///< a line that spans blocks
  std::string_view text_;
  std::size_t longest_, number_ = 0;
  Kind kind_ = Kind::none;
};

}  // namespace fathom_check
