// SPDX-License-Identifier: Apache-2.0
// From lines to a certificate: the grammar of FORMAT.md, sections 2 and 12 to 17, and nothing
// more lenient.
#pragma once

#include <algorithm>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "certificate.hpp"
#include "limits.hpp"

namespace fathom_check {

/// An input, line by line. Memory is bounded by the longest line that is allowed, and so is what is
/// read ahead.
class Lines {
 public:
  enum class Kind { whole, cut_off, too_long, none };

  /// Reads from a stream, which must outlive this.
  explicit Lines(std::istream& input, std::size_t longest) : input_(&input), longest_(longest) {}
  /// Reads from a text, which must outlive this.
  Lines(std::string_view text, std::size_t longest) : block_(text), longest_(longest) {}

  /// Goes on to the next line. `cut_off`: the last one, without a line feed. `too_long`: its rest
  /// is skipped. `none`: the end.
  Kind advance();
  /// The line at hand, without its line feed; valid until the next call.
  [[nodiscard]] std::string_view text() const { return text_; }
  /// Its number, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] Kind kind() const { return kind_; }
  /// Whether the stream broke: a directory, a disk fault.
  [[nodiscard]] bool broken() const { return input_ != nullptr && input_->bad(); }

 private:
  bool refill();

  std::istream* input_ = nullptr;
  std::vector<char> buffer_;
  std::string_view block_;  ///< read, and not yet handed out
  std::string joined_;      ///< a line that spans blocks
  std::string_view text_;
  std::size_t longest_, number_ = 0;
  Kind kind_ = Kind::none;
};

class Parser {
 public:
  explicit Parser(Lines& lines, const Limits& limits = {}) : lines_(&lines), limits_(limits) {}

  /// Moves to the first line of the next certificate, past comments. False at the end of the input.
  bool find_next();

  /// Reads the certificate whose first line is at hand into `result`, up to its footer. Throws
  /// Fault if it is malformed.
  void read(Certificate& result);

  /// After a fault: moves to the next line that begins a certificate. False at the end of the
  /// input.
  bool skip_to_next();

  [[nodiscard]] bool at_header() const;

 private:
  void advance();
  void next(const char* expected);
  void require_line(const char* expected);
  [[nodiscard]] bool at(std::string_view word) const;
  bool skip_comments();
  void split();
  [[nodiscard]] Fault wrong(const std::string& expected) const;

  void demand(std::size_t count, const char* expected) const;
  void row(std::size_t numbers, const char* expected);
  void count_numbers(std::size_t numbers);
  void require_natural(std::string_view token, const char* expected) const;
  mpz_class long_integer(std::string_view token, const char* expected) const;
  Integer integer(std::string_view token, const char* expected) const;
  Rational rational(std::string_view token) const;
  std::size_t count(std::size_t index, const char* expected) const;
  std::uint32_t index_number(std::string_view token) const;

  void read_id(Certificate& result);
  void read_plane(Certificate& result);
  void read_body(Body& body, const std::string& name, int format);
  void read_points(Body& body, const std::string& name);
  void read_half_space(Body& body);
  void read_claim(Certificate& result);
  std::size_t header(const std::string& word, const char* number = "their number", std::size_t fields = 2);
  template <class Items, class Item>
  void read_rows(Part<Items>& part, std::size_t lines, std::size_t numbers, const char* expected, const Item& item);
  RationalPoint point(std::size_t first) const;
  Term read_term();
  void read_directions(Certificate& result);
  void read_vectors(Part<std::vector<Vector>>& part, std::size_t lines);
  void read_heights(Body& body, const std::string& name);
  void read_inner(Body& body, const std::string& name);
  void read_pairs(Part<std::vector<Pair>>& part, const char* word);
  void read_facets(Part<Facets>& part, const char* word = "facets");
  void read_weights(Part<std::vector<Weight>>& part, const char* word);
  void read_proof(Certificate& result);
  void read_convex(Certificate& result);
  void read_unions(Certificate& result);
  void read_proof_of_unions(Certificate& result);
  void read_pieces(Body& body, const std::string& name);
  void read_apart(Certificate& result);
  void read_optima(Certificate& result);
  void read_polytopes(Certificate& result);
  void read_tree(Part<Nodes>& part);
  void read_nearest(Certificate& result);
  void read_solids(Certificate& result);
  void read_solid(Body& body, const std::string& name);
  void read_patches(PatchParts& parts);
  void read_corner(PatchParts& parts);
  std::size_t read_weights_of_corner(std::vector<Weight>& weights, std::size_t first);
  void read_rates(Part<std::vector<PatchParts::Rate>>& part);
  void read_motions(Certificate& result);
  void read_motion(MotionParts::Motion& motion, const char* word);
  void read_piece_of_motion(MotionParts& parts);
  void read_footer(const Certificate& certificate);

  Lines* lines_;
  Limits limits_;
  Arena* integers_ = nullptr;            ///< of the certificate at hand
  const Rational* height_ = nullptr;     ///< of bodies of the plane
  std::size_t bytes_ = 0, numbers_ = 0;  ///< of this certificate so far
  std::vector<std::size_t> counts_;      ///< that parts of this certificate announced
  std::vector<std::string_view> fields_;
  bool fresh_ = false;  ///< the line at hand is the first of a certificate that has not been read yet
};

/// The lines of a part, with this many numbers each; `item` makes one of the line at hand.
template <class Items, class Item>
void Parser::read_rows(Part<Items>& part, std::size_t lines, std::size_t numbers, const char* expected,
                       const Item& item) {
  constexpr std::size_t few = 64;  // however many are announced
  if (part.lines.empty()) {
    part.items.reserve(std::min(lines, few));
    part.lines.reserve(std::min(lines, few));
  }
  part.line = lines_->number();
  for (; lines > 0; --lines) {
    row(numbers, expected);
    item(part.items);
    part.lines.push_back(lines_->number());
  }
  advance();
}

}  // namespace fathom_check
