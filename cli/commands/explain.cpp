// SPDX-License-Identifier: GPL-3.0-or-later
// fathom explain A B -o PAGE.html | CASES.jsonl --case ID -o PAGE.html

#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/answer_output.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/shape_names.hpp"
#include "view/page/page.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/paint.hpp"
#include "view/stages/stages.hpp"

namespace fathom::cli {
namespace {

struct ExplainRequest {
  DepthRequest depth;  ///< the page has what `fathom depth --json` prints
  std::string page;    ///< the file
  bool times;          ///< with the seconds that each stage took
};

std::vector<std::string> notes_on(const AboutBodies& bodies) {
  std::vector<std::string> notes;
  if (const std::string dents = shapes::dents_text(bodies.hull); !dents.empty()) notes.push_back(dents);
  if (const std::optional<std::string> sizes = shapes::sizes_note(bodies.sizes)) notes.push_back(*sizes);
  return notes;
}

std::string page_of(const Case& single, const ExplainRequest& request, Monitor& monitor) {
  Workspace workspace;
  const AskedCase asked = looked_at(single, request.depth);
  const AnsweredCase answered = answered_by(asked, request.depth, question_of(request.depth, monitor, workspace));
  const Answer& answer = answered.answer;
  if (!answer.complete()) throw Interrupted();
  const std::string picture =
      picture::scene_panels(answer_scene(single, answer), "still", "A and B, and the way out of A");
  const auto page = [&](auto stages) {
    stages.id = single.id;
    return page::html_page({FATHOM_VERSION, output::answer_json(answered, request.depth.form), stages,
                            files::case_json(single), notes_on(asked.bodies), picture});
  };
  if (const UnionDepth* const unions = std::get_if<UnionDepth>(&answer.found))
    return page(stages::stages_of(pieces_of(single.a), pieces_of(single.b), *unions, &monitor));
  return page(stages::stages_of(single.a, single.b, {.times = request.times, .monitor = &monitor}));
}

}  // namespace

ExitCode run_explain(const Given& given) {
  const ExplainRequest request{DepthRequest(given), given.text("--output"), given.flag("--times")};
  CertificateFile file(request.page, "page");  // an unwritable path fails early
  Case single = asked_case(request.depth, true);
  if (request.depth.inputs.size() == 2)
    single.id = picture::without_folders(single.id);  // names of files; a case has its own
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
