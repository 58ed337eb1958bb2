// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/certify_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "cli/args/named_files.hpp"
#include "cli/args/parser_words.hpp"
#include "cli/args/second_method.hpp"
#include "cli/args/threads.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/policy.hpp"

namespace fathom::cli {
namespace {

/// Numbers on the command line are meant as typed: decimals are exact.
std::optional<mpq_class> exact_number(const std::string& text) { return parse_number(text, Decimals::exact).value; }

template <class Count>
std::optional<Count> typed_count(const std::string& text) {
  Count count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(count) : std::nullopt;
}

CLI::Validator rule(bool (*holds)(const std::string&), std::string expected) {
  return {[=](const std::string& text) { return holds(text) ? "" : fmt::format("expected {}, found {}", expected, kernels::shown(text)); },
          "", ""};
}

/// One policy of each kind: "within=5%".
std::vector<std::string> policy_words() {
  std::vector<std::string> words;
  for (const auto kind : judging::policy_kinds) words.push_back(judging::policy_text({kind, mpq_class(1, 20)}));
  return words;
}

bool is_time(const std::string& text) {
  const auto time = exact_number(text);
  return time && *time > 0;
}
bool is_size(const std::string& text) {
  const auto size = exact_number(text);
  return size && *size > 0;
}
bool is_tolerance(const std::string& text) {
  const auto value = exact_number(text);
  return value && *value >= 0;
}
std::string check_policy(const std::string& text) {
  if (judging::policy_of(text)) return "";
  return fmt::format("expected declared, minimum, separating or within=P%, such as within=5%, found {}", kernels::shown(text));
}
bool is_count(const std::string& text) { return typed_count<std::size_t>(text).has_value(); }

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    words.push_back(list.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return words;
}

std::vector<std::string> all_variants() { return {std::begin(harness::variant_names), std::end(harness::variant_names)}; }

/// Sets the variants. Returns what is wrong with the list, or "".
std::string wrong_variants(CertifyRequest& certify) {
  if (certify.metamorphic.empty()) return "";
  const std::vector<std::string> all = all_variants();
  certify.variants = certify.metamorphic == "all" ? all : words_of(certify.metamorphic);
  for (const std::string& word : certify.variants)
    if (std::find(all.begin(), all.end(), word) == all.end())
      return fmt::format("--metamorphic: {} is unknown (expected {}, with commas between them)", kernels::shown(word),
                         fmt::join(all, ", "));
  return "";
}

CLI::Option* add_text(CLI::App& app, const char* name, std::string& text, const char* meaning, const char* type) {
  return app.add_option(name, text, meaning)->type_name(type);
}

void add_path(CLI::App& app, const char* name, std::string& path, const char* meaning, FileUse use) {
  names_file(add_text(app, name, path, meaning, use == FileUse::folder ? "DIR" : "FILE"), use);
}

void add_subject(CLI::App& app, CertifyRequest& certify) {
  add_text(app, "--subject", certify.subject, "a program that speaks the protocol of verify/PROTOCOL.md, as a shell command", "COMMAND");
  add_text(app, "--adapter", certify.adapter,
           "a library by the name that --list-adapters shows; its settings may follow: libccd-epa,epa_tolerance=1e-12", "NAME");
  add_path(app, "--replay", certify.replay, "replies that were recorded: an optional hello, then one a line; - for standard input",
           FileUse::read);
  add_path(app, "--claims", certify.claims,
           "judge what others have published about pairs of bodies, without a subject: one JSON object a line; - for standard input",
           FileUse::read);
  app.add_flag("--list-adapters", certify.list_adapters, "the names for --adapter, and whether each is built");
  app.add_option_function<std::string>(
         "--jobs", [&certify](const std::string& text) { certify.jobs = threads_of(text); },
         "subjects at once; as many as there are processors unless given")
      ->check(check_threads)
      ->type_name("N");
  app.add_option_function<std::string>(
         "--time-out", [&certify](const std::string& text) { certify.time_out = round_binary64(*exact_number(text), Rounding::ru); },
         "seconds that a case may take; 10 unless given")
      ->check(rule(is_time, "a number of seconds above 0"))
      ->type_name("S");
}

void add_tolerance(CLI::App& app, const char* name, mpq_class& value, const char* meaning) {
  app.add_option_function<std::string>(
         name, [&value](const std::string& text) { value = *exact_number(text); }, meaning)
      ->check(rule(is_tolerance, "a number of at least 0, such as 1e-6 or 1/1000"))
      ->type_name("Q");
}

template <class Count>
void add_count(CLI::App& app, const char* name, Count& count, const char* meaning) {
  app.add_option_function<std::string>(
         name, [&count](const std::string& text) { count = *typed_count<std::size_t>(text); }, meaning)
      ->check(rule(is_count, "a number of at least 0"))
      ->type_name("N");
}

void add_reports(CLI::App& app, Request& request) {
  CertifyRequest& certify = request.certify;
  add_path(app, "--report", certify.report, "write each verdict as it is found, schema fathom/verdict/1", FileUse::journal);
  app.add_flag("--resume", certify.resume, "go on with the report that is there: what it holds is not run again");
  app.add_flag("--overwrite", certify.overwrite, "replace the report that is there");
  app.add_flag("--all-rows", certify.all_rows, "in the table, a row for each family; else those that pass share one");
  app.add_flag("--json", request.json, "the same lines on standard output, instead of the table");
  app.add_flag("--metamorphic{all}", certify.metamorphic,
               fmt::format("each case also under symmetries, any of {} with commas between them; all without a list",
                           fmt::join(all_variants(), ", ")))
      ->type_name("[=LIST]");
  add_path(app, "--expect-fail", certify.expect_fail, "known failures: a run that differs from the list in any way fails",
           FileUse::read_list);
  add_path(app, "--write-expect-fail", certify.write_expect_fail, "write such a list; comments of one that is there stay",
           FileUse::written_list);
  add_count(app, "--max-errors", certify.max_errors, "exit code 0 as long as no more cases fail");
  add_path(app, "--junit", certify.junit, "write JUnit XML", FileUse::written);
  add_path(app, "--html", certify.html, "write one page with tables, histograms and pictures of failures", FileUse::written);
  add_path(app, "--certificates", certify.certificates, "write the proof of the truth about each failing case", FileUse::folder);
  add_path(app, "--shrink", certify.shrink, "reduce one failing case of each verdict to a small one", FileUse::folder);
  add_path(app, "--harness", certify.harness,
           "with --shrink, your own program with @A@ and @B@ where the bodies go, as {{x, y, z}, ...}, or @A_JSON@ and @B_JSON@",
           FileUse::read);
  add_text(app, "--print-input", certify.print_input, "print what the subject reads for the case of this id, and ask nothing", "ID");
}

}  // namespace

void add_certify_options(CLI::App& app, Request& request) {
  CertifyRequest& certify = request.certify;
  add_subject(app, certify);
  add_tolerance(app, "--tol-rel", certify.tolerance.relative, "a depth may be wrong by Q times itself; 1/1000 unless given,");
  add_tolerance(app, "--tol-abs", certify.tolerance.absolute, "or by Q times the longest side of the bodies; 1/1000000 unless given,");
  add_count(app, "--tol-ulps", certify.tolerance.ulps, "or by N units in the last place; 0 unless given: the largest of the three");
  app.add_option_function<std::string>(
         "--fit", [&certify](const std::string& text) { certify.fit = exact_number(text); },
         "put each case to the subject scaled by a power of two, so that the longest side of its bodies is less than N and at least N/2")
      ->check(rule(is_size, "a number above 0, such as 64"))
      ->type_name("N");
  app.add_option_function<std::string>(
         "--policy", [&certify](const std::string& text) { certify.tolerance.policy = *judging::policy_of(text); },
         "which depths pass that are the price of their own direction, though a shorter way out exists: as the subject's hello claims "
         "(declared, unless given), none (minimum), all (separating), or up to P % above the depth (within=P%)")
      ->check(one_of(policy_words(), check_policy))
      ->type_name("POLICY");
  add_second_method(app, certify.methods,
                    "find every truth again by exact (AGHRS's pipeline) or naive (the hull of all vertex differences), and compare it, and "
                    "every judgement, field by field; may be repeated");
  add_reports(app, request);
}

std::string wrong_certify(CertifyRequest& certify, const std::vector<std::string>& inputs) {
  const auto given = [](const std::string& text) { return text.empty() ? 0U : 1U; };
  const std::size_t subjects = given(certify.subject) + given(certify.adapter) + given(certify.replay);
  if (certify.list_adapters)
    return subjects + inputs.size() == 0 ? "" : "--list-adapters only prints a list, and takes no subject and no cases";
  if (!certify.claims.empty()) return subjects + inputs.size() == 0 ? "" : "--claims judges a file, and takes no subject and no cases";
  if (subjects != 1) return fmt::format("certify expects one of --subject, --adapter and --replay, found {} of them", subjects);
  if (inputs.size() != 1)
    return fmt::format("certify expects one stream of cases (a JSON Lines file, or - for standard input), found {} argument{}",
                       inputs.size(), inputs.size() == 1 ? "" : "s");
  if (certify.resume && certify.report.empty()) return "--resume goes on with a report, and needs --report";
  if (certify.overwrite && certify.report.empty()) return "--overwrite replaces a report, and needs --report";
  if (certify.overwrite && certify.resume) return "--resume goes on with the report that --overwrite replaces: one of them";
  if (!certify.harness.empty() && certify.shrink.empty()) return "--harness is filled with what --shrink finds, and needs --shrink";
  if (!certify.print_input.empty() && !certify.replay.empty())
    return "--print-input shows what a subject reads, and a replay reads nothing";
  if (certify.replay == "-" && inputs[0] == "-") return "--replay - and the cases cannot both come from standard input";
  if (certify.report == "-") return "--report writes a file; --json writes to standard output";
  if (!certify.replay.empty() && !certify.metamorphic.empty())
    return "--metamorphic puts new cases to a subject, and a replay answers none";
  if (!certify.replay.empty() && !certify.shrink.empty()) return "--shrink puts new cases to a subject, and a replay answers none";
  return wrong_variants(certify);
}

}  // namespace fathom::cli
