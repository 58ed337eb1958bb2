// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B --along X,Y,Z --steps N | CASES.jsonl --case ID --along X,Y,Z
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/io/terminal.hpp"
#include "cli/output/along_output.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t indent = 4;  // of the further lines of a row, on a narrow terminal

/// Answers for A at each place of the path.
class Walk {
 public:
  Walk(const Case& pair, Request request, Monitor& monitor) : pair_(pair), request_(std::move(request)), monitor_(monitor) {
    request_.optima = 1;  // ties are not shown
    if (!has_shape(pair)) return;
    a_ = files::shape_of(pair.a);
    b_ = files::shape_of(pair.b);
    require_depth(pair.id, *a_, *b_);
  }

  AlongStep at(std::uint32_t number) {
    const mpq_class share = quotient(number, request_.along.steps);
    const Point& t = *request_.along.translation;
    const files::GivenPose pose{.place = {mpq_class(share * t.x), mpq_class(share * t.y), mpq_class(share * t.z)}};
    const Question question = question_of(request_, monitor_, workspace_);
    if (a_)
      return along_step(number, share,
                        signed_depth(moved(*a_, files::exact_pose(pose)), *b_, {.cores = question.options, .bits = question.bits}));
    Body a = pair_.a;
    files::place(a, pose);
    return along_step(number, share, penetration_depth(a, pair_.b, question.options));
  }

 private:
  static mpq_class quotient(std::uint32_t number, std::uint32_t of) {
    mpq_class result(number, of);
    result.canonicalize();
    return result;
  }

  const Case& pair_;
  Request request_;
  Monitor& monitor_;
  std::optional<Shape> a_, b_;  // unless both are polytopes
  Workspace workspace_;
};

/// Prints rows as soon as they are known; JSON, which is one object, in the end.
void print_row(const Path& path, const AlongStep& step, const Request& request) {
  if (request.csv) print(along_csv_row(step));
  else if (!request.json) print(fitted(along_text_row(path, step), indent));
}

}  // namespace

ExitCode run_along(const Request& request) {
  std::unique_ptr<CertificateFile> picture;
  if (!request.svg.empty()) picture = std::make_unique<CertificateFile>(request.svg, "picture");  // an unwritable path fails early
  const Case pair = asked_case(request, false);
  const Working working;
  Progress progress("steps");
  const AskedCase asked = looked_at(pair, request);
  const Path path{pair.id, *request.along.translation, request.along.steps};
  Walk walk(pair, request, progress);
  std::vector<AlongStep> steps;
  if (!request.json) print(request.csv ? along_csv_header() : fitted(along_text_header(path), indent));
  for (std::uint32_t i = 0; i <= path.steps; ++i) {
    steps.push_back(walk.at(i));
    progress.answered();
    print_row(path, steps.back(), request);
    progress.count({i + 1, std::size_t{path.steps} + 1});
  }
  progress.clear();
  if (request.json) print(along_json(path, steps));
  if (picture) picture->write(along_svg(path, steps));
  if (const std::string dents = shapes::dents_text(asked.bodies.hull); !dents.empty()) talk(dents);
  return fine;
}

}  // namespace fathom::cli
