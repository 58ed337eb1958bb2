// SPDX-License-Identifier: GPL-3.0-or-later
// fathom certify --claims FILE
// Judges what was published about pairs of bodies, as text and as JSON.

#include "verify/claims/claims.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>

#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/answer_output.hpp"
#include "fathom/certificate.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/result_fields.hpp"

namespace fathom::cli {
namespace {

/// Returns one line, and one more for each statement; without the last newline.
std::string claim_text(const claims::PublishedClaim& claim, const claims::JudgedClaim& judged) {
  std::string text = fmt::format("{}: {}", safe_id(claim.bodies.id), claims::verdict_name(judged.finding()));
  for (const claims::Statement& statement : judged.statements)
    text += fmt::format("\n  {}: {}; {}", statement.text, claims::verdict_name(statement.finding), statement.truth);
  return text;
}

using claims::Finding;
using claims::JudgedClaim;
using claims::PublishedClaim;

/// Writes certificates of the truth for wrong claims, if requested.
class Proofs {
 public:
  explicit Proofs(const std::string& folder) {
    if (!folder.empty()) folder_.emplace(folder);
  }
  void write(const PublishedClaim& claim, const JudgedClaim& judged) {
    if (!folder_ || judged.finding() != Finding::wrong) return;
    const Shape a = files::shape_of(claim.bodies.a), b = files::shape_of(claim.bodies.b);
    const std::string certificate = certificate_text(a, b, judged.truth, claim.bodies.id, ShapeFormat::richest);
    require_readable(claim.bodies.id, certificate);
    CertificateFile(folder_->file(claim.bodies.id)).write(certificate);
  }

 private:
  std::optional<CertificateFolder> folder_;
};

}  // namespace

ExitCode run_claims(const Given& given) {
  const std::string path = given.text("--claims"), name = path == "-" ? "<stdin>" : path;
  const InterruptGuard interrupt_guard;
  Proofs proofs(given.text("--certificates"));
  const bool json = given.flag("--json");
  std::ifstream file;
  if (path != "-") {
    files::require_readable(path);
    file.open(path, std::ios::binary);
  }
  std::istream& input = path == "-" ? std::cin : file;
  std::map<std::string_view, std::size_t> counts;
  ExitCode code = fine;
  std::size_t line = 0, found = 0, judged_claims = 0;
  for (std::string text; std::getline(input, text);) {
    ++line;
    if (interrupt_requested()) throw Interrupted();
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    ++found;
    const auto claim = claims::parse_claim(text, name, line);
    if (const InputError* const fault = std::get_if<InputError>(&claim)) {
      talk(fault->what());
      code = bad_input;
      continue;
    }
    const PublishedClaim& published = std::get<PublishedClaim>(claim);
    const JudgedClaim judged = claims::judge_claim(published);
    proofs.write(published, judged);
    print(json ? output::line_of("fathom/claim/1", FATHOM_VERSION, claims::ClaimLine{published, judged})
               : fitted(claim_text(published, judged), 4));
    ++counts[claims::verdict_name(judged.finding())];
    ++judged_claims;
    if (judged.finding() == Finding::wrong) code = std::max(code, judged_wrong);
  }
  if (found == 0) throw InputError(name, 1, "expected at least one claim, found an empty input");
  if (!json)
    print(fmt::format("{} claims: {} right, {} wrong, {} undecided, {} not judgeable", judged_claims, counts["right"],
                      counts["wrong"], counts["undecided"], counts["not-judgeable"]));
  return code;
}

}  // namespace fathom::cli
