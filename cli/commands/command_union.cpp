// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth --pieces A.obj B.obj
#include <optional>
#include <stdexcept>

#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/json.hpp"
#include "cli/output/union_output.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

// A search that is interrupted prints between which bounds the depth lies, and draws nothing.
ExitCode run_union(const Request& request) {
  const std::string id = valid_utf8(request.inputs[0] + " " + request.inputs[1]);
  const Pieces a = read_pieces(request.inputs[0], request.decimals), b = read_pieces(request.inputs[1], request.decimals);
  std::optional<CertificateFile> drawing;  // an unwritable path fails early
  if (!request.svg.empty()) drawing.emplace(request.svg, "picture");
  const Working working;
  Progress progress;
  UnionDepth depth;
  try {
    depth = union_depth(a, b, {&progress});
  } catch (const std::invalid_argument& error) {
    throw InputError(id, 0, error.what());
  }
  progress.clear();
  if (drawing && depth.complete) drawing->write(union_picture(id, a, b, depth, request));
  print(request.json ? union_json(id, depth) : union_text(depth, request));
  return depth.complete ? fine : interrupted;
}

}  // namespace fathom::cli
