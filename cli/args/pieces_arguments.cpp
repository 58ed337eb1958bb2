// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/pieces_arguments.hpp"

#include <fmt/format.h>

#include "kernels/printable.hpp"
#include "reference/files/source.hpp"

namespace fathom::cli {
namespace {

/// What unions have no place for.
constexpr const char* of_convex_bodies[] = {"--method", "--closest-lines",  "--seed",   "--bits",  "--pose-a",
                                            "--pose-b", "--require-convex", "--optima", "--along", "--steps",
                                            "--times",  "--schema",         "--csv",    "--case",  "--threads"};

}  // namespace

void add_pieces_option(CLI::App& app, Request& request, const std::string& more) {
  app.add_flag(
      "--pieces", request.pieces,
      "each body is the union of convex pieces, each of which stands for its hull: the groups of an OBJ file, or the mesh files of a "
      "folder" +
          more);
}

std::string wrong_pieces(const CLI::App& asked, const Request& request) {
  const auto given = [&](const char* option) {
    const CLI::Option* known = asked.get_option_no_throw(option);
    return known != nullptr && known->count() > 0;
  };
  for (const char* option : of_convex_bodies)
    if (given(option)) return fmt::format("--pieces is about unions, and cannot be combined with {}", option);
  if (request.inputs.size() != 2) return "--pieces expects two OBJ files or folders, found one input";
  for (const std::string& input : request.inputs)
    if (files::extension(input) != "obj" && !files::is_folder(input))
      return "--pieces expects OBJ files, whose groups are the pieces, or folders of mesh files, found " + kernels::shown(input);
  return "";
}

}  // namespace fathom::cli
