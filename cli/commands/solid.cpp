// SPDX-License-Identifier: GPL-3.0-or-later
// fathom solid MESH
// Convex pieces that tile what a closed mesh goes around; or how far those of others do.

#include "fathom/solid.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

struct SolidRequest {
  explicit SolidRequest(const Given& given)
      : mesh(given.inputs()[0]),
        output(given.text("--output")),
        certificate(given.text("--certificate")),
        judged(given.text("--judge")),
        decimals(given.flag("--exact-decimals") ? Decimals::exact : Decimals::binary64),
        skip_flat(given.flag("--skip-flat")),
        exact(given.flag("--exact")),
        json(given.flag("--json")) {}

  std::string mesh, output, certificate, judged;
  Decimals decimals;
  bool skip_flat;  ///< of the pieces to be judged
  bool exact, json;
};

/// Several lines; without the last newline.
std::string solid_block(const Solid& solid, bool exact) {
  const std::size_t given = given_points(solid);
  const mpq_class size = volume(solid);
  std::vector<Row> rows{
      {"pieces", fmt::format("{}", pieces_of(solid).size())},
      {"points", fmt::format("{} of the mesh, {} where it is cut", given, solid.points.size() - given)},
      {"triangles", fmt::format("{}", solid.triangles.size())},
      {"volume", fmt::format("{}", round_binary64(size))}};
  if (exact) rows.emplace_back("exactly", exact_text(size));
  for (const std::string& note : notes(solid)) rows.emplace_back("note", note);
  return aligned("solid", rows);
}

/// Several lines; without the last newline.
std::string coverage_block(const Solid& solid, const PieceCoverage& found, bool exact) {
  const auto volume_text = [&](const mpq_class& v) {
    return exact ? exact_text(v) : fmt::format("{}", round_binary64(v));
  };
  std::string outside = volume_text(found.outside);
  if (const std::optional<std::size_t> most = found.most_outside())
    outside += fmt::format("; most by piece {}: {}", *most, volume_text(found.outside_of[*most]));
  std::vector<Row> rows{{"pieces", fmt::format("{}", found.outside_of.size())},
                        {"volume", volume_text(volume(solid)) + " of the solid"},
                        {"missing", volume_text(found.missing)},
                        {"outside", outside},
                        {"overlap", volume_text(found.overlap)}};
  if (found.uncovered) rows.emplace_back("uncovered", "such as " + place_text(*found.uncovered, exact));
  if (found.stray) rows.emplace_back("stray", "such as " + place_text(*found.stray, exact));
  for (const std::string& note : notes(solid)) rows.emplace_back("note", note);
  const char* heading = found.tiles()        ? "tiled"
                        : found.same_union() ? "covered, by pieces that overlap"
                                             : "not the solid";
  return aligned(heading, rows);
}

output::Json coverage_object(const PieceCoverage& found) {
  const auto point = [](const std::optional<Point>& p) { return p ? output::exact(*p) : output::Json(); };
  output::Json most;
  if (const std::optional<std::size_t> piece = found.most_outside())
    most = {{"piece", *piece}, {"volume", output::number(found.outside_of[*piece])}};
  return {{"pieces", found.outside_of.size()},
          {"same_union", output::Json::boolean(found.same_union())},
          {"tiles", output::Json::boolean(found.tiles())},
          {"missing", output::number(found.missing)},
          {"outside", output::number(found.outside)},
          {"overlap", output::number(found.overlap)},
          {"most_outside", most},
          {"uncovered", point(found.uncovered)},
          {"stray", point(found.stray)}};
}

/// One line, without its newline.
std::string solid_json(const std::string& id, const Solid& solid, const std::optional<PieceCoverage>& coverage) {
  output::Json line{{"schema", "fathom/solid/1"}, {"id", id}, {"solid", output::solid_object(solid)}};
  if (coverage) line["coverage"] = coverage_object(*coverage);
  return line.text();
}

Solid read_solid(const SolidRequest& request) try {
  return solid_of(mesh_of_input(request.mesh, request.decimals));
} catch (const std::invalid_argument& error) {
  throw InputError(request.mesh, 0, error.what());
}

/// Of the pieces to be judged, if there are some.
std::optional<PieceCoverage> read_coverage(const SolidRequest& request, const Solid& solid) try {
  if (request.judged.empty()) return std::nullopt;
  if (request.skip_flat) return coverage(solid, *union_of_input(request.judged, request.decimals, true).pieces);
  return coverage(solid, read_pieces(request.judged, request.decimals));
} catch (const std::invalid_argument& error) {
  throw InputError(request.judged, 0, error.what());
}

}  // namespace

ExitCode run_solid(const Given& given) {
  const SolidRequest request(given);
  const std::unique_ptr<CertificateFile> pieces = wanted_file(request.output, "pieces");
  const std::unique_ptr<CertificateFile> proof = wanted_file(request.certificate, "certificate");
  const Solid solid = read_solid(request);
  const std::optional<PieceCoverage> judged = read_coverage(request, solid);
  if (pieces) pieces->write(pieces_obj(solid));
  if (proof) {
    const std::string text = certificate_text(solid, request.mesh);
    require_readable(request.mesh, text);
    proof->write(text);
  }
  if (request.json) print(solid_json(request.mesh, solid, judged));
  else print(judged ? coverage_block(solid, *judged, request.exact) : solid_block(solid, request.exact));
  return judged && !judged->tiles() ? judged_wrong : fine;
}

}  // namespace fathom::cli
