// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study A B | CASES.jsonl | -

#include "verify/study/study.hpp"

#include <limits>
#include <memory>
#include <optional>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/study_output.hpp"
#include "cli/output/study_page.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "view/picture/markup.hpp"

namespace fathom::cli {
namespace {

StudyOptions options_of(const Request& request, Monitor& monitor) {
  StudyOptions options;
  if (request.all) options.listed = std::numeric_limits<std::size_t>::max();
  options.monitor = &monitor;
  return options;
}

ShapeStudy shape_study_of(const Case& pair, const Request& request, Monitor& monitor) {
  if (request.csv)
    throw InputError(pair.id, 0,
                     "the rows of --csv are about polytopes, found a shape that is none: --json takes both");
  const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
  require_depth(pair.id, a, b);
  return study(a, b, options_of(request, monitor));
}

std::string text_of(const std::string& id, const ShapeStudy& study, const Request& request) {
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

std::string text_of(const std::string& id, const Study& study, const Request& request) {
  if (request.csv) return study_csv_row(id, study);
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

/// The file of the page, and what goes into it.
class PageFile {
 public:
  explicit PageFile(const Request& request) : request_(request), page_(is_stream(request)) {
    if (!request.html.empty()) file_.emplace(request.html, "page");
  }

  /// The reply, which also adds to the page, once its turn has come.
  template <class AnyStudy>
  CaseReply reply(const AskedCase& pair, AnyStudy found) {
    CaseReply result{text_of(pair.input.id, found, request_)};
    if (!file_) return result;
    Case seen = pair.input;
    if (request_.inputs.size() == 2) seen.id = picture::without_folders(seen.id);  // names of files; a case has its own
    result.keep = [this, seen = std::move(seen), kept = std::make_shared<AnyStudy>(std::move(found))] {
      page_.add(seen, *kept);
    };
    return result;
  }
  void lose(const std::string& sentence) { page_.add_fault(picture::without_folders(sentence)); }
  void write(const std::string& cut_short) {
    if (file_) file_->write(page_.html(request_.command_line, cut_short));
  }

 private:
  const Request& request_;
  StudyPage page_;
  std::optional<CertificateFile> file_;
};

}  // namespace

ExitCode run_study(const Request& request) {
  if (!request.sweep.family.empty()) return run_sweep(request);
  PageFile page(request);
  Replies replies;
  replies.reply = [&](const AskedCase& pair, Monitor& monitor, Workspace&) {
    if (has_shape(pair)) return page.reply(pair, shape_study_of(pair, request, monitor));
    return page.reply(pair, study(pair.input.a.points, pair.input.b.points, options_of(request, monitor)));
  };
  replies.lost = [&](const std::string& sentence) { page.lose(sentence); };
  if (request.csv) {
    replies.header = study_csv_header();
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return study_csv_error(item.id, fault); };
  } else if (request.json) {
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return study_json_error(item.id, item.line, fault);
    };
  }
  try {
    const ExitCode code = reply_to_inputs(request, replies);
    page.write("");
    return code;
  } catch (const Interrupted&) {
    page.write("interrupted");
    throw;
  }
}

}  // namespace fathom::cli
