// SPDX-License-Identifier: GPL-3.0-or-later
// SHA256SUMS: a line "<64 digits>  <name>" for every other file of a flat folder, sorted by name, as `sha256sum -c` reads them. So is
// CONTENT_SHA256SUMS (dataset.hpp), of decompressed files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::golden {

inline constexpr std::string_view sums_name = "SHA256SUMS";

struct Sum {
  std::string name, sha256;
  friend bool operator==(const Sum&, const Sum&) = default;
};

/// The page. The order of `sums` does not matter.
std::string sums_text(std::vector<Sum> sums);

/// Returns nullopt unless `text` is what sums_text makes of it, and no name occurs twice.
std::optional<std::vector<Sum>> parse_sums(std::string_view text);

}  // namespace fathom::golden
