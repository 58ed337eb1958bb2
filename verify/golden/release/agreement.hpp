// SPDX-License-Identifier: GPL-3.0-or-later
// agreement.json: which methods have given every record of a release. The page is written after the release is complete, by who computed it
// again, and is no part of the data: SHA256SUMS does not list it, and it says itself which contents it is about.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"

namespace fathom::golden {

inline constexpr std::string_view agreement_name = "agreement.json";

struct Agreement {
  std::string content_sha256;   ///< of the page CONTENT_SHA256SUMS
  std::size_t records = 0;      ///< that were computed again
  std::vector<Method> methods;  ///< each of them gave every field of every record, beside the certificates; not empty
};

/// JSON, schemas/agreement.schema.json; ends with a line feed.
std::string agreement_text(const Agreement& agreement);

/// Returns nullopt unless `text` is, byte for byte, what agreement_text makes of it.
std::optional<Agreement> parse_agreement(std::string_view text);

}  // namespace fathom::golden
