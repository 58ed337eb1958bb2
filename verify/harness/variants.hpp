// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a case as it is put to a subject.
// Output  the same case after a symmetry of the depth, exactly; and whether the subject gave the
//         same answer to both.                                                    [docs/certify.md]
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// The case under one symmetry. Every coordinate is a finite number of the subject's format, so the
/// subject gets exactly these points.
struct Variant {
  std::string name;  ///< one of variant_names
  Case seen;         ///< under the id of the original
  bool swapped = false;
  Point step = {};    ///< by which all points are moved
  long exponent = 0;  ///< lengths are 2^exponent times those of the original
  NumberFormat format = {};
};

/// All names, in the order in which `variants` makes them.
inline constexpr std::string_view variant_names[] = {"swap", "translate", "permute", "scale", "repeat"};

/// Returns the variants of `as_seen` that are exact in `format`, for the known ones of the names:
///   swap       B for A and A for B
///   translate  both bodies moved by one vector, the longest of a few that keep every coordinate
///              exact
///   permute    the points of both bodies, or of each of their pieces, in another order, the same
///              each time
///   scale      all coordinates times 2^10, or another power of two if that is not exact
///   repeat     the case itself once more, for subjects whose answers depend on earlier cases
/// For a described body, the place is moved, the vertices in its description change their order,
/// and all its lengths are scaled. Omits variants that are not exact; if `left_out` is given, adds
/// a sentence about each of them to it.
std::vector<Variant> variants(const Case& as_seen, const NumberFormat& format, std::span<const std::string> names,
                              std::vector<std::string>* left_out = nullptr);

/// Returns the depth of a variant by the law alone: squares of lengths are 4^exponent times those
/// of the original.
mpq_class depth_squared_of(const Variant& variant, const mpq_class& of_original);

/// Compares the outcome of a variant with that of the original. If the variant passes by itself,
/// but the subject's answers differ by more than the tolerance, the verdict becomes
/// `not_invariant`, and the sentence says by how much. Compares the depth, the separating distance
/// of the direction, whether the bodies overlap (unless both answers are within the tolerance), and
/// whether there is an answer at all. If both answers have the same direction, and a subject that
/// declares a `manifold` reports fewer contacts than its maximum, also compares how far the
/// contacts extend across the direction, with twice the tolerance. A variant that fails by itself
/// keeps its verdict.
Outcome compare_variant(const Outcome& original, const Outcome& variant, const Variant& made,
                        const Tolerance& tolerance, const std::optional<ContactLimits>& manifold);

/// Returns a function for `shrink`: it examines a case and then its variant of this name, and
/// returns the outcome of the variant, compared. A case without such a variant yields the outcome
/// of the case itself. `fit`: the size to which the case is brought; see exponent_to_fit.
Examine examine_variant(ExamineInUnit examine, std::string name, NumberFormat format, Tolerance tolerance,
                        std::optional<mpq_class> fit, std::optional<ContactLimits> manifold);

}  // namespace fathom::harness
