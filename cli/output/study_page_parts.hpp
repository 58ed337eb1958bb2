// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of the page of studies. Each is a whole element or a few; texts of others are escaped in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/study.hpp"

namespace fathom::cli {

/// The features that a picture shows when they are asked for, each with an id of its own.
class Marks {
 public:
  /// `anchor` begins the ids; at most `most` features have one.
  explicit Marks(std::string anchor, std::size_t most = 2000) : anchor_(std::move(anchor)), most_(most) {}

  /// The id of a feature; empty if there are too many.
  std::string of(bool of_a, const Feature& feature);
  /// By body and feature.
  [[nodiscard]] const std::map<std::pair<bool, Feature>, std::string>& all() const { return ids_; }

 private:
  std::string anchor_;
  std::size_t most_;
  std::map<std::pair<bool, Feature>, std::string> ids_;
};

/// A row of the table of coincidences.
struct CoincidenceRow {
  std::string kind;                 ///< its name, as spoken
  std::uint64_t number;             ///< among those of its kind, from 1 on
  std::string a, b;                 ///< markup: the features
  std::vector<std::string> lights;  ///< the ids that the row lights
};

/// A table that can be filtered, with what is not listed and the names of what there is none of.
std::string coincidences_part(const std::string& anchor, const std::vector<CoincidenceRow>& rows,
                              const std::vector<std::pair<std::string, std::uint64_t>>& counts);

/// The zeros of the predicates, and which monomials decided.
std::string predicates_part(const PredicateCounts& counts);

/// The picture of the bodies, with its legend; empty if there is none. The features of `marks` are in it.
std::string study_figure(const Case& pair, const Depth& depth, const Marks& marks, const std::string& anchor);
std::string study_figure(const Case& pair, const SignedDepth& depth, const std::string& anchor);

}  // namespace fathom::cli
