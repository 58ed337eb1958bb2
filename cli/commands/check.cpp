// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the independent checkers, which have a parser and a command line of their own. With
// --proved, the checker that was extracted from the Coq development runs after the C++ checker: it
// gets each certificate as that one parsed it and compared it with the user's cases and results,
// and must accept it too.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/help.hpp"
#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "kernels/messages.hpp"
#include "verify/check/run.hpp"
#include "verify/harness/process.hpp"

namespace fathom::cli {
namespace {

inline constexpr const char* proved_program = "fathom-check-proved";

/// Returns the message that the program is missing, with the command that builds it.
std::string proved_program_is_missing() {
  return std::string(proved_program) +
         " is not here: it is built from proofs/coq, with Coq and OCaml (Debian: coq, libzarith-ocaml-dev, "
         "ocaml-findlib)";
}

class ProvedChecker : public fathom_check::SecondChecker {
 public:
  /// `width`: accepts only certificates about the width of a body.
  explicit ProvedChecker(bool width) : width_(width) {}

  void hand_over(const fathom_check::Certificate& certificate) override;
  /// Throws std::runtime_error if the program is missing or dies; failed() is true from then on.
  Opinion opinion(const std::string& name) override;
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  [[nodiscard]] std::string answer(const std::string& name);
  [[nodiscard]] std::runtime_error failure(const std::string& what);

  bool width_;
  std::unique_ptr<harness::Process> process_;
  int format_ = 1;
  std::string text_;  ///< the certificate, from its points on
  std::size_t claim_line_ = 0;
  bool failed_ = false;
};

using fathom_check::Body;
using fathom_check::Certificate;
using fathom_check::Claim;
using fathom_check::RationalPoint;

/// Writes certificates in the syntax of FORMAT.md, section 2, line by line.
class Text {
 public:
  template <class... Fields>
  void line(const Fields&... fields) {
    const char* gap = "";
    ((result_ += gap, add(fields), gap = " "), ...);
    result_ += '\n';
  }
  template <class Items, class Line>
  void part(const std::string& name, const Items& items, const Line& row, const char* more = "") {
    announce(name, items.size(), more);
    for (const auto& item : items) row(item);
  }
  void row(const std::vector<fathom_check::Place>& places) {
    const char* gap = "";
    for (const fathom_check::Place& place : places) {
      result_ += gap;
      add(std::size_t{place.atom});
      result_ += ' ';
      add(place.y);
      gap = " ";
    }
    result_ += '\n';
  }
  /// Writes the facets `first` to `last`.
  void facets(const fathom_check::Facets& facets, std::size_t first, std::size_t last, const char* name = "facets") {
    announce(name, last - first, "");
    for (std::size_t f = first; f < last; ++f) {
      add(facets.ends[f] - facets.begin_of(f));
      for (std::size_t k = facets.begin_of(f); k < facets.ends[f]; ++k) {
        result_ += ' ';
        add(std::size_t{facets.corners[k]});
      }
      result_ += '\n';
    }
  }
  void tree(const fathom_check::Nodes& nodes) {
    announce("tree", nodes.size(), "");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      result_ += nodes.splits[k] ? "split" : "leaf";
      for (std::size_t i = nodes.begin_of(k); i < nodes.ends[k]; ++i) result_ += ' ' + std::to_string(nodes.indices[i]);
      result_ += '\n';
    }
  }
  /// Writes the weights of a corner: two lists on one line, between these ends.
  void weights(const std::vector<fathom_check::Weight>& weights, const std::array<std::size_t, 3>& ends) {
    for (const std::size_t list : {0, 1}) {
      result_ += (list == 0 ? "" : " ") + std::to_string(ends[list + 1] - ends[list]);
      for (std::size_t k = ends[list]; k < ends[list + 1]; ++k) {
        result_ += ' ' + std::to_string(weights[k].index) + ' ';
        add(weights[k].weight);
      }
    }
    result_ += '\n';
  }
  /// Writes the items `first` to `last`.
  template <class Items, class Line>
  void range(const std::string& name, const Items& items, std::size_t first, std::size_t last, const Line& row) {
    announce(name, last - first, "");
    for (std::size_t k = first; k < last; ++k) row(items[k]);
  }
  void announce_two(const char* name, std::size_t count, std::size_t other) {
    line(name, count, other);
    counts_.insert(counts_.end(), {count, other});
  }
  /// Returns the text with its footer, which repeats all counts.
  std::string ended(int format) && {
    constexpr std::size_t of_format_1 = 5;
    if (format == 1) counts_.resize(of_format_1);
    result_ += "end";
    for (const std::size_t count : counts_) result_ += ' ' + std::to_string(count);
    return std::move(result_) + '\n';
  }

 private:
  void announce(const std::string& name, std::size_t count, const char* more) {
    line(name, count);
    result_.insert(result_.size() - 1, more);
    counts_.push_back(count);
  }

  void add(const char* word) { result_ += word; }
  void add(const std::string& word) { result_ += word; }
  void add(const fathom_check::Integer& n) { result_ += n.value().get_str(); }
  void add(std::size_t n) { result_ += std::to_string(n); }
  void add(const fathom_check::Rational& r) { result_ += r.num.value().get_str() + '/' + r.den.value().get_str(); }
  void add(const RationalPoint& p) {
    add(p.x);
    result_ += ' ';
    add(p.y);
    result_ += ' ';
    add(p.z);
  }

  std::string result_;
  std::vector<std::size_t> counts_;
};

void write_claim(Text& text, const Certificate& c) {
  switch (c.claim) {
    case Claim::depth: return text.line("claim depth", c.low);
    case Claim::bounds: return text.line("claim bounds", c.low, c.high);
    case Claim::touching: return text.line("claim touching");
    case Claim::disjoint: return text.line("claim disjoint");
    case Claim::apart: return c.format == 6 ? text.line("claim apart") : text.line("claim apart", c.low);
    case Claim::grazing: return text.line("claim grazing");
    case Claim::contact: return text.line("claim contact", c.low);
    case Claim::signed_bounds: return text.line("claim signed_bounds", c.low, c.high);
    case Claim::solid: return text.line("claim solid");
  }
}

/// Writes the body, of the plane if `plane`, as it stands in the certificate.
void write_body(Text& text, const Body& body, const char* name, bool plane) {
  const auto point = [&](const RationalPoint& p) {
    if (plane) text.line(p.x, p.y);
    else text.line(p);
  };
  const auto atom = [&](const fathom_check::Atom& a) {
    if (a.size() == 1) text.line("point", a[0]);
    if (a.size() == 3) text.line("disc", a[0], a[1], a[2]);
    if (a.size() == 4) text.line("ball", a[0], a[1], a[2], a[3]);
  };
  switch (body.core) {
    case Body::Core::points:
      text.range(name, body.points.items, 0, body.points.items.size() / body.levels, point);
      break;
    case Body::Core::shape:
      text.part(std::string("shape_") + name, body.terms, [&](const auto& term) { text.part("term", term, atom); });
      break;
    case Body::Core::half_space:
      if (plane) text.line(std::string("halfspace_") + name, body.normal.x, body.normal.y, body.offset);
      else text.line(std::string("halfspace_") + name, body.normal, body.offset);
      break;
    case Body::Core::pieces: {
      std::size_t first = 0;
      text.part(std::string("pieces_") + name, body.pieces, [&](const fathom_check::List& piece) {
        text.range(name, body.points.items, first, first + (piece.end - first) / body.levels, point);
        first = piece.end;
      });
      break;
    }
    case Body::Core::solid: {
      text.part(std::string("solid_") + name, body.points.items, point);
      text.part("mesh", body.solid.mesh.items, [&](const fathom_check::SolidParts::Triangle& t) {
        text.line(std::size_t{t[0]}, std::size_t{t[1]}, std::size_t{t[2]});
      });
      std::size_t first = 0;
      text.part("pieces", body.solid.pieces, [&](const fathom_check::List& piece) {
        text.facets(body.solid.facets.items, first, piece.end, "piece");
        first = piece.end;
      });
      break;
    }
    case Body::Core::none: break;
  }
  if (body.radius.num.sign() != 0) text.line(std::string("radius_") + name, body.radius);
}

void write_proof_of_body(Text& text, const Body& body, const char* name, bool heights) {
  if (body.core != Body::Core::shape) return;
  if (heights)
    return text.part(std::string("heights_") + name, body.heights.items,
                     [&](const auto& height) { text.line(height); });
  std::vector<std::vector<fathom_check::Place>> points;
  for (std::size_t k = 0; k < body.inner.items.size(); ++k) {
    if (k % body.terms.size() == 0) points.emplace_back();
    points.back().push_back(body.inner.items[k]);
  }
  text.part(std::string("inner_") + name, points, [&](const auto& places) { text.row(places); });
}

void write_weights(Text& text, const std::vector<fathom_check::Weight>& a, const std::vector<fathom_check::Weight>& b) {
  const auto weight = [&](const fathom_check::Weight& w) { text.line(std::size_t{w.index}, w.weight); };
  text.part("weights_a", a, weight);
  text.part("weights_b", b, weight);
}

/// Writes the lines after the claim.
void write_proof_of_unions(Text& text, const Certificate& c) {
  const fathom_check::UnionParts& parts = c.of_unions;
  const auto vector = [&](const fathom_check::Vector& n) { text.line(n.x, n.y, n.z); };
  const auto pair = [&](const fathom_check::Pair& v) { text.line(std::size_t{v.j}, std::size_t{v.i}); };
  const auto separations = [&](std::size_t list) {
    const std::size_t first = fathom_check::begin_of(parts.separation_lists, list);
    text.range("separations", parts.separations.items, first, parts.separation_lists[list].end, vector);
  };
  if (c.claim != Claim::depth) {
    separations(0);
    text.line("nearest", std::size_t{parts.nearest_a}, std::size_t{parts.nearest_b});
    write_weights(text, c.weights_a.items, c.weights_b.items);
    return;
  }
  std::size_t list = 0, vertex = 0, facet = 0;
  text.part("optima", parts.optima.items, [&](const RationalPoint& t) {
    text.line("optimum", t);
    separations(list++);
  });
  text.part("polytopes", parts.polytopes, [&](const fathom_check::InnerPolytope& polytope) {
    text.line("polytope", std::size_t{polytope.i}, std::size_t{polytope.j});
    text.range("vertices", c.vertices.items, vertex, polytope.vertices.end, pair);
    text.facets(c.facets.items, facet, polytope.facets.end);
    vertex = polytope.vertices.end;
    facet = polytope.facets.end;
  });
  text.tree(parts.tree.items);
}

/// Writes the patches and rates of format 4.
void write_patches(Text& text, const fathom_check::PatchParts& parts) {
  const auto sides = [&](const fathom_check::PatchParts::Side& side) {
    text.line(side.of_b ? "b" : "a", side.inward.x, side.inward.y, side.inward.z, std::size_t{side.corner});
  };
  std::size_t patch = 0, corner = 0, side = 0;
  text.part("patches", parts.corner_lists, [&](const fathom_check::List& corners) {
    const std::size_t end_of_sides = parts.side_lists[patch++].end;
    text.announce_two("patch", corners.end - corner, end_of_sides - side);
    for (; corner < corners.end; ++corner) {
      const auto [end_a, end_b] = parts.corners.items[corner];
      text.weights(parts.weights, {parts.begin_of(corner), end_a, end_b});
    }
    for (; side < end_of_sides; ++side) sides(parts.sides.items[side]);
  });
  if (!parts.rates.items.empty())
    text.part("rates", parts.rates.items,
              [&](const fathom_check::PatchParts::Rate& rate) { text.line(rate.v, rate.w, rate.sign, rate.root); });
}

void write_motions(Text& text, const fathom_check::MotionParts& parts) {
  for (const std::size_t k : {0, 1}) {
    text.line(k == 0 ? "motion_a" : "motion_b");
    for (const fathom_check::MotionParts::Quaternion& turn : parts.motions[k].turns) text.line(turn.r, turn.v);
    for (const RationalPoint& place : parts.motions[k].places) text.line(place);
  }
}

/// Writes the lines after the claim of format 6.
void write_proof_of_motions(Text& text, const Certificate& c) {
  using Kind = fathom_check::MotionParts::Piece::Kind;
  text.part("pieces", c.of_motions.pieces, [&](const fathom_check::MotionParts::Piece& piece) {
    const fathom_check::Vector &n = piece.n, &g = piece.g;
    switch (piece.kind) {
      case Kind::of_b: return text.line(piece.end, "b", n.x, n.y, n.z);
      case Kind::of_a: return text.line(piece.end, "a", n.x, n.y, n.z);
      case Kind::of_edges: return text.line(piece.end, "ab", n.x, n.y, n.z, g.x, g.y, g.z);
      case Kind::near: break;
    }
    text.line(piece.end, "near", piece.delta);
    write_weights(text, piece.weights[0].items, piece.weights[1].items);
  });
  if (c.claim != Claim::contact) return;
  write_weights(text, c.weights_a.items, c.weights_b.items);
}

/// Returns the certificate without its first line and its id.
std::string text_of(const Certificate& c) {
  Text text;
  const auto vector = [&](const fathom_check::Vector& n) { text.line(n.x, n.y, n.z); };
  const auto pair = [&](const fathom_check::Pair& v) { text.line(std::size_t{v.j}, std::size_t{v.i}); };
  if (c.raising) text.line("plane", c.raising->height);
  write_body(text, c.a, "a", c.raising.has_value());
  write_body(text, c.b, "b", c.raising.has_value());
  if (c.format == 6) write_motions(text, c.of_motions);
  write_claim(text, c);
  if (c.format == 3) write_proof_of_unions(text, c);
  if (c.format == 6) write_proof_of_motions(text, c);
  // For two bodies the proof is left out: the proved checker, which cannot read it, stops before.
  if (c.format == 3 || c.format == 5 || c.format == 6) return std::move(text).ended(c.format);
  text.part("directions", c.directions.items, vector, c.all ? " all" : " some");
  for (const bool heights : {true, false}) {
    write_proof_of_body(text, c.a, "a", heights);
    write_proof_of_body(text, c.b, "b", heights);
  }
  if (c.proof == fathom_check::Proof::facets) {
    text.part("vertices", c.vertices.items, pair);
    text.facets(c.facets.items, 0, c.facets.items.size());
  } else if (c.proof == fathom_check::Proof::weights) {
    write_weights(text, c.weights_a.items, c.weights_b.items);
  }
  if (c.has_cone) {
    text.part("lineality", c.lineality.items, vector);
    text.part("rays", c.rays.items, vector);
    text.part("differences", c.differences.items, pair);
  }
  if (c.format == 4) write_patches(text, c.of_patches);
  return std::move(text).ended(c.format);
}

void ProvedChecker::hand_over(const Certificate& certificate) {
  text_ = text_of(certificate);
  claim_line_ = certificate.claim_line;
  format_ = certificate.format;
}

std::runtime_error ProvedChecker::failure(const std::string& what) {
  failed_ = true;
  return std::runtime_error(what);
}

std::string ProvedChecker::answer(const std::string& name) {
  using harness::Process;
  if (!process_) {
    look_here_first();
    process_ = std::make_unique<Process>(std::string("exec ") + proved_program + (width_ ? " --width -" : " -"));
  }
  text_.pop_back();  // send() appends the last line end
  process_->send("fathom-certificate " + std::to_string(format_) + "\nid " + name + '\n' + text_);
  std::string line;
  if (process_->read_line(line, Process::Clock::time_point::max()) == Process::Got::line) return line;
  constexpr int no_such_program = 127;  // the exit code of a shell
  const auto ending = process_->ending(Process::Clock::time_point::max());
  if (ending && !ending->by_signal && ending->number == no_such_program) throw failure(proved_program_is_missing());
  throw failure(std::string(proved_program) + " " + (ending ? harness::described(*ending) : "is gone"));
}

fathom_check::SecondChecker::Opinion ProvedChecker::opinion(const std::string& name) {
  const std::string line = answer(name);
  const std::string verified = "s VERIFIED ", end = ' ' + name;
  if (line.starts_with(verified) && line.ends_with(end)) return {fathom_check::Outcome::verified, line};
  const bool refused = line.starts_with("s REFUSED ");
  if (!refused && !line.starts_with("s MALFORMED ")) throw failure(std::string(proved_program) + " gives no verdict");
  const std::string start = line.substr(0, line.find(' ', 2)) + end;
  const std::size_t reason = line.find(": ", start.size());  // skips the line number, which is one of the text sent
  return {refused ? fathom_check::Outcome::refused : fathom_check::Outcome::malformed,
          start + ':' + std::to_string(claim_line_) + ": by " + proved_program + " alone" +
              line.substr(std::min(reason, line.size()))};
}

// ---- the command ----

struct UsageFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Replaces this process by the checker that was extracted from the Coq development. Returns only
/// if it is found neither beside this program nor on the path.
ExitCode become_proved(const std::vector<std::string>& words) {
  become(proved_program, words);
  talk(proved_program_is_missing());
  return internal_error;
}

/// Checks certificates with the C++ checker, which also compares them with cases and results. The
/// proved checker, which cannot read these, must then accept what passes.
ExitCode compare_and_prove(const std::vector<std::string>& words, bool width) {
  ProvedChecker proved(width);
  const int code = fathom_check::command_line(words, "fathom check", &proved);
  return proved.failed() || !std::cout ? internal_error : static_cast<ExitCode>(code);
}

/// Runs the work of the checker on threads of this program.
class Threads : public fathom_check::Workers {
 public:
  explicit Threads(unsigned threads) : threads_(threads) {}
  void run(const std::function<std::optional<fathom_check::Piece>()>& next) override {
    using fathom_check::Piece;
    const auto next_piece = [&] {
      std::optional<Piece> piece = next();
      return piece ? std::make_shared<Piece>(*std::move(piece)) : nullptr;
    };
    in_order<Piece>(
        threads_, next_piece, [](const Piece& piece) { piece.work(); }, [](const Piece& piece) { piece.report(); });
  }

 private:
  unsigned threads_;
};

/// Removes "--threads N" from the words and returns N. Throws UsageFault.
std::optional<unsigned> take_threads(std::vector<std::string>& words) {
  const auto option =
      std::find_if(words.begin(), std::find(words.begin(), words.end(), "--"),
                   [](const std::string& word) { return word == "--threads" || word.starts_with("--threads="); });
  if (option == words.end() || *option == "--") return std::nullopt;
  const bool joined = *option != "--threads";
  if (!joined && option + 1 == words.end()) throw UsageFault("--threads expects a number");
  const std::string text = joined ? option->substr(std::string_view("--threads=").size()) : *(option + 1);
  words.erase(option, option + (joined ? 1 : 2));
  const std::optional<unsigned> threads = typed_threads(text);
  if (!threads) throw UsageFault("--threads: " + wrong_threads(text));
  return threads;
}

/// Throws UsageFault for a misspelt option. The checker refuses other unknown options.
void refuse_misspelt(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const OptionHelp& option : page_of("check", common_options()).options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    if (words[i] == "--case" || words[i] == "--results") ++i;  // a file may have any name
    else if (words[i].starts_with("--") && std::find(names.begin(), names.end(), words[i]) == names.end())
      if (const std::string meant = did_you_mean(words[i], names); !meant.empty())
        throw UsageFault("unknown option " + kernels::shown(words[i]) + meant);
  }
}

ExitCode check(std::vector<std::string> words) {
  const auto asks_for_help = [&words] {
    const auto files = std::find(words.begin(), words.end(), "--");
    return std::any_of(words.begin(), files, [](const std::string& word) { return word == "--help" || word == "-h"; });
  };
  if (asks_for_help()) {
    print(help_text(page_of("check", common_options()), help_columns(STDOUT_FILENO)));
    return fine;
  }
  const std::optional<unsigned> threads = take_threads(words);
  refuse_misspelt(words);
  const auto files = std::find(words.begin(), words.end(), "--");
  const auto has = [&](const char* option) { return std::find(words.begin(), files, option) != files; };
  if (!asks_for_proved(words)) {
    Threads workers(threads.value_or(usual_threads()));
    const int code = fathom_check::command_line(words, "fathom check", nullptr, &workers);
    return std::cout ? static_cast<ExitCode>(code)
                     : internal_error;  // fathom-check, which has no code for internal errors, returns 2 here
  }
  if (threads)
    throw UsageFault("--proved checks one certificate after the other, and cannot be combined with --threads");
  const bool compares = has("--case") || has("--results") || has("--echo"), width = has("--width");
  words.erase(std::find(words.begin(), files, "--proved"));
  return compares ? compare_and_prove(words, width) : become_proved(words);
}

}  // namespace

bool asks_for_proved(const std::vector<std::string>& words) {
  const auto files = std::find(words.begin(), words.end(), "--");
  return std::find(words.begin(), files, "--proved") != files;
}

ExitCode run_check(const Given& given) try { return check(given.rest); } catch (const UsageFault& fault) {
  talk(std::string(fault.what()) + "\nTry: fathom check --help");
  return bad_input;
}

}  // namespace fathom::cli
