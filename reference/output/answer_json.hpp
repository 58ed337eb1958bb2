// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answer to a case, of bodies of any kinds, as JSON: result.schema.json, of
// unions union.schema.json.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/patch.hpp"
#include "reference/output/json_values.hpp"
#include "reference/output/result_fields.hpp"

namespace fathom::output {

/// Where two bodies touch after the answer's ways out, and how the depth changes.
struct Manifold {
  ContactGeometry geometry;
  std::optional<VertexWeights> weights;
  std::optional<std::variant<DirectionalDerivative, LeftOut>> derivative = {};  ///< along the motion asked for
  /// of each patch the corners with slack, or nullopt, if one is asked for
  std::vector<std::optional<std::vector<RoundedWitness>>> with_slack = {};
};

/// Of an answer about these bodies; of an incomplete one it says that nothing is told. `slack`: of
/// the patches, in addition.
Manifold manifold_of(const Body& a, const Body& b, const Answer& answer, const std::optional<Motion>& motion,
                     Monitor* monitor = nullptr, const std::optional<mpq_class>& slack = {});

/// The text of a certificate of the answer: with the patches of its manifold, if there is one, and
/// the derivatives along these motions of A, as far as these have a proof. Throws as
/// certificate_text does.
std::string certificate_of(const Body& a, const Body& b, const Answer& answer, const Manifold* manifold,
                           std::span<const Twist> motions, std::string_view id, Monitor* monitor = nullptr);

/// A case and its answer; for `width` it is about the body against itself.
struct AnsweredCase {
  std::string id;
  Answer answer;
  AboutBodies bodies = {};
  BodyFacts facts = {};                   ///< which of the bodies are flat
  std::string certificate = {};           ///< as text, if one is requested and the answer is complete
  std::optional<Manifold> manifold = {};  ///< if it is requested and the answer is complete
};

/// What of an answer is written.
struct Shown {
  std::optional<std::size_t> optima = {};  ///< how many are listed; all if not set
  std::optional<unsigned> digits = {};     ///< of the enclosure of the depth, if one is wanted
  bool counters = false;                   ///< what the run did
  bool certificate = false;                ///< as a field
  bool width = false;                      ///< the answer is about one body, against itself
  bool patch = false;                      ///< where the bodies touch
  std::optional<mpq_class> slack = {};     ///< and the patches with this slack
};

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string answer_json(const AnsweredCase& answered, const Shown& shown);

/// The fields "manifold" and "derivative". Of polytopes that touch the first has their cone, of
/// unions each patch its pieces.
Json manifold_object(const Manifold& manifold);
Json derivative_object(const std::variant<DirectionalDerivative, LeftOut>& derivative, unsigned dimension = 3);

/// Returns the line for a case of a stream that has no result.
std::string json_error(const std::string& id, std::size_t line, std::string_view error);

/// One line, without its newline, of an answer about two polytopes or shapes, exact or approximate.
std::string result_line(const Result& result);

/// The word for the linear space that a cone holds.
std::string_view lineality_name(const OptimalCone& cone);

/// The word for the method that answered.
std::string_view method_name(const Depth& depth);
std::string_view method_name(const SignedDepth& depth);

/// What the run did.
inline const Counters& counters_of(const Depth& depth) { return depth.counters; }
inline Counters counters_of(const SignedDepth& depth) { return depth.counters(); }

}  // namespace fathom::output
