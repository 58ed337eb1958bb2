// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the words behind `fathom golden` into a request, into help, or into a sentence on what is
// wrong with them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/args/given.hpp"
#include "cli/io/output.hpp"
#include "fathom/depth.hpp"
#include "verify/golden/export/export.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::cli {

struct GoldenRequest {
  enum class What { generate, verify, exporting };
  What what = What::generate;
  golden::Level level = golden::Level::L0;
  std::uint64_t seed = 1;
  std::string folder;
  unsigned jobs = 0;                ///< 0: as many as there are cores
  bool is_part = false;             ///< generate: only every `parts`-th shard
  std::size_t part = 1, parts = 1;  ///< 1 <= part <= parts
  std::vector<Method> methods;      ///< verify: compute every record again by these too
  bool state = false;               ///< verify: write the page that says so
  golden::ExportRequest exported;   ///< export: which records, and how; `folder` may be a file of cases
  std::string certificates;         ///< export: the file for them, or ""
};

/// Like Arguments of the other commands.
struct GoldenArguments {
  std::optional<GoldenRequest> request;
  std::string text;
  ExitCode code = fine;
};

/// "i/n" with 1 <= i <= n, or nullopt.
std::optional<std::pair<std::size_t, std::size_t>> typed_part(std::string_view text);

/// Never throws, whatever the user typed.
GoldenArguments parse_golden(const std::vector<std::string>& words);

}  // namespace fathom::cli
