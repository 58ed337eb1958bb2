// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for of depth --along.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "fathom/point.hpp"

namespace fathom::cli {

struct AlongRequest {
  std::optional<Point> translation;  ///< set if the depth along a path is asked for: A is moved by parts of it, and by
                                     ///< all of it in the end
  std::uint32_t steps = 32;
};

// The request of `fathom cases`.

struct CasesRequest {
  enum class What { family, catalogue, list, from, from_fcl };
  What what = What::family;
  std::vector<std::string> families;  ///< as typed: names, or patterns of them; "all"
  bool shapes = false;  ///< of all families, or the catalogue, or the list: those of shapes, not of polytopes
  bool unions = false;  ///< likewise, those of unions of pieces
  std::uint64_t count = 1, seed = 1;  ///< the seeds are seed, seed + 1, ...
  std::optional<unsigned> size;       ///< if not set, the family's usual size
  std::string fcl;                    ///< the file with the text of FCL's exceptions
};

// The request of `fathom certify`.

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
  std::string print_input;  ///< the id of the case whose lines are printed, as the subject reads them; empty: none
  std::string harness;      ///< the user's own program for --shrink; empty: none
  std::string metamorphic;  ///< as typed: "all", or a list with commas
  std::vector<std::string> variants;                                              ///< the same, as a list
  std::string expect_fail, write_expect_fail, junit, html, certificates, shrink;  ///< paths; empty: not wanted
  std::optional<std::size_t> max_errors;
};

// What the user asked for of study --sweep.

struct SweepRequest {
  std::string family;                 ///< empty: no sweep
  std::vector<unsigned> sizes;        ///< ascending
  std::vector<ClosestLines> engines;  ///< side by side; empty: the usual one
};

// What the user asked for, as parsed from the command line.

enum class Command { depth, width, approx, ray, metric, study, stages, explain, cases, certify };

struct Request {
  Command command = Command::depth;
  std::vector<std::string> inputs;  ///< depth, approx, ray, metric, study, stages, explain: two meshes or one stream;
                                    ///< width: one mesh or one stream; cases --from: two meshes
  Method method = Method::automatic;
  bool shallow = false;  ///< use shallow_depth instead of a Method
  std::optional<ClosestLines> closest_lines;
  std::uint64_t seed = 1;
  std::optional<std::size_t> optima;  ///< depth: how many optima are listed; all if not set
  std::optional<unsigned> digits;     ///< of the enclosure of the depth, if one is wanted
  std::optional<unsigned> bits;       ///< depth, width: how near the bounds of curved bodies are to be
  bool exact = false;                 ///< text: exact numbers where else decimals stand
  bool json = false;
  bool csv = false;          ///< study, depth --along: rows
  std::string html;          ///< study: the file of the page; empty: none
  std::string command_line;  ///< with --html: quoted for a shell
  bool all = false;          ///< study: list every coincidence, not the first few of each kind
  bool times = false;        ///< stages, explain, study --sweep: with the seconds that each took
  bool counters = false;
  std::optional<unsigned> threads;  ///< for a stream; as many as there are cores unless given
  /// depth, width: the file for the certificate, or the folder for those of a stream; empty: none
  std::string certificate;
  std::string svg;  ///< depth: the file for the picture, or the folder for those of a stream; study --sweep, depth
                    ///< --along, stages: the file for charts; empty: none
  bool embed_certificate = false;             ///< as a field of each JSON result
  std::optional<mpq_class> delta;             ///< approx, width: the answer may be wrong by a factor of 1 + delta
  std::optional<Point> direction;             ///< ray
  std::string ball;                           ///< metric: a mesh
  std::optional<std::string> pose_a, pose_b;  ///< where the two bodies stand, as typed
  bool require_convex = false;                ///< of bodies with faces
  std::optional<std::string> case_id;         ///< depth, study, stages, explain: one case of a stream
  std::string page;                           ///< explain: the file for the page
  AlongRequest along;                         ///< depth
  bool pieces = false;                        ///< depth, explain: the bodies are unions of the pieces in their files
  SweepRequest sweep;                         ///< study

  CasesRequest cases;
  CertifyRequest certify;
  Decimals decimals = Decimals::binary64;  ///< of text meshes; cases say it themselves
};

/// `width` looks at one body, against itself.
inline bool has_one_body(const Request& request) { return request.command == Command::width; }

}  // namespace fathom::cli
