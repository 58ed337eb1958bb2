// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/proved_checker.hpp"

#include "cli/commands/exec_program.hpp"

namespace fathom::cli {
namespace {

using fathom_check::Certificate;
using fathom_check::Claim;
using fathom_check::Outcome;

/// Certificates in the words of FORMAT.md, section 2, line by line.
class Text {
 public:
  template <class... Fields>
  void line(const Fields&... fields) {
    const char* gap = "";
    ((result_ += gap, add(fields), gap = " "), ...);
    result_ += '\n';
  }
  template <class Items, class Line>
  void part(const char* name, const Items& items, const Line& row) {
    line(name, items.size());
    for (const auto& item : items) row(item);
  }
  void facets(const fathom_check::Facets& facets) {
    line("facets", facets.size());
    for (std::size_t f = 0; f < facets.size(); ++f) {
      add(facets.ends[f] - facets.begin_of(f));
      for (std::size_t k = facets.begin_of(f); k < facets.ends[f]; ++k) {
        result_ += ' ';
        add(std::size_t{facets.corners[k]});
      }
      result_ += '\n';
    }
  }
  std::string result() && { return std::move(result_); }

 private:
  void add(const char* word) { result_ += word; }
  void add(const fathom_check::Integer& n) { result_ += n.value().get_str(); }
  void add(std::size_t n) { result_ += std::to_string(n); }
  void add(const fathom_check::Rational& r) { result_ += r.num.value().get_str() + '/' + r.den.value().get_str(); }

  std::string result_;
};

void write_claim(Text& text, const Certificate& c) {
  switch (c.claim) {
    case Claim::depth: return text.line("claim depth", c.low);
    case Claim::bounds: return text.line("claim bounds", c.low, c.high);
    case Claim::touching: return text.line("claim touching");
    case Claim::disjoint: return text.line("claim disjoint");
  }
}

/// All but the first line and the id.
std::string text_of(const Certificate& c) {
  Text text;
  const auto point = [&](const fathom_check::RationalPoint& p) { text.line(p.x, p.y, p.z); };
  const auto weight = [&](const fathom_check::Weight& w) { text.line(std::size_t{w.index}, w.weight); };
  text.part("a", c.a.items, point);
  text.part("b", c.b.items, point);
  write_claim(text, c);
  text.line("directions", c.directions.items.size(), c.all ? "all" : "some");
  for (const fathom_check::Vector& n : c.directions.items) text.line(n.x, n.y, n.z);
  std::size_t fourth = 0, fifth = 0;
  if (c.claim == Claim::depth || c.claim == Claim::bounds) {
    text.part("vertices", c.vertices.items, [&](const fathom_check::Pair& v) { text.line(std::size_t{v.j}, std::size_t{v.i}); });
    text.facets(c.facets.items);
    fourth = c.vertices.items.size(), fifth = c.facets.items.size();
  } else if (c.claim == Claim::touching) {
    text.part("weights_a", c.weights_a.items, weight);
    text.part("weights_b", c.weights_b.items, weight);
    fourth = c.weights_a.items.size(), fifth = c.weights_b.items.size();
  }
  text.line("end", c.a.items.size(), c.b.items.size(), c.directions.items.size(), fourth, fifth);
  return std::move(text).result();
}

}  // namespace

void ProvedChecker::hand_over(const Certificate& certificate) {
  text_ = text_of(certificate);
  claim_line_ = certificate.claim_line;
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
  text_.pop_back();  // send() ends the last line
  process_->send("fathom-certificate 1\nid " + name + '\n' + text_);
  std::string line;
  if (process_->read_line(line, Process::Clock::time_point::max()) == Process::Got::line) return line;
  constexpr int no_such_program = 127;  // of a shell
  const auto ending = process_->ending(Process::Clock::time_point::max());
  if (ending && !ending->by_signal && ending->number == no_such_program) throw failure(proved_program_is_missing());
  throw failure(std::string(proved_program) + " " + (ending ? harness::described(*ending) : "is gone"));
}

fathom_check::SecondChecker::Opinion ProvedChecker::opinion(const std::string& name) {
  const std::string line = answer(name);
  const std::string verified = "s VERIFIED ", end = ' ' + name;
  if (line.starts_with(verified) && line.ends_with(end)) return {Outcome::verified, line};
  const bool refused = line.starts_with("s REFUSED ");
  if (!refused && !line.starts_with("s MALFORMED ")) throw failure(std::string(proved_program) + " gives no verdict");
  const std::string start = line.substr(0, line.find(' ', 2)) + end;
  const std::size_t reason = line.find(": ", start.size());  // behind a line number of the text that was handed over
  return {refused ? Outcome::refused : Outcome::malformed,
          start + ':' + std::to_string(claim_line_) + ": by " + proved_program + " alone" + line.substr(std::min(reason, line.size()))};
}

std::string proved_program_is_missing() {
  return std::string(proved_program) +
         " is not here: it is built from proofs/coq, with Coq and OCaml (Debian: coq, libzarith-ocaml-dev, ocaml-findlib)";
}

}  // namespace fathom::cli
