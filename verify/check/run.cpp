// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <algorithm>
#include <fstream>
#include <istream>
#include <iterator>
#include <ostream>

#include "limits.hpp"
#include "reader.hpp"
#include "result.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

class Run {
 public:
  Run(const Options& options, const CaseFile* cases, std::ostream& out) : options_(&options), cases_(cases), out_(&out) {}

  void read(const Input& input, std::istream& stream) {
    const std::string name = input.path == "-" ? "<stdin>" : input.path;
    if (!stream) return report(unreadable("cannot be opened"), name);
    if (input.is_results) {
      read_results(stream, name);
    } else {
      read_certificates(stream, name);
    }
  }
  [[nodiscard]] int exit_code() const { return static_cast<int>(worst_); }

 private:
  static Verdict unreadable(const char* reason) {
    Verdict verdict;
    verdict.outcome = Outcome::malformed;
    verdict.reason = reason;
    return verdict;
  }

  void report(const Verdict& verdict, const std::string& name) {
    SecondChecker::Opinion said{verdict.outcome, verdict_line(verdict, name)};
    if (verdict.accepted() && options_->second) said = options_->second->opinion(verdict.id.empty() ? escaped(name) : verdict.id);
    worst_ = std::max(worst_, said.outcome);
    *out_ << said.line << '\n' << std::flush;
  }

  void read_certificates(std::istream& stream, const std::string& name) {
    Lines lines(stream, longest_line);
    Reader reader(lines);
    const Inspect inspect = [this](const Certificate& certificate) { look_at(certificate); };
    while (std::optional<Verdict> verdict = reader.next(inspect)) {
      if (lines.broken()) verdict = unreadable("cannot be read");
      report(*verdict, name);
    }
  }

  void read_results(std::istream& stream, const std::string& name) {
    Lines lines(stream, longest_json);
    bool any = false;
    while (lines.advance() != Lines::Kind::none) {
      if (lines.kind() != Lines::Kind::too_long && lines.text().find_first_not_of(" \t\r") == std::string_view::npos) continue;
      any = true;
      Result result;
      Verdict verdict = caught([&] { return judge(lines, result); }, lines.number());
      if (result.id) verdict.id = escaped(*result.id);
      report(verdict, name + ":" + std::to_string(lines.number()));
    }
    if (lines.broken()) return report(unreadable("cannot be read"), name);
    if (!any) report(unreadable("expected results, one JSON object a line, found none"), name);
  }

  Verdict judge(const Lines& lines, Result& result) {
    if (lines.kind() == Lines::Kind::too_long) throw malformed(lines.number(), "a line of more than 256 MiB, this checker's limit");
    read_result(lines.text(), lines.number(), result);
    Lines text(result.certificate, longest_line);
    Reader reader(text);
    const Verdict verdict = *reader.next([&](const Certificate& certificate) {
      compare(result, certificate);
      look_at(certificate, result.id);
    });
    const std::size_t end = text.number();
    if (verdict.outcome != Outcome::malformed && reader.next())
      throw malformed(end + 1, "expected the end after one certificate, found more");
    return verdict;
  }

  // What the user asked for besides the proof.
  void look_at(const Certificate& certificate, const std::optional<std::string>& result_id = {}) {
    if (options_->echo) echo(certificate);
    if (options_->second) options_->second->hand_over(certificate);
    if (options_->width) require_width(certificate);
    if (cases_) cases_->compare(certificate, options_->width, result_id);
  }

  void echo(const Certificate& c) {
    const auto text = [](const Rational& r) { return ratio_text(r.num.value(), r.den.value()); };
    if (!c.id.empty()) *out_ << "c id " << c.id << '\n';
    for (const auto& [name, part] : {std::pair{"a", &c.a}, std::pair{"b", &c.b}}) {
      *out_ << "c " << name << ' ' << part->items.size() << '\n';
      for (const RationalPoint& p : part->items) *out_ << "c " << text(p.x) << ' ' << text(p.y) << ' ' << text(p.z) << '\n';
    }
    *out_ << "c claim ";
    switch (c.claim) {
      case Claim::depth: *out_ << "depth " << text(c.low) << '\n'; break;
      case Claim::bounds: *out_ << "bounds " << text(c.low) << ' ' << text(c.high) << '\n'; break;
      case Claim::touching: *out_ << "touching\n"; break;
      case Claim::disjoint: *out_ << "disjoint\n"; break;
    }
  }

  const Options* options_;
  const CaseFile* cases_;
  std::ostream* out_;
  Outcome worst_ = Outcome::verified;
};

/// The user's cases, or a complaint.
std::optional<CaseFile> load_cases(const std::string& path, std::istream& standard_input, std::ostream& err) {
  const auto complain = [&](const std::string& reason) { err << "fathom-check: " << escaped(path) << ":" << reason << '\n'; };
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& stream = path == "-" ? standard_input : file;
  std::optional<CaseFile> result;
  const Verdict verdict = caught(
      [&] {
        std::string text;
        char block[1 << 16];
        while (stream.read(block, sizeof block) || stream.gcount() > 0) {
          text.append(block, static_cast<std::size_t>(stream.gcount()));
          if (text.size() > longest_json) throw malformed(0, "more than 256 MiB, this checker's limit");
        }
        if (!stream.eof()) throw malformed(0, "cannot be read");
        result.emplace(text);
        return Verdict();
      },
      0);
  if (!result) complain(std::to_string(verdict.line) + ": " + verdict.reason);
  return result;
}

}  // namespace

int run(const Options& options, std::istream& standard_input, std::ostream& out, std::ostream& err) {
  constexpr int bad_input = 2;
  std::optional<CaseFile> cases;
  if (options.cases && !(cases = load_cases(*options.cases, standard_input, err))) return bad_input;
  Run all(options, cases ? &*cases : nullptr, out);
  for (const Input& input : options.inputs) {
    if (input.path == "-") {
      all.read(input, standard_input);
    } else {
      std::ifstream file(input.path, std::ios::binary);
      all.read(input, file);
    }
  }
  if (!out) {
    err << "fathom-check: cannot write to standard output\n";
    return bad_input;
  }
  return options.inputs.empty() ? bad_input : all.exit_code();
}

}  // namespace fathom_check
