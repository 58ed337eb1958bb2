// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/commands/certify_results.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "verify/harness/judged_bodies.hpp"
#include "verify/harness/proof.hpp"
#include "verify/harness/report/html.hpp"
#include "verify/harness/report/junit.hpp"

namespace fathom::cli {
namespace {

using harness::ExpectedFailures;
using harness::HtmlFailure;
using harness::Outcome;

std::vector<HtmlFailure> shown_failures(const Collector& found, const CertificateNames& certificates) {
  std::map<std::size_t, const Case*> cases;
  for (const FailedCase& failed : found.failed()) cases[failed.outcome] = &failed.seen;
  std::vector<HtmlFailure> shown;
  for (const std::size_t index : harness::failures_to_show(found.outcomes())) {
    const auto certificate = certificates.find(index);
    shown.push_back({found.outcomes()[index], *cases.at(index), certificate == certificates.end() ? "" : certificate->second});
  }
  return shown;
}

}  // namespace

void probe_reports(const CertifyRequest& certify) {
  for (const std::string* path : {&certify.junit, &certify.html, &certify.write_expect_fail})
    if (!path->empty()) CertificateFile(*path, "report");
  for (const std::string* path : {&certify.certificates, &certify.shrink})
    if (!path->empty()) CertificateFolder{*path};
}

ExpectedFailures earlier_list(const CertifyRequest& certify) {
  std::error_code fault;
  const bool is_there = std::filesystem::is_regular_file(certify.write_expect_fail, fault);
  return is_there ? ExpectedFailures::read(certify.write_expect_fail) : ExpectedFailures();
}

CertificateNames write_certificates(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found) {
  CertificateNames names;
  if (certify.certificates.empty()) return names;
  CertificateFolder folder(certify.certificates);
  for (const FailedCase& failed : found.failed()) {
    const Outcome& outcome = found.outcomes()[failed.outcome];
    const std::string path = folder.file(outcome.variant.empty() ? outcome.id : outcome.id + '~' + outcome.variant);
    CertificateFile(path).write(harness::accepted_certificate(harness::judged_bodies(failed.seen, info, outcome.fit), &found.progress()));
    names[failed.outcome] = path;
    if (interrupt_requested()) throw Interrupted();
  }
  return names;
}

void write_reports(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found,
                   const std::optional<ExpectedFailures::Check>& known, const CertificateNames& certificates,
                   const std::string& cut_short) {
  const harness::RunInfo from{FATHOM_VERSION, certify.command_line, cut_short, found.summary().unattributed_counts(), {}, certify.fit};
  if (!certify.junit.empty())
    CertificateFile(certify.junit, "report")
        .write(harness::junit_xml(info, found.outcomes(), known.value_or(ExpectedFailures::Check()), from));
  if (!certify.html.empty())
    CertificateFile(certify.html, "report")
        .write(harness::html_page(info, found.outcomes(), shown_failures(found, certificates), certify.tolerance, from));
  found.progress().clear();
}

void write_list(const CertifyRequest& certify, const harness::SubjectInfo& info, const Collector& found, const ExpectedFailures& earlier) {
  if (!certify.write_expect_fail.empty())
    CertificateFile(certify.write_expect_fail, "list").write(harness::expected_failures_text(info, found.outcomes(), earlier));
}

std::vector<std::string> where_to_look(const CertifyRequest& certify) {
  return {certify.report.empty() ? "--report FILE holds every verdict with its numbers"
                                 : certify.report + " for every verdict with its numbers",
          certify.html.empty() ? "--html FILE shows the failures in pictures" : certify.html + " for pictures of the failures"};
}

ExitCode code_of(const CertifyRequest& certify, Collector& found, const std::optional<ExpectedFailures::Check>& known) {
  const std::size_t allowed = certify.max_errors.value_or(0);
  const harness::Summary& summary = found.summary();
  if (known)
    for (const std::string& surprise : known->surprises) talk(surprise);
  const bool as_listed = !known || known->fixed + known->changed + known->unmet == 0;
  if (!as_listed && certify.write_expect_fail.empty()) talk("--write-expect-fail " + certify.expect_fail + " brings the list up to date");
  const bool recorded = !known && !certify.write_expect_fail.empty();  // what fails was asked for, to be written down
  const std::size_t failures = known ? known->unlisted : recorded ? 0 : summary.failures();
  if (!as_listed || failures > allowed || summary.unattributed() > 0) return judged_wrong;
  if (summary.failures() + summary.passes() > 0) return fine;
  const auto was_asked = [&](const Outcome& outcome) { return !certify.replay.empty() || outcome.seconds > 0; };
  if (found.outcomes().empty()) talk("no case was judged");
  else if (std::ranges::any_of(found.outcomes(), was_asked)) talk("no case was judged: the subject declined all of them");
  else talk("no case was judged: none could be put to the subject: " + found.outcomes().front().detail);
  return incomplete;
}

}  // namespace fathom::cli
