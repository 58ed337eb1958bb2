// SPDX-License-Identifier: GPL-3.0-or-later
// Words in messages: untrusted bytes of users made printable, misspelt words found, things counted;
// and the sentences on laws that a value breaks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fathom::kernels {

/// As many bytes of a text of users are shown in a message.
inline constexpr std::size_t readable = 40;

/// A letter of ASCII in lower case; any other byte as it is.
constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Returns `text` in single quotes for a message: cut to a readable length, bytes outside printable
/// ASCII as \xNN; "nothing" if it is empty.
std::string shown(std::string_view text);

/// "1 way", "2 ways".
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

/// Returns `text` with the bytes outside printable ASCII as \xNN, cut after `limit` bytes.
std::string printable(std::string_view text, std::size_t limit);

/// The edit distance of two words: letters missing, inserted or wrong, or two neighbours swapped.
/// Case does not matter.
std::size_t slips(std::string_view s, std::string_view t);

/// Whether `text` is probably the word: its edit distance is at most a third of the word's length.
bool is_near(std::string_view text, std::string_view word);

/// For each known field that is missing, names the first unknown field near it: "the field 'depht'
/// is not read: is 'depth' meant?". Several are joined by "; ". Empty if there is none.
std::string near_misses(std::span<const std::string> there, std::span<const std::string_view> known);

/// What `validate` found: empty when every law holds, else one sentence per broken law.
struct Report {
  std::vector<std::string> faults;

  [[nodiscard]] bool ok() const { return faults.empty(); }
  /// Records `fault` unless `holds`. Returns `holds`.
  bool expect(bool holds, std::string fault) {
    if (!holds) faults.push_back(std::move(fault));
    return holds;
  }
};

/// Throws std::logic_error with the first fault, if there is one.
inline void insist(const Report& report) {
  if (!report.ok()) throw std::logic_error("broken law: " + report.faults.front());
}

}  // namespace fathom::kernels
