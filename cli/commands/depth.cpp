// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B | CASES.jsonl | -

#include "cli/commands/depth.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/certificate_file.hpp"
#include "fathom/approximate.hpp"
#include "fathom/width.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::cli {
namespace {

/// The bits that bounds must have so that their digits can agree.
unsigned bits_of(const Request& request) {
  const unsigned usual = SignedDepthOptions{}.bits;
  if (request.bits || !request.digits) return request.bits.value_or(usual);
  const unsigned long enough = *request.digits * 3322UL / 1000 + 4;  // log2(10) < 3.322
  return static_cast<unsigned>(std::clamp<unsigned long>(enough, usual, most_bound_bits));
}

/// What a run writes beside its replies.
struct Files {
  FilePlaces certificates, pictures;

  explicit Files(const Request& request)
      : certificates(request, request.certificate, "certificate", ".cert"),
        pictures(request, request.svg, "picture", ".svg") {}
};

std::string text_of(const AnsweredCase& answered, const Request& request) {
  if (request.json) return answer_json(answered, request);
  return is_stream(request) ? answer_line(answered, request) : answer_block(answered, request);
}

}  // namespace

Question question_of(const Request& request, Monitor& monitor, Workspace& workspace) {
  Question question;
  question.options.method = request.method;
  question.options.closest_lines = request.closest_lines;
  question.options.seed = request.seed;
  question.options.optima = request.optima;
  question.options.monitor = &monitor;
  question.options.workspace = &workspace;
  question.bits = bits_of(request);
  return question;
}

AnsweredCase answered_by(const AskedCase& asked, const Request& request, const Question& question) {
  const Case& single = asked;
  const bool one = has_one_body(request);
  const Body& b = one ? single.a : single.b;
  if (has_union(single)) {
    if (request.shallow || request.closest_lines || request.method != Method::automatic || request.optima)
      throw InputError(
          single.id, 0,
          "a union of pieces has one method, and goes with none of --method, --closest-lines and --optima");
  } else if (single.a.shape || b.shape) {
    if (request.shallow) throw InputError(single.id, 0, "--method shallow takes polytopes, found a shape that is none");
    if (one && single.a.shape && std::holds_alternative<HalfSpace>(single.a.shape->core))
      throw InputError(single.id, 0, "a half-space has no width: it is infinite");
    if (single.a.shape && b.shape) require_depth(single.id, *single.a.shape, *b.shape);
  } else if (request.shallow || one) {
    Depth depth = request.shallow ? shallow_depth(single.a.points, b.points, question.options)
                                  : width(single.a.points, question.options);
    const BodyFacts facts = depth;
    return {single.id, {std::move(depth)}, asked.bodies, facts};
  }
  try {
    Answer answer = exact_answer(single.a, b, question);
    const BodyFacts facts = facts_of(single.a, b, answer);
    return {single.id, std::move(answer), asked.bodies, facts};
  } catch (const std::invalid_argument& error) {
    if (!has_union(single)) throw;
    throw InputError(single.id, 0, error.what());
  }
}

Replies exact_replies(const Request& request) {
  Replies replies;
  replies.tells_of_dents = true;
  replies.takes_unions = request.command == Command::depth;
  replies.reply = [&request, files = std::make_shared<Files>(request)](const AskedCase& asked, Monitor& monitor,
                                                                       Workspace& workspace) -> CaseReply {
    const std::unique_ptr<CertificateFile> proof = files->certificates.single();  // an unwritable path fails early
    const std::unique_ptr<CertificateFile> drawing = files->pictures.single();
    AnsweredCase answered = answered_by(asked, request, question_of(request, monitor, workspace));
    if (!answered.answer.complete()) return {text_of(answered, request), {}, interrupted};
    const Case& single = asked;
    if (!request.certificate.empty() || request.embed_certificate) {
      answered.certificate =
          certificate_text(single.a, has_one_body(request) ? single.a : single.b, answered.answer, single.id, &monitor);
      require_readable(single.id, answered.certificate);
    }
    CaseReply reply{text_of(answered, request)};
    const std::string picture = files->pictures.wanted() ? answer_picture(single, answered, request) : "";
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

ExitCode run_depth(const Request& request) {
  return request.along.translation ? run_along(request) : reply_to_inputs(request, exact_replies(request));
}

}  // namespace fathom::cli
