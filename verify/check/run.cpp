// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <algorithm>
#include <fstream>
#include <istream>
#include <memory>
#include <ostream>
#include <utility>

#include "echo.hpp"
#include "limits.hpp"
#include "reader.hpp"
#include "result.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

constexpr std::size_t long_text = std::size_t{1}
                                  << 20;    // bytes; of longer ones there shall not be many in the memory at once
constexpr std::size_t many_lines = 20'000;  // the same, of a certificate

/// What comes of a piece.
struct Finding {
  Verdict verdict;
  std::string name, echo;
};

class Run {
 public:
  Run(const Options& options, const CaseFile* cases, std::istream& standard_input, std::ostream& out)
      : options_(&options), cases_(cases), standard_input_(&standard_input), out_(&out) {}

  void run() {
    const auto next_piece = [this] { return next(); };
    if (options_->workers && !options_->second) {
      standard_input_->tie(nullptr);  // else to read would flush what another thread is printing
      return options_->workers->run(next_piece);
    }
    while (std::optional<Piece> piece = next()) {
      piece->work();
      piece->report();
    }
  }
  [[nodiscard]] int exit_code() const { return static_cast<int>(worst_); }

 private:
  /// What is open of the inputs.
  struct Source {
    Source(std::istream& stream, std::string input_name, std::size_t longest)
        : name(std::move(input_name)), lines(stream, longest), reader(lines) {}
    std::string name;
    Lines lines;
    Reader reader;                   ///< of certificates
    bool any = false, told = false;  ///< of results: whether there was one; whether the end was told of
  };

  static Verdict unreadable(const char* reason) {
    Verdict verdict;
    verdict.outcome = Outcome::malformed;
    verdict.reason = reason;
    return verdict;
  }

  std::optional<Piece> next() {
    for (; source_ || next_input_ < options_->inputs.size(); source_.reset(), ++next_input_) {
      const Input& input = options_->inputs[next_input_];
      const std::string name = input.path == "-" ? "<stdin>" : input.path;
      if (!source_) {
        std::istream& stream = open(input);
        if (!stream) return ++next_input_, known(unreadable("cannot be opened"), name);
        source_.emplace(stream, name, input.is_results ? longest_json : longest_line);
      }
      if (std::optional<Piece> piece = input.is_results ? next_result() : next_certificate()) return piece;
    }
    return std::nullopt;
  }

  std::istream& open(const Input& input) {
    if (input.path == "-") return *standard_input_;
    file_ = std::ifstream(input.path, std::ios::binary);
    return file_;
  }

  /// A piece that is done by `work`, which sets the finding; at once if it holds much memory.
  Piece piece(std::string name, bool large, std::function<void(Finding&)> work) {
    auto finding = std::make_shared<Finding>();
    finding->name = std::move(name);
    const std::function<void()> report = [this, finding] { this->report(*finding); };
    if (!large) return {[finding, work = std::move(work)] { work(*finding); }, report};
    work(*finding);
    return {[] {}, report};
  }
  Piece known(const Verdict& verdict, const std::string& name) {
    return piece(name, false, [verdict](Finding& finding) { finding.verdict = verdict; });
  }

  void report(const Finding& finding) {
    SecondChecker::Opinion said{finding.verdict.outcome, verdict_line(finding.verdict, finding.name)};
    if (finding.verdict.accepted() && options_->second)
      said = options_->second->opinion(finding.verdict.id.empty() ? escaped(finding.name) : finding.verdict.id);
    worst_ = std::max(worst_, said.outcome);
    *out_ << finding.echo << said.line << '\n' << std::flush;
  }

  std::optional<Piece> next_certificate() {
    const std::size_t before = source_->lines.number();
    auto found = std::make_shared<std::optional<Reader::Found>>(source_->reader.read());
    if (!*found) return std::nullopt;
    if (source_->lines.broken()) return known(unreadable("cannot be read"), source_->name);
    return piece(source_->name, (*found)->last_line - before > many_lines, [this, found](Finding& finding) {
      finding.verdict = judged(**found, [&](const Certificate& certificate) { look_at(certificate, finding); });
      if (!finding.verdict.accepted() && !finding.verdict.id.empty())
        finding.verdict.reason += " (in " + escaped(finding.name) + ")";
      found->reset();
    });
  }

  std::optional<Piece> next_result() {
    Lines& lines = source_->lines;
    while (lines.advance() != Lines::Kind::none) {
      if (lines.kind() != Lines::Kind::too_long && lines.text().find_first_not_of(" \t\r") == std::string_view::npos)
        continue;
      source_->any = true;
      auto text = std::make_shared<std::string>(lines.text());
      const bool too_long = lines.kind() == Lines::Kind::too_long;
      const std::size_t number = lines.number();
      return piece(source_->name + ":" + std::to_string(number), text->size() > long_text,
                   [this, text, too_long, number](Finding& finding) {
                     Result result;
                     finding.verdict = caught([&] { return judge(*text, too_long, number, result, finding); }, number);
                     if (result.id) finding.verdict.id = escaped(*result.id);
                     std::string().swap(*text);
                   });
    }
    if (std::exchange(source_->told, true)) return std::nullopt;
    if (lines.broken()) return known(unreadable("cannot be read"), source_->name);
    if (!source_->any) return known(unreadable("expected results, one JSON object a line, found none"), source_->name);
    return std::nullopt;
  }

  Verdict judge(const std::string& line, bool too_long, std::size_t number, Result& result, Finding& finding) const {
    if (too_long) throw malformed(number, "a line of more than 256 MiB, this checker's limit");
    read_result(line, number, result);
    Lines text(result.certificate, longest_line);
    Reader reader(text);
    const Verdict verdict = *reader.next([&](const Certificate& certificate) {
      compare(result, certificate);
      look_at(certificate, finding, result.id);
    });
    const std::size_t end = text.number();
    if (verdict.outcome != Outcome::malformed && reader.next())
      throw malformed(end + 1, "expected the end after one certificate, found more");
    return verdict;
  }

  // What the user asked for besides the proof.
  void look_at(const Certificate& certificate, Finding& finding,
               const std::optional<std::string>& result_id = {}) const {
    if (options_->echo) finding.echo = echo(certificate);
    if (options_->second) options_->second->hand_over(certificate);
    if (options_->width) require_width(certificate);
    if (cases_) cases_->compare(certificate, options_->width, result_id);
  }

  const Options* options_;
  const CaseFile* cases_;
  std::istream* standard_input_;
  std::ostream* out_;
  std::size_t next_input_ = 0;
  std::ifstream file_;
  std::optional<Source> source_;
  Outcome worst_ = Outcome::verified;
};

/// The user's cases, or a complaint.
std::optional<CaseFile> load_cases(const std::string& path, std::istream& standard_input, std::ostream& err) {
  const auto complain = [&](const std::string& reason) {
    err << "fathom-check: " << escaped(path) << ":" << reason << '\n';
  };
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
  Run all(options, cases ? &*cases : nullptr, standard_input, out);
  all.run();
  if (!out) {
    err << "fathom-check: cannot write to standard output\n";
    return bad_input;
  }
  return options.inputs.empty() ? bad_input : all.exit_code();
}

}  // namespace fathom_check
