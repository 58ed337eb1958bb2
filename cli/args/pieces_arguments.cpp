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
                                            "--svg",    "--schema",         "--csv",    "--case",  "--threads"};

}  // namespace

void add_pieces_option(CLI::App& app, Request& request) {
  app.add_flag("--pieces", request.pieces,
               "each body is the union of convex pieces: the groups of an OBJ file, each of which stands for its hull. With --json one "
               "object, schema fathom/union/1");
}

std::string wrong_pieces(const CLI::App& depth, const Request& request) {
  for (const char* option : of_convex_bodies)
    if (depth.count(option) > 0) return fmt::format("--pieces is about unions, and cannot be combined with {}", option);
  if (request.inputs.size() != 2) return "--pieces expects two OBJ files, found one input";
  for (const std::string& input : request.inputs)
    if (files::extension(input) != "obj") return "--pieces expects OBJ files, whose groups are the pieces, found " + kernels::shown(input);
  return "";
}

}  // namespace fathom::cli
