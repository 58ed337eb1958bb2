// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of bodies of the plane: that of their prisms, with the points as they are in the
// plane, and the height of the prisms.                         [verify/check/FORMAT.md, section 16]
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reference/certificate/certificate.hpp"

namespace fathom::certificate {
namespace {

/// Goes through a text, word by word of a line.
class Cutter {
 public:
  explicit Cutter(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at(std::string_view word) const { return rest_.starts_with(word); }
  std::string_view line() {
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(line.size() + 1);
    return line;
  }
  /// Up to the last line, which is left.
  std::string_view all_but_last() {
    const std::string_view lines = rest_.substr(0, rest_.rfind('\n', rest_.size() - 2) + 1);
    rest_.remove_prefix(lines.size());
    return lines;
  }

 private:
  std::string_view rest_;
};

std::string_view without_last(std::string_view line) { return line.substr(0, line.rfind(' ')); }

std::size_t last_number(std::string_view line) {
  std::size_t number = 0;
  std::from_chars(line.data() + line.rfind(' ') + 1, line.data() + line.size(), number);
  return number;
}

}  // namespace

std::string in_plane(std::string_view text, const mpq_class& height, bool raised) {
  Cutter from(text);
  std::string result;
  const auto put = [&result](std::string_view line) { (result += line) += '\n'; };
  const bool unions = !from.at("fathom-certificate 1") && !from.at("fathom-certificate 2");
  put(from.line());
  if (from.at("id ")) put(from.line());
  put("plane " + height.get_str());
  std::vector<std::size_t> counts;  // of the lines that announce points
  while (!from.at("claim ")) {
    const std::string_view line = from.line();
    if (line.starts_with("halfspace_")) {
      put(std::string(without_last(without_last(line))).append(line.substr(line.rfind(' '))));
    } else if (line.starts_with("pieces_")) {
      counts.push_back(last_number(line));
      put(line);
    } else if (line.starts_with("radius_")) {
      put(line);
    } else {
      const std::size_t all = last_number(line), kept = raised && (unions || line[0] == 'b') ? all / 2 : all;
      counts.push_back(kept);
      put(std::string(without_last(line)) + ' ' + std::to_string(kept));
      for (std::size_t k = 0; k < all; ++k) {
        const std::string_view point = from.line();
        if (k < kept) put(without_last(point));
      }
    }
  }
  result += from.all_but_last();
  std::string_view end = from.line();
  result += "end";
  for (const std::size_t count : counts) result += ' ' + std::to_string(count);
  end.remove_prefix(end.find(' '));
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::size_t next = end.find(' ', 1);
    end.remove_prefix(next == std::string_view::npos ? end.size() : next);
  }
  put(end);
  return result;
}

}  // namespace fathom::certificate
