// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "verify/harness/report/reports.hpp"

namespace fathom::harness {
namespace {

constexpr std::string_view blanks = " \t";

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool stands_unescaped(char c) { return static_cast<unsigned char>(c) > 0x20 && c != 0x7f && c != '%' && c != '~'; }

std::string escaped(std::string_view text) {
  if (text.empty()) return "%";
  std::string result;
  for (const char c : text)
    result += stands_unescaped(c) && !(c == '#' && result.empty())
                  ? std::string(1, c)
                  : fmt::format("%{:02x}", static_cast<unsigned char>(c));
  return result;
}

/// Returns nullopt if a '%' is not followed by two digits, or if the text has a character that must
/// be escaped.
std::optional<std::string> unescaped(std::string_view text) {
  if (text == "%") return "";
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (stands_unescaped(text[i])) {
      result += text[i];
      continue;
    }
    if (text[i] != '%' || i + 2 >= text.size()) return std::nullopt;
    const int high = hex_value(text[i + 1]), low = hex_value(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    result += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return result;
}

std::string key_of(std::string_view id, std::string_view variant) {
  return variant.empty() ? escaped(id) : fmt::format("{}~{}", escaped(id), escaped(variant));
}

/// Returns the key in canonical escaping, however a user escaped it, or nullopt if it is not a key.
std::optional<std::string> canonical_key(std::string_view text) {
  const std::size_t tilde = text.find('~');
  const auto id = unescaped(text.substr(0, tilde));
  if (tilde == std::string_view::npos) return id ? std::optional(key_of(*id, "")) : std::nullopt;
  const auto variant = unescaped(text.substr(tilde + 1));
  if (!id || !variant) return std::nullopt;
  return key_of(*id, *variant);
}

/// Removes the next word from the front of the text and returns it; empty at the end and before a
/// comment.
std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  if (text.starts_with('#')) text = {};
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

/// Returns the lines without their ends, "\n" or "\r\n".
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
  }
  return lines;
}

constexpr std::string_view opening = "# Known failures of ", purpose = ", for fathom certify --expect-fail.";

/// Returns whether the line is the comment that fathom writes above a list.
bool is_opening(std::string_view line) {
  return line.starts_with(opening) && line.find(purpose) != std::string_view::npos;
}

struct Suite {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
  double seconds = 0;
  std::string cases;  // the elements written so far

  void add(const Suite& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    skipped += other.skipped;
    seconds += other.seconds;
  }
};

std::string attribute(std::string_view name, std::string_view value) {
  return fmt::format(" {}=\"{}\"", name, markup(value));
}

std::string counts(const Suite& suite) {
  return fmt::format(" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.6f}\"", suite.tests,
                     suite.failures, suite.errors, suite.skipped, suite.seconds);
}

bool is_error(Verdict verdict) { return verdict <= Verdict::failed; }

/// Returns the child element of a test case, and counts it; empty for a pass.
std::string child_of(const Outcome& outcome, const ExpectedFailures::Check& known, Suite& suite) {
  const std::string verdict(name(outcome.verdict)), sentence = sentence_of(outcome);
  if (known.allowed.contains(failure_line(outcome)))
    return ++suite.skipped,
           fmt::format("<skipped{}/>", attribute("message", fmt::format("known failure: {}: {}", verdict, sentence)));
  if (outcome.verdict == Verdict::unsupported)
    return ++suite.skipped, fmt::format("<skipped{}/>", attribute("message", sentence));
  if (fails(outcome.verdict)) {
    const char* element = is_error(outcome.verdict) ? "error" : "failure";
    ++(is_error(outcome.verdict) ? suite.errors : suite.failures);
    return fmt::format("<{0}{1}{2}>{3}</{0}>", element, attribute("message", sentence), attribute("type", verdict),
                       markup(sentence));
  }
  if (known.fixed_keys.contains(failure_key(outcome)))
    return ++suite.failures, R"(<failure message="listed as a known failure, but passes" type="unexpected-pass"/>)";
  return "";
}

void add_case(Suite& suite, const std::string& class_name, const std::string& case_name, double seconds,
              const std::string& child) {
  ++suite.tests;
  suite.seconds += seconds;
  suite.cases += fmt::format("    <testcase{}{} time=\"{:.6f}\"{}\n", attribute("classname", class_name),
                             attribute("name", case_name), seconds, child.empty() ? "/>" : ">" + child + "</testcase>");
}

std::string properties(const SubjectInfo& subject, const RunInfo& from) {
  std::string result = "    <properties>\n";
  const auto add = [&](const std::string& name, const std::string& value) {
    result += fmt::format("      <property{}{}/>\n", attribute("name", name), attribute("value", value));
  };
  for (const auto& [name, value] :
       {std::pair("fathom", &from.version), {"command", &from.command}, {"cut short", &from.cut_short}})
    if (!value->empty()) add(name, *value);
  add("subject", title(subject));
  add("conventions", conventions_text(subject.conventions));
  for (const auto& [name, value] : subject.settings) add("setting." + name, value);
  if (from.fit) add("fit", exact_text(*from.fit));
  return result + "    </properties>\n";
}

std::string suite_xml(const std::string& name, const Suite& suite, const std::string& properties) {
  return fmt::format("  <testsuite{}{}>\n{}{}  </testsuite>\n", attribute("name", name), counts(suite), properties,
                     suite.cases);
}

}  // namespace

std::string failure_key(const Outcome& outcome) { return key_of(outcome.id, outcome.variant); }
std::string failure_line(const Outcome& outcome) {
  return fmt::format("{} {}", name(outcome.verdict), failure_key(outcome));
}

ExpectedFailures ExpectedFailures::read(const std::string& path) { return parse(files::read_file(path), path); }

std::string ExpectedFailures::Entry::text() const { return fmt::format("{} {}", fathom::name(verdict), key); }

std::optional<ExpectedFailures::Entry> ExpectedFailures::entry_in(std::string_view words, const std::string& name,
                                                                  std::size_t line) {
  const std::string_view first = next_word(words);
  if (first.empty()) return std::nullopt;
  const std::optional<Verdict> verdict = verdict_named(first);
  if (!verdict)
    throw InputError(name, line, "expected a verdict, as in 'too-deep case-7', found " + kernels::shown(first));
  if (!fails(*verdict)) throw InputError(name, line, kernels::shown(first) + " is no failure");
  const std::string_view second = next_word(words);
  if (second.empty()) throw InputError(name, line, "expected the id of a case after " + kernels::shown(first));
  const std::optional<std::string> key = canonical_key(second);
  if (!key)
    throw InputError(name, line,
                     "expected an id in which '%' begins an escape such as %20, found " + kernels::shown(second));
  if (const std::string_view more = next_word(words); !more.empty())
    throw InputError(
        name, line,
        "expected nothing but a comment after the id, found " + kernels::shown(more) + "; a blank in an id is %20");
  return Entry{*verdict, *key, line};
}

ExpectedFailures ExpectedFailures::parse(const std::string& text, const std::string& name) {
  ExpectedFailures result;
  result.name_ = name;
  result.text_ = text;
  std::size_t number = 0;
  for (const std::string_view line : lines_of(text))
    if (std::optional<Entry> entry = entry_in(line, name, ++number)) result.entries_.push_back(*std::move(entry));
  return result;
}

ExpectedFailures::Check ExpectedFailures::check(std::span<const Outcome> outcomes) const {
  struct Met {
    std::vector<Entry> listed;
    std::vector<Verdict> got;
  };
  std::map<std::string, Met> cases;
  for (const Entry& entry : entries_) cases[entry.key].listed.push_back(entry);
  for (const Outcome& outcome : outcomes) cases[failure_key(outcome)].got.push_back(outcome.verdict);

  Check result;
  for (auto& [key, met] : cases) {
    std::ranges::sort(met.got);  // failures first: a listed one is matched with a failure before a pass
    std::erase_if(met.listed, [&result, &got = met.got](const Entry& entry) {
      const auto same = std::ranges::find(got, entry.verdict);
      if (same == got.end()) return false;
      result.allowed.insert(entry.text());
      got.erase(same);
      return true;
    });
    settle(key, met.listed, met.got, result);
  }
  return result;
}

void ExpectedFailures::settle(const std::string& key, const std::vector<Entry>& listed, const std::vector<Verdict>& got,
                              Check& result) const {
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const std::string place =
        fmt::format("{}:{}: {} is listed as {}", name_, listed[i].line, key, fathom::name(listed[i].verdict));
    if (i >= got.size()) {
      ++result.unmet;
      result.unmet_lines.push_back(listed[i].text());
      result.surprises.push_back(place + ", but no such case was run");
    } else if (passes(got[i])) {
      ++result.fixed;
      result.fixed_keys.insert(key);
      result.surprises.push_back(place + ", but passes now: strike it off the list");
    } else {
      ++result.changed;
      result.surprises.push_back(fmt::format("{}, but is {} now", place, fathom::name(got[i])));
    }
  }
  for (std::size_t i = listed.size(); i < got.size(); ++i) {
    if (!fails(got[i])) continue;
    ++result.unlisted;
    result.surprises.push_back(fmt::format("{} is {}, and is not listed", key, fathom::name(got[i])));
  }
}

std::string ExpectedFailures::renewed(std::multiset<std::string>& failing) const {
  std::string result;
  std::size_t number = 0;
  auto entry = entries_.begin();
  for (const std::string_view line : lines_of(text_)) {
    if (++number == 1 && is_opening(line)) continue;
    if (entry != entries_.end() && entry->line == number) {
      const auto found = failing.find((entry++)->text());
      if (found == failing.end()) continue;
      failing.erase(found);
    }
    result.append(line) += '\n';
  }
  return result;
}

std::string expected_failures_text(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                                   const ExpectedFailures& before) {
  std::multiset<std::string> failing;
  for (const Outcome& outcome : outcomes)
    if (fails(outcome.verdict)) failing.insert(failure_line(outcome));
  std::string result =
      fmt::format("{}{}{} A line: verdict, id, perhaps a comment.\n", opening, ascii(title(subject)), purpose);
  result += before.renewed(failing);
  for (const std::string& line : failing) result += line + "\n";
  return result;
}

std::string junit_xml(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      const ExpectedFailures::Check& known, const RunInfo& from) {
  std::map<std::string, Suite> suites;
  for (const Outcome& outcome : outcomes) {
    const std::string family = family_of(outcome.id);
    Suite& suite = suites[family];
    const std::string child = child_of(outcome, known, suite);
    add_case(suite, family.empty() ? subject.name : subject.name + "." + family, shown_id(outcome.id, outcome.variant),
             outcome.seconds, child);
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
    add_case(unmet, subject.name, line, 0,
             R"(<failure message="listed as a known failure, but no such case was run" type="not-met"/>)");
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
