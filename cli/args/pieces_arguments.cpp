// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/pieces_arguments.hpp"

#include <fmt/format.h>

namespace fathom::cli {
namespace {

/// What unions have no place for.
constexpr const char* of_convex_bodies[] = {"--method", "--closest-lines", "--seed", "--bits", "--optima", "--along",
                                            "--steps",  "--times",         "--csv",  "--case", "--threads"};

}  // namespace

void add_pieces_option(CLI::App& app, Request& request, const std::string& more) {
  app.add_flag(
      "--pieces", request.pieces,
      "each body is the union of convex pieces, each of which stands for its hull: the groups of an OBJ file, or the mesh files of a "
      "folder; another mesh, or a shape, is one piece" +
          more);
}

std::string wrong_pieces(const CLI::App& asked, const Request& request) {
  const auto given = [&](const char* option) {
    const CLI::Option* known = asked.get_option_no_throw(option);
    return known != nullptr && known->count() > 0;
  };
  for (const char* option : of_convex_bodies)
    if (given(option)) return fmt::format("--pieces is about unions, and cannot be combined with {}", option);
  if (request.inputs.size() != 2) return "--pieces expects two bodies: OBJ files, folders of meshes, meshes or shapes, found one input";
  return "";
}

}  // namespace fathom::cli
