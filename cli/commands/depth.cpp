// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B | CASES.jsonl | -
// Computes the depth, or the distance, and prints the answer.

#include "cli/commands/depth.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/body_notes.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::cli {
namespace {

/// Returns how many bits the bounds need so that the digits asked for can agree.
unsigned bits_of(const DepthRequest& request) {
  const unsigned usual = SignedDepthOptions{}.bits;
  if (request.bits || !request.form.digits) return request.bits.value_or(usual);
  const unsigned long enough = *request.form.digits * 3322UL / 1000 + 4;  // log2(10) < 3.322
  return static_cast<unsigned>(std::clamp<unsigned long>(enough, usual, most_bound_bits));
}

/// The files of a run: certificates and pictures.
struct Files {
  FilePlaces certificates, pictures;

  explicit Files(const DepthRequest& request)
      : certificates(request, request.certificate, "certificate", ".cert"),
        pictures(request, request.svg, "picture", ".svg") {}
};

std::string text_of(const AnsweredCase& answered, const DepthRequest& request) {
  if (request.json) return output::answer_json(answered, request.form);
  return is_stream(request) ? answer_line(answered, request.form) : answer_block(answered, request.form);
}

Answer shallow_answer(const Body& a, const Body& b, const Options& options) {
  if (a.dimension == 3) return {shallow_depth(a.points, b.points, options)};
  const answer::Prisms prisms = answer::prisms_of(a, b);
  return answer::in_plane(a, b, {shallow_depth(prisms.a.points, prisms.b.points, options)});
}

}  // namespace

DepthRequest::DepthRequest(const Given& given)
    : BodiesRequest(given),
      form(given),
      closest_lines(typed_engine(given.text("--closest-lines"))),
      seed(given.integer<std::uint64_t>("--seed").value_or(1)),
      bits(given.integer<unsigned>("--bits")),
      certificate(given.text("--certificate")),
      svg(given.text("--svg")) {
  const std::string by = given.text("--method");
  if (by == "exact") method = Method::exact;
  if (by == "naive") method = Method::naive;
  shallow = by == "shallow";
}

Question question_of(const DepthRequest& request, Monitor& monitor, Workspace& workspace) {
  Question question;
  question.options.method = request.method;
  question.options.closest_lines = request.closest_lines;
  question.options.seed = request.seed;
  question.options.optima = request.form.optima;
  question.options.monitor = &monitor;
  question.options.workspace = &workspace;
  question.bits = bits_of(request);
  question.coaxial = !request.form.certificate;  // a checker compares answer and certificate
  return question;
}

AnsweredCase answered_by(const AskedCase& asked, const DepthRequest& request, const Question& question) {
  const Case& single = asked;
  const bool one = request.one_body;
  const Body& b = one ? single.a : single.b;
  if (files::has_union(single)) {
    if (request.shallow || request.closest_lines || request.method != Method::automatic || request.form.optima)
      throw InputError(
          single.id, 0,
          "a union of pieces has one method, and goes with none of --method, --closest-lines and --optima");
  } else if (single.a.shape || b.shape) {
    if (request.shallow) throw InputError(single.id, 0, "--method shallow takes polytopes, found a shape that is none");
    if (!one && single.a.shape && b.shape) require_depth(single.id, *single.a.shape, *b.shape);
  } else if (request.shallow || (one && single.a.dimension == 3)) {
    Answer answer = request.shallow ? shallow_answer(single.a, b, question.options)
                                    : Answer{width(single.a.points, question.options)};
    const BodyFacts facts = facts_of(single.a, b, answer);
    return {single.id, std::move(answer), asked.bodies, facts};
  }
  try {
    if (one && single.a.shape) shapes::require_width(*single.a.shape);
    Answer answer = exact_answer(single.a, b, question);
    const BodyFacts facts = facts_of(single.a, b, answer);
    return {single.id, std::move(answer), asked.bodies, facts};
  } catch (const std::invalid_argument& error) {
    if (!files::has_union(single) && !one) throw;
    throw InputError(single.id, 0, error.what());
  }
}

Replies exact_replies(const DepthRequest& request) {
  Replies replies;
  if (request.one_body) replies.refuses_unions = shapes::width_of_union;
  replies.reply = [&request, files = std::make_shared<Files>(request)](const AskedCase& asked, Monitor& monitor,
                                                                       Workspace& workspace) -> CaseReply {
    const std::unique_ptr<CertificateFile> proof = files->certificates.single();  // fails early for an unwritable path
    const std::unique_ptr<CertificateFile> drawing = files->pictures.single();
    AnsweredCase answered = answered_by(asked, request, question_of(request, monitor, workspace));
    if (!answered.answer.complete()) return {text_of(answered, request), {}, interrupted};
    const Case& single = asked;
    const Body& b = request.one_body ? single.a : single.b;
    const std::optional<Motion> motion = request.form.twists.in(single.a.dimension);
    if (request.form.manifold())
      answered.manifold = output::manifold_of(single.a, b, answered.answer, motion, &monitor, request.form.slack);
    if (!request.certificate.empty() || request.form.certificate) {
      std::vector<Twist> motions;
      if (motion)  // of A, with B at rest: of convex bodies it has the same derivative
        motions.push_back({motion->of_a.v - motion->of_b.v, motion->of_a.w - motion->of_b.w});
      answered.certificate =
          output::certificate_of(single.a, b, answered.answer, answered.manifold ? &*answered.manifold : nullptr,
                                 motions, answered.id, &monitor);
      require_readable(single.id, answered.certificate);
    }
    CaseReply reply{text_of(answered, request)};
    const std::string picture = files->pictures.wanted() ? answer_picture(single, answered, request.form) : "";
    if (proof) proof->write(answered.certificate);
    if (drawing) drawing->write(picture);
    if (!proof && !drawing && (files->certificates.wanted() || files->pictures.wanted()))
      reply.keep = [files, picture, id = single.id, certificate = answered.certificate] {
        files->certificates.write_to_folder(id, certificate);
        files->pictures.write_to_folder(id, picture);
      };
    return reply;
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::json_error(item.id, item.line, fault);
    };
  return replies;
}

ExitCode run_depth(const Given& given) {
  if (given.has("--along")) return run_along(given);
  const DepthRequest request(given);
  return reply_to_inputs(request, exact_replies(request));
}

}  // namespace fathom::cli
