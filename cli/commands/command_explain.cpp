// SPDX-License-Identifier: GPL-3.0-or-later
// fathom explain A B -o PAGE.html | CASES.jsonl --case ID -o PAGE.html
#include "cli/args/shell_words.hpp"
#include "cli/commands/cases_json.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/exact_replies.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "reference/files/body_json.hpp"
#include "view/page/page.hpp"
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

std::string page_of(const Case& single, const Request& request, Monitor& monitor) {
  const AskedCase asked(single, false);
  if (const std::string fault = wrong_meshes(asked.bodies.hull, request.require_convex); !fault.empty())
    throw InputError(single.id, 0, fault);
  const std::string depth = depth_json(asked, request, monitor);
  stages::Stages stages = stages::stages_of(single.a, single.b, {.times = request.times, .monitor = &monitor});
  stages.id = single.id;
  const std::string pair = case_json({single.id, files::body_json(single.a), files::body_json(single.b), {}, {}, ""});
  return page::html_page({FATHOM_VERSION, depth, stages, pair, notes_on(asked.bodies), {}});
}

}  // namespace

ExitCode run_explain(const Request& request) {
  CertificateFile file(request.page, "page");  // an unwritable path fails early
  const Case single = asked_case(request);
  std::string page;
  {
    const Working working;
    Progress progress;
    page = page_of(single, request, progress);
  }
  file.write(page);
  return fine;
}

}  // namespace fathom::cli
