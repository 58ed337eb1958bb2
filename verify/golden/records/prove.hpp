// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a record against its certificate, from their texts alone; trusts neither. The default is refusal.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/records/csv.hpp"
#include "verify/golden/records/record_facts.hpp"
#include "verify/golden/records/record_reader.hpp"
#include "verify/golden/shapes/shape_recipe.hpp"
#include "verify/golden/unions/union_recipe.hpp"

namespace fathom::golden {

/// Proves one record after another, best those of one recipe together: its points are made once. One for each thread.
class Prover {
 public:
  /// Returns nullopt if everything in the line is proved, else one sentence on what is not. `line` has no line feed, `certificate` holds
  /// exactly one certificate. What is proved: the certificate, by the checker that shares nothing with the rest; that it is about the
  /// points of the line, and that the source yields these points; that status, depth and directions are those of the certificate; every
  /// rounded value, translation, contact, witness, gap, format and flag by computing it again. Fields that are missing, repeated or unknown
  /// are refused. Throws nothing on bad input.[proofs/golden.md]
  std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

  // Of the record that was proved last.
  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] const std::string& row() const { return row_; }  ///< of the CSV
  /// The ids of all records of its recipe, in their order.
  [[nodiscard]] std::vector<std::string> ids() const;

 private:
  std::optional<std::string> faults(std::string_view line, std::string_view certificate);
  void make_cases(const Claimed& claimed);
  const Case& prove_source(const Claimed& claimed);
  Facts facts_from(const Claimed& claimed, std::string_view certificate);
  /// The line as it has to be.
  std::string line_as_proved(const Claimed& claimed, std::string_view certificate);
  std::string line_of_points(const Claimed& claimed, std::string_view certificate);
  std::string line_of_shapes(const Claimed& claimed, std::string_view certificate);
  std::string line_of_unions(const Claimed& claimed, std::string_view certificate);

  Workspace workspace_;
  std::optional<Recipe> recipe_;
  std::vector<FormedCase> cases_;          // of the recipe, if it is of points
  std::vector<FormedShapes> shape_cases_;  // if it is of shapes
  std::vector<FormedUnions> union_cases_;  // if it is of unions
  std::string id_;
  std::string row_;
};

/// The same for a single record.
std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

}  // namespace fathom::golden
