// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a record against its certificate, from their texts alone; trusts neither. The default is
// refusal.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {

/// Why something is not proved, as one sentence.
struct NotProved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Proves records one after another; records of one recipe should follow each other, as its bodies
/// are generated once. Use one Prover for each thread.
class Prover {
 public:
  /// Returns nullopt if everything in the line is proved, else a sentence on the first fault.
  /// `line` has no line feed, `certificate` holds exactly one certificate. Proves that the checker,
  /// which shares no code with the rest, accepts the certificate; that it is about the bodies of
  /// the line, and that the source generates these; that status, depth and directions are those of
  /// the certificate; and every rounded value, translation, contact, witness, gap, format and flag,
  /// by computing it again. Refuses missing, repeated and unknown fields. Throws nothing on bad
  /// input. [proofs/golden.md]
  std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

  // These are about the record that was proved last.
  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] const std::string& row() const { return row_; }  ///< of the CSV
  /// Returns the ids of all records of its recipe, in their order.
  [[nodiscard]] std::vector<std::string> ids() const;

 private:
  std::optional<std::string> faults(std::string_view line, std::string_view certificate);
  const FormedCase& source_of(const ReadRecord& claimed);

  Workspace workspace_;
  std::optional<Recipe> recipe_;
  std::vector<FormedCase> cases_;  // of the recipe
  std::string id_;
  std::string row_;
};

/// Does the same for a single record.
std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

/// Returns the truth about these bodies that the certificate proves: status, length, directions,
/// cone and translations of unions are its own; contacts and other translations follow from the
/// bodies by the definitions. Throws NotProved unless the checker accepts the certificate, it has
/// the id of this case and is about its bodies, and agrees with the answer known by construction.
/// `witness`: that of the record, which polytopes must have, and which is proved too.
/// [proofs/golden.md]
RecordStatement proved_truth(const FormedCase& made, const std::optional<Witness>& witness,
                             std::string_view certificate, Workspace* workspace = nullptr);

/// Returns the additional fields of a record of contacts, computed again. Throws NotProved unless
/// the certificate proves each direction, each corner of a patch, the cone of cores that touch and,
/// unless they touch, each derivative.
ContactFacts proved_contacts(const FormedCase& made, std::string_view certificate);

/// Returns the case of this form. Throws NotProved if there is none.
const FormedCase& case_in(const std::vector<FormedCase>& cases, Form form);

// ---- recomputation ----

// Compares a record with results about its bodies that are computed without its certificate and
// answer.

/// Computes the answer about the record's bodies anew, and from it every field of the record,
/// except which certificate goes with it. Returns nullopt if the line is the same, else one
/// sentence on the first difference. Throws Interrupted, and nothing on bad input.
///
/// `method` answers about polytopes as they are. Shapes whose cores are polytopes, or a half-space
/// and a polytope, are turned and exchanged, and `method` answers about the cores. No other method
/// can answer about other shapes: these are turned, exchanged and enclosed anew, so that the search
/// takes another path, and both enclosures must overlap. Unions are turned and exchanged too; the
/// line names a pair of nearest pieces, of which there may be several, and `method` answers about
/// these two. [proofs/golden.md]
std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor = nullptr);

/// Checks that the bodies, moved by a rigid pose and exchanged, have the same patches, and the same
/// derivatives along the same motions. Throws NotProved if not.
void insist_on_exchanged(const RecordBodies& bodies, const ContactFacts& contacts, const Pose& frame,
                         const Options& options);

/// Checks that each patch is the intersection of the faces, found by clipping one by the other.
/// Throws NotProved if not.
void insist_on_clipped(const RecordBodies& bodies, const ContactFacts& contacts);

/// Checks that cores that touch have the cone that is proved, and no cone if none is proved. Throws
/// NotProved if not.
void insist_on_cone(const ContactGeometry& geometry, const std::optional<OptimalCone>& proved);

}  // namespace fathom::golden
