// SPDX-License-Identifier: Apache-2.0
#include "reader.hpp"

#include <exception>
#include <new>
#include <utility>

#include "check.hpp"
#include "checks.hpp"
#include "limits.hpp"
#include "parser.hpp"
#include "text.hpp"

namespace fathom_check {

namespace {

Verdict fault(Outcome outcome, std::size_t line, const std::string& reason) {
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.line = line;
  verdict.reason = reason;
  return verdict;
}

/// How many corners each patch has: "4+1".
std::string corners_of_patches(const std::vector<List>& lists) {
  std::string result;
  for (std::size_t k = 0; k < lists.size(); ++k)
    result += (k == 0 ? "" : "+") + std::to_string(lists[k].end - begin_of(lists, k));
  return result;
}

/// "(1/4,1/2):1/8+..": between which times nothing is shown, and the distance at the later one.
std::string near_pieces(const std::vector<MotionParts::Piece>& pieces) {
  std::string result;
  Rational begin;
  for (const MotionParts::Piece& piece : pieces) {
    if (piece.kind == MotionParts::Piece::Kind::near)
      result += (result.empty() ? "(" : "+(") + text(begin) + "," + text(piece.end) + "):" + text(piece.delta);
    begin = piece.end;
  }
  return result;
}

/// For a certificate that has passed every check.
Verdict verified(const Certificate& c) {
  Verdict verdict;
  verdict.status = status(c);
  verdict.format = c.format;
  const auto pieces = [](const Body& body) {
    return std::to_string(body.core == Body::Core::solid ? body.solid.pieces.size() : body.pieces.size());
  };
  const auto triangles = [](const Body& body) {
    return body.core == Body::Core::solid ? std::to_string(body.solid.mesh.items.size()) : "-";
  };
  if (c.format == 6) {
    if (!c.of_motions.pieces.empty()) verdict.until = text(c.of_motions.pieces.back().end);
    if (c.claim == Claim::contact) verdict.meeting = text(c.low);
    verdict.near = near_pieces(c.of_motions.pieces);
  } else if (c.claim == Claim::solid) {
    verdict.triangles = triangles(c.a);
    verdict.pieces = pieces(c.a);
  } else if (is_of_unions(c)) {
    verdict.pieces = pieces(c.a) + "x" + pieces(c.b);
    if (c.format == 5) verdict.triangles = triangles(c.a) + "x" + triangles(c.b);
    (c.claim == Claim::apart ? verdict.distance_squared : verdict.depth_squared) = text(c.low);
    verdict.optima = c.of_unions.optima.items.size();
  } else if (c.claim == Claim::bounds || c.claim == Claim::signed_bounds) {
    verdict.at_least = text(c.low);
    verdict.at_most = text(c.high);
  } else if (c.format == 1) {
    verdict.depth_squared = text(c.low);
  } else {
    verdict.signed_depth = (c.claim == Claim::apart ? "-sqrt(" : "sqrt(") + text(c.low) + ")+" + radii(c).get_str();
  }
  if (c.has_cone) verdict.cone = std::to_string(c.lineality.items.size()) + "+" + std::to_string(c.rays.items.size());
  verdict.patches = corners_of_patches(c.of_patches.corner_lists);
  verdict.rates = c.of_patches.rates.items.size();
  verdict.plane = c.raising.has_value();
  if (c.all) verdict.optima = c.directions.items.size();
  verdict.outcome = Outcome::verified;
  return verdict;
}

}  // namespace

Verdict caught(const std::function<Verdict()>& action, std::size_t line) {
  try {
    return action();
  } catch (const Fault& error) {
    return fault(error.malformed ? Outcome::malformed : Outcome::refused, error.line, error.what());
  } catch (const std::bad_alloc&) {
    return fault(Outcome::malformed, line, "larger than the memory at hand");
  } catch (const std::exception& error) {
    return fault(Outcome::malformed, line, error.what());
  }
}

std::optional<Reader::Found> Reader::read() {
  const auto fault_of = [](const auto& action) {
    bool whole = false;
    Verdict fault = caught(
        [&] {
          action();
          whole = true;
          return Verdict();
        },
        0);
    return whole ? std::nullopt : std::optional(std::move(fault));
  };
  bool found = false;
  fault_of([&] { found = parser_.find_next() || !any_; });
  if (!found) return std::nullopt;
  any_ = true;
  Found result;
  result.fault = fault_of([&] { parser_.read(result.certificate); });
  result.last_line = lines_->number();
  if (result.fault) fault_of([&] { parser_.skip_to_next(); });
  return result;
}

std::optional<Verdict> Reader::next(const Inspect& inspect) {
  const std::optional<Found> found = read();
  return found ? std::optional(judged(*found, inspect)) : std::nullopt;
}

Verdict judged(const Reader::Found& found, const Inspect& inspect) {
  const auto check = [&] {
    if (inspect) inspect(found.certificate);
    check_claim(found.certificate);
    return verified(found.certificate);
  };
  Verdict verdict = found.fault ? *found.fault : caught(check, 0);
  if (!verdict.accepted() && verdict.line == 0) verdict.line = found.last_line;
  verdict.id = found.certificate.id;
  return verdict;
}

std::string unreadable(std::string_view text, const Limits& limits) {
  Lines lines(text, longest_line);
  Parser parser(lines, limits);
  Certificate certificate;
  try {
    parser.find_next();
    parser.read(certificate);
    // The work of a tree is known when its planes are, so only a check finds it too much.
    if (is_of_solids(certificate) && certificate.claim == Claim::depth) check_claim(certificate);
    return "";
  } catch (const Fault& fault) {
    return fault.malformed ? fault.what() : "";
  }
}

void require_readable(std::string_view certificate, const Limits& limits) {
  const std::string why = unreadable(certificate, limits);
  if (!why.empty()) throw Unreadable("no certificate is written, since all checkers would refuse to read it: " + why);
}

Verdict judged_alone(std::string_view text, const Inspect& inspect) {
  Lines lines(text, longest_line);
  Reader reader(lines);
  const Verdict verdict = *reader.next(inspect);
  const std::size_t line = lines.number();
  if (verdict.outcome != Outcome::malformed && reader.next())
    throw malformed(line + 1, "expected the end after one certificate, found more");
  return verdict;
}

Verdict verify(std::string_view text) noexcept {
  try {
    return caught([text] { return judged_alone(text); }, 0);
  } catch (...) {
    return {};  // refused, without a reason: not even the memory for one
  }
}

std::string verdict_line(const Verdict& v, std::string_view name) {
  const std::string label = v.id.empty() ? escaped(name) : v.id;
  if (!v.accepted()) {
    const char* const word = v.outcome == Outcome::refused ? "s REFUSED " : "s MALFORMED ";
    return word + label + ":" + std::to_string(v.line) + ": " + v.reason;
  }
  const char* const what = v.format == 2 || v.format == 4 ? " signed_depth"
                           : v.distance_squared.empty()   ? " depth_squared"
                                                          : " distance_squared";
  std::string line = "s VERIFIED " + v.status;
  const std::string triangles = v.triangles.empty() ? "" : " triangles=" + v.triangles;
  const bool solid = v.status == "solid";
  if (v.format == 6) {
    for (const auto& [word, said] : {std::pair{" until=", &v.until}, {" at=", &v.meeting}, {" near=", &v.near}})
      if (!said->empty()) line += word + *said;
  } else if (solid) {
    line += triangles;
  } else if (v.at_least.empty()) {
    line += what + ("=" + v.depth_squared + v.distance_squared + v.signed_depth);
  } else {
    line += what + ("_in=[" + v.at_least + "," + v.at_most + "]");
  }
  if (v.optima > 0) line += " optima=" + std::to_string(v.optima);
  if (!v.cone.empty()) line += " cone=" + v.cone;
  if (!v.pieces.empty()) line += " pieces=" + v.pieces;
  if (!solid) line += triangles;
  if (!v.patches.empty()) line += " patches=" + v.patches;
  if (v.rates > 0) line += " rates=" + std::to_string(v.rates);
  if (v.plane) line += " dimension=2";
  return line + " " + label;
}

}  // namespace fathom_check
