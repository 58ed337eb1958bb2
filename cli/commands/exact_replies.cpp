// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/exact_replies.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/commands/file_places.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/certificate_limits.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/picture_output.hpp"
#include "cli/output/shape_output.hpp"
#include "cli/output/text_result.hpp"
#include "cli/output/union_output.hpp"
#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
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

}  // namespace

Options options_of(const Request& request, Monitor& monitor, Workspace& workspace) {
  Options options;
  options.method = request.method;
  options.closest_lines = request.closest_lines;
  options.seed = request.seed;
  options.optima = request.optima;
  options.monitor = &monitor;
  options.workspace = &workspace;
  return options;
}

SignedDepthOptions shape_options_of(const Request& request, Monitor& monitor, Workspace& workspace) {
  SignedDepthOptions options;
  options.cores = options_of(request, monitor, workspace);
  options.bits = bits_of(request);
  return options;
}

UnionDepth union_depth_of(const Case& single, Monitor& monitor) try {
  return union_depth(pieces_of(single.a), pieces_of(single.b), {&monitor});
} catch (const std::invalid_argument& error) {
  throw InputError(single.id, 0, error.what());
}

namespace {

Depth solve(const Case& single, const Body& b, const Request& request, Monitor& monitor, Workspace& workspace) {
  const Options options = options_of(request, monitor, workspace);
  if (request.shallow) return shallow_depth(single.a.points, b.points, options);
  return has_one_body(request) ? width(single.a.points, options) : penetration_depth(single.a, b, options);
}

Answer answer_to(const AskedCase& asked, const Request& request, Monitor& monitor, Workspace& workspace) {
  const Case& single = asked;
  const Body& b = has_one_body(request) ? single.a : single.b;
  Answer answer{single.id, solve(single, b, request, monitor, workspace)};
  answer.bodies = asked.bodies;
  if (!request.certificate.empty() || request.embed_certificate)
    answer.certificate = certificate_text(single.a, b, answer.depth, single.id, &monitor);
  return answer;
}

/// What a run writes beside its replies.
struct Files {
  FilePlaces certificates, pictures;

  explicit Files(const Request& request)
      : certificates(request, request.certificate, "certificate", ".cert"), pictures(request, request.svg, "picture", ".svg") {}
};

/// Throws InputError if the request asks for what shapes do not have.
ShapeAnswer shape_answer_to(const AskedCase& asked, const Request& request, Monitor& monitor, Workspace& workspace) {
  const Case& single = asked;
  if (request.shallow) throw InputError(single.id, 0, "--method shallow takes polytopes, found a shape that is none");
  const SignedDepthOptions options = shape_options_of(request, monitor, workspace);
  const Shape a = files::shape_of(single.a), b = has_one_body(request) ? a : files::shape_of(single.b);
  if (has_one_body(request) && std::holds_alternative<HalfSpace>(a.core))
    throw InputError(single.id, 0, "a half-space has no width: it is infinite");
  require_depth(single.id, a, b);
  ShapeAnswer answer{single.id, signed_depth(a, b, options), {is_flat(a), is_flat(b)}};
  answer.bodies = asked.bodies;
  if (!request.certificate.empty() || request.embed_certificate)
    answer.certificate = certificate_text(a, b, answer.depth, single.id, ShapeFormat::shortest, &monitor);
  return answer;
}

/// Throws InputError as union_depth_of does, and if the request asks for what unions do not have. A search that is interrupted answers
/// between which bounds the depth lies.
UnionAnswer union_answer_to(const AskedCase& asked, const Request& request, Monitor& monitor) {
  const Case& single = asked;
  if (request.shallow || request.closest_lines || request.method != Method::automatic || request.optima)
    throw InputError(single.id, 0, "a union of pieces has one method, and goes with none of --method, --closest-lines and --optima");
  UnionAnswer answer{single.id, union_depth_of(single, monitor), asked.bodies};
  if (!answer.depth.complete) return answer;
  if (!request.certificate.empty() || request.embed_certificate)
    answer.certificate = certificate_text(pieces_of(single.a), pieces_of(single.b), answer.depth, single.id, &monitor);
  return answer;
}

std::string text_of(const UnionAnswer& answer, const Request& request) {
  if (request.json) return union_json(answer, request);
  return is_stream(request) ? union_line(answer, request) : union_text(answer, request);
}

std::string picture_text(const Case& single, const UnionAnswer& answer, const Request& request) {
  if (!answer.depth.complete) return "";
  return union_picture(answer, pieces_of(single.a), pieces_of(single.b), request);
}

ExitCode code_of(const UnionAnswer& answer) { return answer.depth.complete ? fine : interrupted; }
ExitCode code_of(const Answer&) { return fine; }
ExitCode code_of(const ShapeAnswer&) { return fine; }

std::string text_of(const Answer& answer, const Request& request) {
  if (request.json) return json_result(answer, request);
  return is_stream(request) ? text_line(answer, request) : text_block(answer, request);
}

std::string text_of(const ShapeAnswer& answer, const Request& request) {
  if (request.json) return shape_json(answer, request);
  return is_stream(request) ? shape_line(answer, request) : shape_block(answer, request);
}

}  // namespace

Replies exact_replies(const Request& request) {
  Replies replies;
  replies.tells_of_dents = true;
  replies.takes_unions = request.command == Command::depth;
  replies.reply = [&request, files = std::make_shared<Files>(request)](const AskedCase& asked, Monitor& monitor,
                                                                       Workspace& workspace) -> CaseReply {
    const std::unique_ptr<CertificateFile> proof = files->certificates.single();  // an unwritable path fails early
    const std::unique_ptr<CertificateFile> drawing = files->pictures.single();
    const Case& single = asked;
    const auto reply_with = [&](const auto& answer) {
      if (!answer.certificate.empty()) require_readable(answer.id, answer.certificate);
      CaseReply reply{text_of(answer, request), {}, code_of(answer)};
      const std::string picture = files->pictures.wanted() ? picture_text(single, answer, request) : "";
      if (reply.code != fine) return reply;
      if (proof) proof->write(answer.certificate);
      if (drawing) drawing->write(picture);
      if (!proof && !drawing && (files->certificates.wanted() || files->pictures.wanted()))
        reply.keep = [files, picture, id = answer.id, certificate = answer.certificate] {
          files->certificates.write_to_folder(id, certificate);
          files->pictures.write_to_folder(id, picture);
        };
      return reply;
    };
    if (has_union(single)) return reply_with(union_answer_to(asked, request, monitor));
    return single.a.shape || (single.b.shape && !has_one_body(request)) ? reply_with(shape_answer_to(asked, request, monitor, workspace))
                                                                        : reply_with(answer_to(asked, request, monitor, workspace));
  };
  if (request.json)
    replies.error_line = [&request](const CaseItem& item, const std::string& fault) { return json_error(item.id, item.line, fault); };
  return replies;
}

}  // namespace fathom::cli
