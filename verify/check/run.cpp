// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <gmp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <istream>
#include <memory>
#include <ostream>
#include <sstream>
#include <string_view>
#include <utility>

#include "checks.hpp"
#include "comparisons.hpp"
#include "limits.hpp"
#include "reader.hpp"
#include "text.hpp"

namespace fathom_check {

// What a certificate is about, to compare by eye.

namespace {

std::string text(const RationalPoint& p, bool plane = false) {
  return " " + text(p.x) + " " + text(p.y) + (plane ? "" : " " + text(p.z));
}

/// As they stand in the certificate: of the plane once, with two coordinates.
void points(std::ostream& out, const char* name, const Body& body, std::size_t first, std::size_t last, bool plane) {
  if (plane) last = first + (last - first) / body.levels;
  out << "c " << name << ' ' << last - first << '\n';
  for (std::size_t k = first; k < last; ++k) out << 'c' << text(body.points.items[k], plane) << '\n';
}

void shape(std::ostream& out, const char* name, const Body& body) {
  out << "c shape_" << name << ' ' << body.terms.size() << '\n';
  for (const Term& term : body.terms) {
    out << "c term " << term.size() << '\n';
    for (const Atom& atom : term) {
      out << "c " << (atom.size() == 1 ? "point" : atom.size() == 3 ? "disc" : "ball");
      for (const RationalPoint& vector : atom) out << text(vector);
      out << '\n';
    }
  }
}

void core(std::ostream& out, const char* name, const Body& body, bool plane) {
  switch (body.core) {
    case Body::Core::points: return points(out, name, body, 0, body.points.items.size(), plane);
    case Body::Core::shape: return shape(out, name, body);
    case Body::Core::half_space:
      out << "c halfspace_" << name << text(body.normal, plane) << ' ' << text(body.offset) << '\n';
      return;
    case Body::Core::none: return;
    case Body::Core::solid:
      points(out, (std::string("solid_") + name).c_str(), body, 0, body.points.items.size(), false);
      out << "c mesh " << body.solid.mesh.items.size() << '\n';
      for (const auto& [i, j, k] : body.solid.mesh.items) out << "c " << i << ' ' << j << ' ' << k << '\n';
      return;
    case Body::Core::pieces:
      out << "c pieces_" << name << ' ' << body.pieces.size() << '\n';
      for (std::size_t k = 0; k < body.pieces.size(); ++k)
        points(out, name, body, begin_of(body.pieces, k), body.pieces[k].end, plane);
      return;
  }
}

/// The point that these weights yield; weights of points that are not there add nothing.
std::string place(const Body& body, const std::vector<Weight>& weights, std::size_t first, std::size_t last) {
  mpq_class x, y, z;
  for (std::size_t k = first; k < last; ++k) {
    if (weights[k].index >= body.points.items.size()) continue;
    const RationalPoint& p = body.points.items[weights[k].index];
    const mpq_class weight = value(weights[k].weight);
    x += weight * value(p.x);
    y += weight * value(p.y);
    z += weight * value(p.z);
  }
  return " " + x.get_str() + " " + y.get_str() + " " + z.get_str();
}

/// The corners as points of both bodies, of which a half-space has none.
void patches(std::ostream& out, const Certificate& c) {
  const PatchParts& parts = c.of_patches;
  for (std::size_t k = 0, corner = 0; k < parts.corner_lists.size(); ++k) {
    const std::size_t last = parts.corner_lists[k].end;
    out << "c patch " << last - corner << '\n';
    for (; corner < last; ++corner) {
      const auto [end_a, end_b] = parts.corners.items[corner];
      const std::size_t begin = parts.begin_of(corner);
      out << 'c';
      if (begin < end_a) out << " a" << place(c.a, parts.weights, begin, end_a);
      if (end_a < end_b) out << " b" << place(c.b, parts.weights, end_a, end_b);
      out << '\n';
    }
  }
  for (const PatchParts::Rate& rate : parts.rates.items)
    out << "c rate" << text(rate.v) << text(rate.w) << ' ' << rate.sign.value() << ' ' << text(rate.root) << '\n';
}

void motions(std::ostream& out, const MotionParts& parts) {
  for (const auto& [name, motion] : {std::pair{"a", &parts.motions[0]}, std::pair{"b", &parts.motions[1]}}) {
    out << "c motion_" << name << '\n';
    for (const MotionParts::Quaternion& turn : motion->turns) out << "c " << text(turn.r) << text(turn.v) << '\n';
    for (const RationalPoint& place : motion->places) out << 'c' << text(place) << '\n';
  }
}

/// The id, the bodies and the claim as they were read, in lines that begin with "c ".
std::string echo(const Certificate& c) {
  std::ostringstream out;
  if (!c.id.empty()) out << "c id " << c.id << '\n';
  if (c.raising) out << "c plane " << text(c.raising->height) << '\n';
  for (const auto& [name, body] : {std::pair{"a", &c.a}, std::pair{"b", &c.b}}) {
    core(out, name, *body, c.raising.has_value());
    if (body->radius.num.sign() != 0) out << "c radius_" << name << ' ' << text(body->radius) << '\n';
  }
  if (c.format == 6) motions(out, c.of_motions);
  out << "c claim ";
  switch (c.claim) {
    case Claim::depth: out << "depth " << text(c.low) << '\n'; break;
    case Claim::bounds: out << "bounds " << text(c.low) << ' ' << text(c.high) << '\n'; break;
    case Claim::solid: out << "solid\n"; break;
    case Claim::grazing: out << "grazing\n"; break;
    case Claim::contact: out << "contact " << text(c.low) << '\n'; break;
    case Claim::touching: out << "touching\n"; break;
    case Claim::disjoint: out << "disjoint\n"; break;
    case Claim::apart: out << "apart" << (c.format == 6 ? "" : " " + text(c.low)) << '\n'; break;
    case Claim::signed_bounds: out << "signed_bounds " << text(c.low) << ' ' << text(c.high) << '\n'; break;
  }
  patches(out, c);
  return out.str();
}

// The run.

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
    return caught([reason]() -> Verdict { throw malformed(0, reason); }, 0);
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
    return judged_alone(result.certificate, [&](const Certificate& certificate) {
      compare(result, certificate);
      look_at(certificate, finding, result.id);
    });
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

// The command line.

namespace {

constexpr int usage_error = 2;

// In lines of 80 columns.
constexpr std::string_view about =
    " [OPTIONS] FILE...\n"
    "Checks certificates of how deep two bodies lie in each other, of when moving\n"
    "bodies meet, and of convex pieces that tile a mesh, exactly; - is standard\n"
    "input. The format and what acceptance proves: FORMAT.md.\n"
    "\n";
constexpr std::string_view answers =
    "\n"
    "One line per certificate: s VERIFIED, s REFUSED or s MALFORMED.\n"
    "Exit codes: 0 all were accepted, and there was one; 1 some were refused; 2 some\n"
    "were malformed, cut off or unreadable, or the input was empty, or usage. The\n"
    "largest counts.\n";

std::string help() {
  constexpr std::size_t column = 20;
  std::string text(about);
  for (const OptionText& option : option_texts) {
    std::string line = "  " + std::string(option.name) + (option.value.empty() ? "" : " ") + std::string(option.value);
    line.resize(column, ' ');
    for (const char c : option.meaning) line += c == '\n' ? "\n" + std::string(column, ' ') : std::string(1, c);
    text += line + '\n';
  }
  return text += answers;
}

// GMP would abort where memory ends; the answer "not accepted" is due instead.
[[noreturn]] void out_of_memory() {
  constexpr std::string_view text = "out of memory\n";
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) _exit(usage_error);
  _exit(usage_error);
}
void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (!memory) out_of_memory();
  return memory;
}
void* reallocate(void* old, std::size_t, std::size_t size) {
  void* const memory = std::realloc(old, size);
  if (!memory) out_of_memory();
  return memory;
}
void release(void* memory, std::size_t) { std::free(memory); }

/// What the words ask for; or a sentence on what is wrong with them, empty if help is wanted.
struct Request {
  Options options;
  bool understood = false;
  std::string sentence;
};

Request understand(const std::vector<std::string>& words) {
  Request request;
  bool only_files = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (only_files || word == "-" || word.empty() || word[0] != '-') {
      request.options.inputs.push_back({word, false});
    } else if (word == "--") {
      only_files = true;
    } else if (word == "--help" || word == "-h") {
      request.sentence.clear();
      return request;
    } else if (word == "--echo") {
      request.options.echo = true;
    } else if (word == "--width") {
      request.options.width = true;
    } else if (word != "--case" && word != "--results") {
      request.sentence = "unknown option " + shown(word);
      return request;
    } else if (++i == words.size()) {
      request.sentence = word + " expects a file";
      return request;
    } else if (word == "--results") {
      request.options.inputs.push_back({words[i], true});
    } else if (request.options.cases) {
      request.sentence = "--case is given twice";
      return request;
    } else {
      request.options.cases = words[i];
    }
  }
  request.understood = !request.options.inputs.empty();
  if (!request.understood) request.sentence = "expected certificates: files, or - for standard input";
  return request;
}

int run_words(const std::vector<std::string>& words, const std::string& program, SecondChecker* second,
              Workers* workers) {
  Request request = understand(words);
  request.options.second = second;
  request.options.workers = workers;
  if (request.understood) return run(request.options, std::cin, std::cout, std::cerr);
  if (request.sentence.empty()) {
    std::cout << "Usage: " << program << help() << std::flush;
    return std::cout ? 0 : usage_error;
  }
  std::cerr << program << ": " << request.sentence << "\nTry: " << program << " --help\n";
  return usage_error;
}

}  // namespace

int command_line(const std::vector<std::string>& words, const std::string& program, SecondChecker* second,
                 Workers* workers) noexcept {
  mp_set_memory_functions(allocate, reallocate, release);
  std::ios::sync_with_stdio(false);
  try {
    return run_words(words, program, second, workers);
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << '\n';
  } catch (...) {
    std::cerr << program << ": failed\n";
  }
  return usage_error;
}

}  // namespace fathom_check
