// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for, as parsed from the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"

namespace fathom::cli {

enum class Command { depth, width, approx, ray, metric, study, stages, explain, cases, certify };

struct Request {
  Command command = Command::depth;
  std::vector<std::string> inputs;  ///< depth, approx, ray, metric, study, stages, explain: two meshes or one stream; width: one mesh or
                                    ///< one stream; cases --from: two meshes
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
  std::string certificate;          ///< depth, width: the file for the certificate, or the folder for those of a stream; empty: none
  std::string svg;                  ///< depth: the file for the picture, or the folder for those of a stream; study --sweep, depth --along,
                                    ///< stages: the file for charts; empty: none
  bool embed_certificate = false;   ///< as a field of each JSON result
  std::optional<mpq_class> delta;   ///< approx, width: the answer may be wrong by a factor of 1 + delta
  std::optional<Point> direction;   ///< ray
  std::string ball;                 ///< metric: a mesh
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
