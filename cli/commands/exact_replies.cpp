// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/exact_replies.hpp"

#include <memory>
#include <optional>

#include "cli/io/certificate_file.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/text_result.hpp"
#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/width.hpp"

namespace fathom::cli {
namespace {

Depth solve(const Case& single, const Body& b, const Request& request, Monitor& monitor) {
  Options options;
  options.method = request.method;
  options.closest_lines = request.closest_lines;
  options.seed = request.seed;
  options.optima = request.optima;
  options.monitor = &monitor;
  if (request.shallow) return shallow_depth(single.a.points, b.points, options);
  return has_one_body(request) ? width(single.a.points, options) : penetration_depth(single.a.points, b.points, options);
}

Answer answer_to(const Case& single, const Request& request, Monitor& monitor) {
  const Body& b = has_one_body(request) ? single.a : single.b;
  Answer answer{single.id, solve(single, b, request, monitor)};
  if (!request.certificate.empty() || request.embed_certificate) {
    Certificate certificate = make_certificate(single.a.points, b.points, answer.depth, &monitor);
    certificate.id = single.id;
    answer.certificate = certificate_text(certificate);
  }
  return answer;
}

/// Where the certificates of a run go: a file, or for a stream a folder.
class CertificatePlaces {
 public:
  explicit CertificatePlaces(const Request& request) : path_(request.certificate) {
    if (!path_.empty() && is_stream(request)) folder_.emplace(path_);
  }

  /// Null if none is to be written.
  std::unique_ptr<CertificateFile> open(const Case& single) {
    if (path_.empty()) return nullptr;
    return std::make_unique<CertificateFile>(folder_ ? folder_->file(single.id) : path_);
  }

 private:
  std::string path_;
  std::optional<CertificateFolder> folder_;
};

std::string text_of(const Answer& answer, const Request& request) {
  if (request.json) return json_result(answer, request);
  return is_stream(request) ? text_line(answer, request) : text_block(answer, request);
}

}  // namespace

Replies exact_replies(const Request& request) {
  Replies replies;
  replies.reply = [&request, places = std::make_shared<CertificatePlaces>(request)](const Case& single, Progress& progress) {
    const std::unique_ptr<CertificateFile> file = places->open(single);  // an unwritable path fails early
    const Answer answer = answer_to(single, request, progress);
    if (file) file->write(answer.certificate);
    return text_of(answer, request);
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return json_error(item.id, item.line, fault); };
  return replies;
}

}  // namespace fathom::cli
