// SPDX-License-Identifier: Apache-2.0
// What a certificate is compared with: the user's own cases, and the line of JSON Lines results
// that holds it.
//
// The cases give the points that it has to be about. JSON, schema fathom/case/1, one value after
// another; or many cases as `fathom golden export --format json` writes them, schema
// fathom/golden-export/1.
//
// A JSON number means the nearest binary64; a text is exact: integer, p/q, decimal, C99 hex float.
// "pose" (3 rows of 4 numbers, M | t) places each vertex p at M p + t, exactly; "pose_rounding":
// "binary64", in the case or a body, then rounds it once. A body has "vertices", or "pieces" that
// have some, each with a pose of its own if it likes, which places it before the body's does.
// "dimension": 2 makes it a case of the plane: points have two coordinates, a pose two rows of
// three numbers, and a piece may be an array of points.
#pragma once

#include <gmpxx.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certificate.hpp"
#include "json.hpp"
#include "limits.hpp"

namespace fathom_check {

using ExactPoint = std::array<mpq_class, 3>;

/// A body of the user's. One that is convex is a single piece.
struct OwnBody {
  std::vector<std::vector<ExactPoint>> pieces;
  bool has_pieces = false;  ///< said so itself
};

/// Returns if the points of b are those of a again, so that the depth is the width of a; throws
/// Fault (refused) otherwise, and for unions and bodies of the plane.
void require_width(const Certificate& certificate);

class CaseFile {
 public:
  /// Reads all cases in `text`. Throws Fault (malformed) unless there is one at least, and each can
  /// be read.
  explicit CaseFile(std::string_view text);

  /// Returns if the certificate is about the same points, in the same order, as the user's case;
  /// throws Fault (refused) otherwise. That is the case of the id `result_id`, if a result bears
  /// one; else the only case of the file, or the one whose id the certificate bears. A case without
  /// an id has the number of its first line for one. With `width`, body a of the case is compared
  /// alone.
  void compare(const Certificate& certificate, bool width = false,
               const std::optional<std::string>& result_id = {}) const;

 private:
  struct Bodies {
    OwnBody a, b;
    bool plane;
  };
  void read(const Json& value, std::size_t line);
  void read_one(const Json& value, std::size_t line, bool of_export);
  [[nodiscard]] const Bodies& find(const Certificate& certificate, const std::optional<std::string>& result_id) const;

  std::vector<Bodies> cases_;
  std::map<std::string, std::vector<std::size_t>, std::less<>> by_id_;
  Budget budget_;
};

/// What a line of results says besides its certificate.                     [FORMAT.md, section 9]
struct Result {
  std::string certificate;
  std::optional<std::string> id, status;
  /// The field "squared" of a field that is there; absent if it is null.
  struct Square {
    std::optional<mpq_class> value;
  };
  std::optional<Square> depth, bound;
  std::vector<Square> distances;  ///< wherever the line says one

  /// sign sqrt(root) + plus.
  struct Exact {
    int sign = 0;
    mpq_class root, plus;
  };
  struct SignedDepth {
    std::optional<mpq_class> low, high;  ///< absent: beyond all doubles
    std::optional<Exact> exact;
  };
  std::optional<SignedDepth> signed_depth;
};

/// Throws Fault (malformed); the id may have been read by then.
void read_result(std::string_view text, std::size_t line, Result& result);

/// Throws Fault (refused) unless id, status, depth, bound, distance and signed depth are those of
/// the certificate.
void compare(const Result& result, const Certificate& certificate);

}  // namespace fathom_check
