// SPDX-License-Identifier: GPL-3.0-or-later
// fathom explain --pieces A.obj B.obj -o PAGE.html
#include <stdexcept>

#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/json.hpp"
#include "cli/output/union_output.hpp"
#include "fathom/files.hpp"
#include "view/page/union_page.hpp"
#include "view/picture/scene_picture.hpp"

namespace fathom::cli {
namespace {

std::string page_of(const std::string& id, const Pieces& a, const Pieces& b, Monitor& monitor) {
  const UnionDepth depth = union_depth(a, b, {&monitor});
  if (!depth.complete) throw Interrupted();
  stages::UnionStages stages = stages::stages_of(a, b, depth, &monitor);
  stages.id = id;
  const std::string picture = picture::scene_panels(picture::scene_of(a, b, depth), "still", "A and B, and the way out of A");
  return page::html_page({FATHOM_VERSION, union_json(id, depth), stages, picture});
}

}  // namespace

ExitCode run_explain_pieces(const Request& request) {
  CertificateFile file(request.page, "page");  // an unwritable path fails early
  const std::string id = valid_utf8(request.inputs[0] + " " + request.inputs[1]);
  const Pieces a = read_pieces(request.inputs[0], request.decimals), b = read_pieces(request.inputs[1], request.decimals);
  std::string page;
  try {
    const Working working;
    Progress progress;
    page = page_of(id, a, b, progress);
  } catch (const std::invalid_argument& error) {
    throw InputError(id, 0, error.what());
  }
  file.write(page);
  return fine;
}

}  // namespace fathom::cli
