// SPDX-License-Identifier: GPL-3.0-or-later
// fathom golden export: declared in command_golden.hpp.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "cli/commands/golden.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "verify/golden/export/export.hpp"

namespace fathom::cli {

ExitCode export_golden(const GoldenRequest& request) {
  StopOnInterrupt interrupt;
  std::optional<CertificateFile> proofs;
  if (!request.certificates.empty()) proofs.emplace(request.certificates, "file of certificates");
  const bool own = request.folder == "-" || (std::filesystem::exists(request.folder) && !std::filesystem::is_directory(request.folder));
  const golden::Exported exported = own ? golden::export_own_cases(request.folder, request.exported, &interrupt)
                                        : golden::export_release(request.folder, request.exported, &interrupt);
  if (proofs) proofs->write(exported.certificates);
  print(exported.text.substr(0, exported.text.size() - 1));  // print ends the last line
  talk(fmt::format("{} of {} fitting records; of all {}, {} are beyond binary64, {} are excluded, {} have more points", exported.chosen,
                   exported.fitting, exported.records, exported.not_doubles, exported.excluded, exported.too_large));
  return fine;
}

}  // namespace fathom::cli
