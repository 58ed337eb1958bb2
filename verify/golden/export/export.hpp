// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a release of polytopes or of polygons, or a file of the user's own cases, and a selection
//         among them.
// Output  one file with these cases, for the tests of other projects, and their certificates. The
//         same input and request give the same bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/monitor.hpp"

namespace fathom::golden {

enum class ExportFormat { c, csv, json, rust };

inline constexpr std::array export_formats = {ExportFormat::c, ExportFormat::csv, ExportFormat::json,
                                              ExportFormat::rust};

/// "c", "csv", "json", "rust".
std::string_view name_of(ExportFormat format);
std::optional<ExportFormat> find_export_format(std::string_view name);

/// The selection of cases, and the format.
struct ExportRequest {
  ExportFormat format = ExportFormat::json;
  std::vector<std::string> excluded;   ///< words of `has_word`: leave out what has one
  std::vector<std::string> only;       ///< likewise: take only what has one; empty: all, here and below
  std::vector<std::string> families;   ///< names of groups, or patterns as of a shell: touching_*
  std::vector<std::string> contacts;   ///< names of kinds of contact: take only what has an optimum of one
  std::string exact_in;                ///< "binary32": take only points that are numbers of this format
  bool certificates = false;           ///< whether to export the certificates too
  std::size_t most_points = SIZE_MAX;  ///< of each body
  std::size_t count = SIZE_MAX;        ///< the most cases, spread evenly over the families
};

// ---- cases ----

/// A record as exports represent it: all that a test of a program in doubles needs. Only the exact
/// square is not a double.
struct ExportCase {
  std::string name, group;  ///< the record's id; the family, "catalogue" or "real"; for the user's own cases "own"
  std::string status;
  double signed_depth = 0;  ///< correctly rounded to nearest: the depth, 0, or minus the distance
  std::string squared;      ///< its square, exact
  std::vector<std::string> flags;
  std::vector<std::string> formats;   ///< the formats that represent the points: binary64, or both that and binary32
  std::vector<std::string> contacts;  ///< the kinds of all optima's contacts, each once; none unless penetrating
  double size = 0;                    ///< the longest side of the bodies' boxes, correctly rounded
  double largest = 0;                 ///< the largest magnitude of a coordinate
  std::vector<std::array<double, 3>> a, b;
  /// unit vectors, rounded: of all optima, or the one direction of the record
  std::vector<std::array<double, 3>> directions;
  /// For records of contacts, for each direction: the corners on A of all contact points, each
  /// coordinate correctly rounded.
  std::vector<std::vector<std::array<double, 3>>> patches = {};
  /// For these, if the signed depth is smooth: its gradient by A's translation, and by A's rotation
  /// about the origin, correctly rounded.
  std::optional<std::array<std::array<double, 3>, 2>> gradient = std::nullopt;
  unsigned dimension = 3;  ///< 2 of bodies of the plane: then each z above is 0, and is not written
};

/// Returns the record of polytopes, or of polygons of the plane, in this form. Returns nullopt if a
/// coordinate is not binary64, or a number to export is beyond binary64. Throws NotARecord, also
/// for a text that the writer of records never writes.
std::optional<ExportCase> export_case(std::string_view line);

/// Returns the words that select cases: the flags, their first words ("flat"), and every status.
std::vector<std::string> words_of_cases();

/// The names of the groups of a release: its families, "catalogue" and "real".
std::vector<std::string> groups_of_releases();

struct Exported {
  std::string text, certificates;                    ///< the certificates of the chosen cases, one after another
  std::size_t chosen = 0, fitting = 0, records = 0;  ///< of the records in the release, or of the cases in the file
  /// numbers of cases that do not fit, each counted for one reason, in this order
  std::size_t not_doubles = 0, excluded = 0, too_large = 0;
};

/// Reads the folder twice, so that memory is bounded by the size of the export. Throws FolderError
/// if the release is not one of polytopes or polygons, or no record fits; FileError for unreadable
/// files, for records that are none, and for contents that differ from the release's pages;
/// Interrupted.
Exported export_release(const std::filesystem::path& folder, const ExportRequest& request, Monitor* monitor = nullptr);

/// Answers each case of a file of polytopes once, and certifies the answers; `path` may be "-".
/// Throws InputError if a case cannot be read or is not about polytopes, if its id occurred before
/// or has characters other than letters, digits and . _ -; FolderError if no case fits;
/// Interrupted.
Exported export_own_cases(const std::string& path, const ExportRequest& request, Monitor* monitor = nullptr);

// ---- texts: one file that needs nothing beside it, with decimals that every language reads back
// to the same doubles ----

/// The source of the cases.
struct ExportSource {
  std::string level, version, seed;  ///< of the release; empty for the user's own cases
  std::string file;                  ///< the file of the user's own cases, without its folder; else empty
  std::string command;               ///< that made the export: "fathom golden export --format c --count 50"
};

/// Returns the file, with its last line feed, of at least one case. C: kit/fathom_golden.h, then
/// flat arrays. Rust: kit/fathom_golden.rs, then an array. JSON: golden-export.schema.json.
/// CSV: a line of names, then one for each case; it has no room for the source.
std::string export_text(ExportFormat format, const ExportSource& source, const std::vector<ExportCase>& cases);

/// Returns the shortest decimal that is read back as this finite double, with a point or an
/// exponent: "0.1", "-0.0", "1e+300".
std::string decimal_text(double value);

}  // namespace fathom::golden
