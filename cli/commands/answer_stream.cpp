// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "cli/commands/answer.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/text_result.hpp"

namespace fathom::cli {

ExitCode answer_stream(const Request& request, const Answering& answering) {
  std::optional<CertificateFolder> folder;
  if (!request.certificate.empty()) folder.emplace(request.certificate);
  StreamWork work;
  work.one_body = request.command == Command::width;
  work.answer = [&](const Case& single, Progress& progress) {
    std::optional<CertificateFile> file;
    if (folder) file.emplace(folder->file(single.id));
    const Answer answer = answering(single, progress);
    if (file) file->write(answer.certificate);
    print(request.json ? json_result(answer, request) : text_line(answer, request));
  };
  if (request.json) work.error_line = [](const CaseItem& item, const std::string& fault) { return json_error(item.id, item.line, fault); };
  return for_each_case(request.inputs[0], work);
}

}  // namespace fathom::cli
