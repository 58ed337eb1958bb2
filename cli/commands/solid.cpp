// SPDX-License-Identifier: GPL-3.0-or-later
// fathom solid MESH
// Convex pieces that tile what a closed mesh goes around.

#include "fathom/solid.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/files.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

struct SolidRequest {
  explicit SolidRequest(const Given& given)
      : mesh(given.inputs()[0]),
        output(given.text("--output")),
        certificate(given.text("--certificate")),
        decimals(given.flag("--exact-decimals") ? Decimals::exact : Decimals::binary64),
        exact(given.flag("--exact")),
        json(given.flag("--json")) {}

  std::string mesh, output, certificate;
  Decimals decimals;
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

/// One line, without its newline.
std::string solid_json(const std::string& id, const Solid& solid) {
  output::Json object = output::solid_object(solid);
  return output::Json{{"schema", "fathom/solid/1"}, {"id", id}, {"solid", std::move(object)}}.text();
}

Solid read_solid(const SolidRequest& request) try {
  return solid_of(read_mesh(request.mesh, request.decimals));
} catch (const std::invalid_argument& error) {
  throw InputError(request.mesh, 0, error.what());
}

}  // namespace

ExitCode run_solid(const Given& given) {
  const SolidRequest request(given);
  const std::unique_ptr<CertificateFile> pieces = wanted_file(request.output, "pieces");
  const std::unique_ptr<CertificateFile> proof = wanted_file(request.certificate, "certificate");
  const Solid solid = read_solid(request);
  if (pieces) pieces->write(pieces_obj(solid));
  if (proof) {
    const std::string text = certificate_text(solid, request.mesh);
    require_readable(request.mesh, text);
    proof->write(text);
  }
  print(request.json ? solid_json(request.mesh, solid) : solid_block(solid, request.exact));
  return fine;
}

}  // namespace fathom::cli
