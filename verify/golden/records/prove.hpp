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

/// Proves one record after another, best those of one recipe together: its bodies are made once.
/// One for each thread.
class Prover {
 public:
  /// Returns nullopt if everything in the line is proved, else one sentence on what is not. `line`
  /// has no line feed, `certificate` holds exactly one certificate. What is proved: the
  /// certificate, by the checker that shares nothing with the rest; that it is about the bodies of
  /// the line, and that the source yields these; that status, depth and directions are those of the
  /// certificate; every rounded value, translation, contact, witness, gap, format and flag by
  /// computing it again. Fields that are missing, repeated or unknown are refused. Throws nothing
  /// on bad input.[proofs/golden.md]
  std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

  // Of the record that was proved last.
  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] const std::string& row() const { return row_; }  ///< of the CSV
  /// The ids of all records of its recipe, in their order.
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

/// The same for a single record.
std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

/// Returns the truth that the certificate proves of these bodies: status, length, directions, cone
/// and translations of unions are its own; contacts and other translations follow from the bodies
/// by the definitions. Throws NotProved unless the checker accepts it, it has the id of this case
/// and is about its bodies, and agrees with what is known of the answer by construction. `witness`:
/// that of the record, which is proved too, and which polytopes must have.       [proofs/golden.md]
RecordStatement proved_truth(const FormedCase& made, const std::optional<Witness>& witness,
                             std::string_view certificate, Workspace* workspace = nullptr);

/// Returns what a record of contacts says beside that truth: found anew, where each direction, each
/// corner of a patch, the cone of cores that touch and, unless they do, each derivative is one that
/// the certificate proves. Throws NotProved otherwise.
ContactFacts proved_contacts(const FormedCase& made, std::string_view certificate);

// ---- recomputation ----

// Compares a record with what is found of its bodies in another way: one that takes nothing from
// certificate and answer.

/// Computes the answer about the record's bodies anew, and from it every field of the record,
/// except which certificate goes with it. Returns nullopt if the line is the same, else one
/// sentence on the first difference. Throws Interrupted, and nothing on bad input.
///
/// Polytopes `method` answers alone. Shapes whose cores are polytopes, or one a half-space and the
/// other a polytope, are turned and exchanged, and `method` answers about the cores. Other shapes
/// no other method can answer: turned, exchanged and enclosed anew the search takes another way
/// from another start, and both enclosures must overlap. Unions are turned and exchanged too; which
/// pieces are nearest, where several pairs may be, the line says, and `method` answers about these
/// two.                                                                          [proofs/golden.md]
std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor = nullptr);

/// Laws of contacts. Moved by a rigid pose and exchanged, the bodies have the same patches, and the
/// same derivatives along the same motions. Throws NotProved if not.
void insist_on_exchanged(const RecordBodies& bodies, const ContactFacts& contacts, const Pose& frame,
                         const Options& options);

/// Each patch is what the faces share when one is clipped by the other. Throws NotProved if not.
void insist_on_clipped(const RecordBodies& bodies, const ContactFacts& contacts);

/// The cone of cores that touch is the one that is proved; there is none where none is proved.
/// Throws NotProved if not.
void insist_on_cone(const ContactGeometry& geometry, const std::optional<OptimalCone>& proved);

}  // namespace fathom::golden
