// SPDX-License-Identifier: GPL-3.0-or-later
// fathom explain A B -o PAGE.html | CASES.jsonl --case ID -o PAGE.html
#include "cli/commands/command.hpp"
#include "cli/commands/exact_replies.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/union_output.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/shape_names.hpp"
#include "view/page/page.hpp"
#include "view/page/union_page.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/scene_picture.hpp"
#include "view/stages/stages.hpp"

namespace fathom::cli {
namespace {

/// What `fathom depth --json` prints about the case.
std::string depth_json(const AskedCase& asked, const Request& request, Monitor& monitor) {
  Request of_depth = request;
  of_depth.command = Command::depth;
  of_depth.json = true;
  Workspace workspace;
  return exact_replies(of_depth).reply(asked, monitor, workspace).text;
}

std::vector<std::string> notes_on(const AboutBodies& bodies) {
  std::vector<std::string> notes;
  if (const std::string dents = shapes::dents_text(bodies.hull); !dents.empty()) notes.push_back(dents);
  if (const std::optional<std::string> sizes = shapes::sizes_note(bodies.sizes)) notes.push_back(*sizes);
  return notes;
}

/// The bodies, seen across the way out.
std::string picture_of(const Case& single, Monitor& monitor) {
  constexpr const char *name = "still", *label = "A and B, and the way out of A";
  if (!has_shape(single)) {
    const Depth depth = penetration_depth(single.a, single.b, {.monitor = &monitor});
    return picture::scene_panels(picture::scene_of(picture::Pair{single.a.points, single.b.points, depth}), name, label);
  }
  const Shape a = files::shape_of(single.a), b = files::shape_of(single.b);
  SignedDepthOptions options;
  options.cores.monitor = &monitor;
  return picture::scene_panels(picture::scene_of(a, b, signed_depth(a, b, options)), name, label);
}

std::string page_of(const Case& single, const Request& request, Monitor& monitor) {
  const AskedCase asked = looked_at(single, request);
  const std::string depth = depth_json(asked, request, monitor);
  stages::Stages stages = stages::stages_of(single.a, single.b, {.times = request.times, .monitor = &monitor});
  stages.id = single.id;
  return page::html_page({FATHOM_VERSION, depth, stages, files::case_json(single), notes_on(asked.bodies), picture_of(single, monitor)});
}

std::string page_of_unions(const Case& single, const Request& request, Monitor& monitor) {
  const AskedCase asked = looked_at(single, request);
  const UnionAnswer answer{single.id, union_depth_of(single, monitor), asked.bodies};
  if (!answer.depth.complete) throw Interrupted();
  const Pieces a = pieces_of(single.a), b = pieces_of(single.b);
  stages::UnionStages stages = stages::stages_of(a, b, answer.depth, &monitor);
  stages.id = single.id;
  const std::string picture = picture::scene_panels(picture::scene_of(a, b, answer.depth), "still", "A and B, and the way out of A");
  return page::html_page({FATHOM_VERSION, union_json(answer, request), stages, files::case_json(single), notes_on(asked.bodies), picture});
}

}  // namespace

ExitCode run_explain(const Request& request) {
  CertificateFile file(request.page, "page");  // an unwritable path fails early
  Case single = asked_case(request, true);
  if (request.inputs.size() == 2) single.id = picture::without_folders(single.id);  // names of files; a case has its own
  std::string page;
  {
    const Working working;
    Progress progress;
    page = has_union(single) ? page_of_unions(single, request, progress) : page_of(single, request, progress);
  }
  file.write(page);
  return fine;
}

}  // namespace fathom::cli
