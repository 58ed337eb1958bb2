// SPDX-License-Identifier: GPL-3.0-or-later
// The request of `fathom certify`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fathom/judge.hpp"

namespace fathom::cli {

struct CertifyRequest {
  std::string command_line;              ///< quoted for a shell
  std::string subject, adapter, replay;  ///< exactly one of these, or list_adapters, is set
  bool list_adapters = false;
  std::string claims;            ///< a file of published claims, which are judged instead of a subject; empty: none
  std::optional<unsigned> jobs;  ///< if not set, as many as there are processors
  double time_out = 10;          ///< seconds
  Tolerance tolerance;
  std::optional<mpq_class> fit;  ///< the size that each case is brought to
  std::vector<Method> methods;   ///< find every truth and judgement again by these
  std::string report;
  bool resume = false, overwrite = false;  ///< of the report that is there
  bool all_rows = false;                   ///< in the table
  std::string print_input;                 ///< the id of the case whose lines are printed, as the subject reads them; empty: none
  std::string harness;                     ///< the user's own program for --shrink; empty: none
  std::string metamorphic;                 ///< as typed: "all", or a list with commas
  std::vector<std::string> variants;       ///< the same, as a list
  std::string expect_fail, write_expect_fail, junit, html, certificates, shrink;  ///< paths; empty: not wanted
  std::optional<std::size_t> max_errors;
};

}  // namespace fathom::cli
