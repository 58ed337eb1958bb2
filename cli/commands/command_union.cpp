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
#include "fathom/certificate.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

// A search that is interrupted prints between which bounds the depth lies, and proves nothing.
ExitCode run_union(const Request& request) {
  const std::string id = valid_utf8(request.inputs[0] + " " + request.inputs[1]);
  const Pieces a = read_pieces(request.inputs[0], request.decimals), b = read_pieces(request.inputs[1], request.decimals);
  std::optional<CertificateFile> file;
  if (!request.certificate.empty()) file.emplace(request.certificate);
  const Working working;
  Progress progress;
  UnionAnswer answer{id, {}, ""};
  try {
    answer.depth = union_depth(a, b, {&progress});
    if (answer.depth.complete && (file || request.embed_certificate))
      answer.certificate = certificate_text(a, b, answer.depth, id, &progress);
  } catch (const std::invalid_argument& error) {
    throw InputError(id, 0, error.what());
  }
  progress.clear();
  if (file && answer.depth.complete) file->write(answer.certificate);
  print(request.json ? union_json(answer, request) : union_text(answer.depth, request));
  return answer.depth.complete ? fine : interrupted;
}

}  // namespace fathom::cli
