// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <optional>

#include "cli/answer.hpp"
#include "cli/case_stream.hpp"
#include "cli/certificate_file.hpp"
#include "cli/command.hpp"
#include "cli/json_result.hpp"
#include "cli/output.hpp"
#include "cli/text_result.hpp"

namespace fathom::cli {

ExitCode answer_stream(const Request& request, const Solve& solve) {
  std::size_t cases = 0, hulls = 0;
  std::optional<CertificateFolder> folder;
  if (!request.certificate.empty()) folder.emplace(request.certificate);
  StreamWork work;
  work.answer = [&](const Case& single, Progress& progress) {
    std::optional<CertificateFile> file;
    if (folder) file.emplace(folder->file(single.id));
    const Answer answer = answer_to(single, request, solve, progress);
    if (hull_note(answer, request)) ++hulls;
    if (file) file->write(answer.certificate);
    print(request.json ? json_result(answer, request) : text_line(answer, request));
  };
  if (request.json) work.error_line = [](const CaseItem& item, const std::string& fault) { return json_error(item.id, item.line, fault); };
  const ExitCode code = for_each_case(request.inputs[0], work, &cases);
  if (hulls > 0) talk(fmt::format("{} of {} cases had points that are not extreme; convex hulls were taken", hulls, cases));
  return code;
}

}  // namespace fathom::cli
