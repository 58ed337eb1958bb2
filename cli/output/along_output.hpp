// SPDX-License-Identifier: GPL-3.0-or-later
// The signed depth along a path, for people (a table), for programs (JSON, schemas/along.schema.json), for spreadsheets (CSV), and as a
// chart.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {

/// What is known when A stands at one place of the path.
struct AlongStep {
  std::uint32_t number;
  mpq_class share;                      ///< of the translation that A has been moved by
  std::optional<Status> status;         ///< nullopt if bounds leave it open
  std::variant<Surd, Bounds> value;     ///< the signed depth, exact or enclosed
  double low, high;                     ///< rounded outward
  Vector direction;                     ///< in which the least h(u)/|u| is reached, or at most the upper bound
  std::optional<Contact> contact = {};  ///< as `depth` has it
};

struct Path {
  std::string id;
  Point translation;
  std::uint32_t steps;
};

AlongStep along_step(std::uint32_t number, const mpq_class& share, const Depth& depth);
AlongStep along_step(std::uint32_t number, const mpq_class& share, const SignedDepth& depth);

// Lines are without their newlines.

/// The lines of a table of which `path` says how wide it is.
std::string along_text_header(const Path& path);
std::string along_text_row(const Path& path, const AlongStep& step);
std::string along_csv_header();
std::string along_csv_row(const AlongStep& step);
/// One line, pure ASCII.
std::string along_json(const Path& path, const std::vector<AlongStep>& steps);
/// A file of SVG.
std::string along_svg(const Path& path, const std::vector<AlongStep>& steps);

}  // namespace fathom::cli
