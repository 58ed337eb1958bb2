// SPDX-License-Identifier: GPL-3.0-or-later
#include <new>
#include <optional>

#include "cli/commands/answer.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/output/hull_note.hpp"
#include "cli/output/json_result.hpp"
#include "cli/output/json_values.hpp"
#include "cli/output/text_result.hpp"

namespace fathom::cli {

ExitCode answer_single(const Request& request, Case single, const Answering& answering) {
  const Working working;
  single.id = valid_utf8(single.id);  // of file names; result and certificate are to agree on it
  std::optional<CertificateFile> file;
  if (!request.certificate.empty()) file.emplace(request.certificate);
  Progress progress;
  const Answer answer = answering(single, progress);
  tell_of_hulls(single, request.command == Command::width, progress);
  if (file) file->write(answer.certificate);
  print(request.json ? json_result(answer, request) : text_block(answer, request));
  return fine;
}

std::string fault_text(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  return std::string("internal error: ") + error.what();
}

}  // namespace fathom::cli
