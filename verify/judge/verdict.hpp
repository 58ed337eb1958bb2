// SPDX-License-Identifier: GPL-3.0-or-later
// The names of everything that can be said of an answer.                                      [verify/judge/VERDICTS.md]
#pragma once

#include <optional>
#include <string_view>

namespace fathom {

/// In order of rank: of several that hold of one answer, the first is the verdict. The last two of them are passes.
enum class Verdict {
  // Nothing was answered that could be judged; only a harness finds these.
  crash,     ///< the subject ended by a signal, or with a failure, while it held the case
  time_out,  ///< no answer in the time that was given
  silent,    ///< the subject ended in good order, or closed its output, without an answer
  garbage,   ///< what it printed is no reply to the case
  failed,    ///< the subject says itself that it could not answer: an exception, an error code
  // The answer is wrong.
  nan,               ///< a number that it needs is NaN or infinite
  false_separation,  ///< the bodies overlap by more than the tolerance, and it says that they do not
  false_overlap,     ///< the bodies are apart by more than the tolerance, and it says that they overlap
  not_a_direction,   ///< the direction is zero, or not of unit length where that was promised
  wrong_sign,        ///< right but for a sign: of the depth, or of the direction
  too_deep,          ///< the depth is larger than the penetration depth
  too_shallow,       ///< the depth is smaller than the penetration depth
  not_separating,    ///< the bodies still overlap after the translation that it gives
  inconsistent,      ///< the depth is not that of its own direction
  witness_off,       ///< a witness point is not on its body, or they do not differ by the translation
  not_invariant,     ///< it answers a case differently that is the same but for a symmetry; only a harness finds it
  // Not judged.
  unsupported,  ///< the subject declined: the case is outside of what it says it can do
  // Passes.
  touching_by_convention,  ///< the bodies touch, and it counts that as it declared
  pass
};

/// "too-deep": lower case, hyphens. Total.
std::string_view name(Verdict verdict);
/// The inverse of `name`.
std::optional<Verdict> verdict_named(std::string_view name);

/// pass and touching_by_convention.
constexpr bool passes(Verdict verdict) { return verdict >= Verdict::touching_by_convention; }
/// Anything but a pass or `unsupported`.
constexpr bool fails(Verdict verdict) { return verdict < Verdict::unsupported; }

}  // namespace fathom
