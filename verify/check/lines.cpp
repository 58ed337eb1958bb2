// SPDX-License-Identifier: Apache-2.0
#include "lines.hpp"

namespace fathom_check {

// One block. A pipe hands over what it has: a certificate is judged before its successor is
// written.
bool Lines::refill() {
  constexpr std::streamsize block = 1 << 16;
  if (input_ == nullptr || !input_->good()) return false;
  buffer_.resize(block);
  std::streamsize got = 0;
  if (input_->peek() != std::istream::traits_type::eof()) got = input_->readsome(buffer_.data(), block);
  if (got == 0 && input_->good() && input_->get(buffer_[0])) got = 1;
  block_ = std::string_view(buffer_.data(), static_cast<std::size_t>(got));
  return got > 0;
}

Lines::Kind Lines::advance() {
  joined_.clear();
  bool any = false, too_long = false, joined = false;
  while (!block_.empty() || refill()) {
    any = true;
    const std::size_t end = block_.find('\n');
    const std::string_view piece = block_.substr(0, end);
    too_long = too_long || joined_.size() + piece.size() > longest_;
    if (end != std::string_view::npos && !joined) {
      text_ = piece;
    } else if (!too_long) {
      joined_ += piece;
      joined = true;
    } else {
      joined = true;
    }
    block_.remove_prefix(end == std::string_view::npos ? block_.size() : end + 1);
    if (joined) text_ = joined_;
    if (end == std::string_view::npos) continue;
    ++number_;
    if (too_long) text_ = {};
    return kind_ = too_long ? Kind::too_long : Kind::whole;
  }
  ++number_;
  if (!any || too_long) text_ = {};
  return kind_ = !any ? Kind::none : too_long ? Kind::too_long : Kind::cut_off;
}

}  // namespace fathom_check
