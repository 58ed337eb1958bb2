// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/report/junit.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

#include "fathom/numbers.hpp"
#include "verify/harness/report/text.hpp"

namespace fathom::harness {
namespace {

struct Suite {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
  double seconds = 0;
  std::string cases;  // written

  void add(const Suite& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    skipped += other.skipped;
    seconds += other.seconds;
  }
};

std::string attribute(std::string_view name, std::string_view value) { return fmt::format(" {}=\"{}\"", name, markup(value)); }

std::string counts(const Suite& suite) {
  return fmt::format(" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.6f}\"", suite.tests, suite.failures,
                     suite.errors, suite.skipped, suite.seconds);
}

bool is_error(Verdict verdict) { return verdict <= Verdict::failed; }

/// The child of a test case, counted; empty for a pass.
std::string child_of(const Outcome& outcome, const ExpectedFailures::Check& known, Suite& suite) {
  const std::string verdict(name(outcome.verdict)), sentence = sentence_of(outcome);
  if (known.allowed.contains(failure_line(outcome)))
    return ++suite.skipped, fmt::format("<skipped{}/>", attribute("message", fmt::format("known failure: {}: {}", verdict, sentence)));
  if (outcome.verdict == Verdict::unsupported) return ++suite.skipped, fmt::format("<skipped{}/>", attribute("message", sentence));
  if (fails(outcome.verdict)) {
    const char* element = is_error(outcome.verdict) ? "error" : "failure";
    ++(is_error(outcome.verdict) ? suite.errors : suite.failures);
    return fmt::format("<{0}{1}{2}>{3}</{0}>", element, attribute("message", sentence), attribute("type", verdict), markup(sentence));
  }
  if (known.fixed_keys.contains(failure_key(outcome)))
    return ++suite.failures, R"(<failure message="listed as a known failure, but passes" type="unexpected-pass"/>)";
  return "";
}

void add_case(Suite& suite, const std::string& class_name, const std::string& case_name, double seconds, const std::string& child) {
  ++suite.tests;
  suite.seconds += seconds;
  suite.cases += fmt::format("    <testcase{}{} time=\"{:.6f}\"{}\n", attribute("classname", class_name), attribute("name", case_name),
                             seconds, child.empty() ? "/>" : ">" + child + "</testcase>");
}

std::string properties(const SubjectInfo& subject, const RunInfo& from) {
  std::string result = "    <properties>\n";
  const auto add = [&](const std::string& name, const std::string& value) {
    result += fmt::format("      <property{}{}/>\n", attribute("name", name), attribute("value", value));
  };
  for (const auto& [name, value] : {std::pair("fathom", &from.version), {"command", &from.command}, {"cut short", &from.cut_short}})
    if (!value->empty()) add(name, *value);
  add("subject", title(subject));
  add("conventions", conventions_text(subject.conventions));
  for (const auto& [name, value] : subject.settings) add("setting." + name, value);
  if (from.fit) add("fit", exact_text(*from.fit));
  return result + "    </properties>\n";
}

std::string suite_xml(const std::string& name, const Suite& suite, const std::string& properties) {
  return fmt::format("  <testsuite{}{}>\n{}{}  </testsuite>\n", attribute("name", name), counts(suite), properties, suite.cases);
}

}  // namespace

std::string junit_xml(const SubjectInfo& subject, std::span<const Outcome> outcomes, const ExpectedFailures::Check& known,
                      const RunInfo& from) {
  std::map<std::string, Suite> suites;
  for (const Outcome& outcome : outcomes) {
    const std::string family = family_of(outcome.id);
    Suite& suite = suites[family];
    const std::string child = child_of(outcome, known, suite);
    add_case(suite, family.empty() ? subject.name : subject.name + "." + family, shown_id(outcome.id, outcome.variant), outcome.seconds,
             child);
  }
  Suite all, unmet;
  const std::string common = properties(subject, from);
  std::string body;
  for (const auto& [family, suite] : suites) {
    all.add(suite);
    body += suite_xml(family.empty() ? subject.name : subject.name + "." + family, suite, common);
  }
  for (const std::string& line : known.unmet_lines) {
    ++unmet.failures;
    add_case(unmet, subject.name, line, 0, R"(<failure message="listed as a known failure, but no such case was run" type="not-met"/>)");
  }
  all.add(unmet);
  if (unmet.tests > 0) body += suite_xml("known failures", unmet, common);
  Suite nobodys;
  for (const auto& [detail, count] : from.unattributed) {
    ++nobodys.errors;
    const std::string message = fmt::format("{} x {}", count, detail);
    add_case(nobodys, subject.name, message, 0,
             fmt::format("<error{}{}/>", attribute("message", message), attribute("type", "unattributed")));
  }
  all.add(nobodys);
  if (nobodys.tests > 0) body += suite_xml("unattributed", nobodys, common);
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites{}{}>\n{}</testsuites>\n",
                     attribute("name", "fathom certify " + title(subject)), counts(all), body);
}

}  // namespace fathom::harness
