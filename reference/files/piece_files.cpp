// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body from a file with groups, or from a folder of files. The reader of groups is in obj.cpp.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>

#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "reference/files/natural_order.hpp"
#include "reference/files/source.hpp"

namespace fathom {
namespace {

bool is_mesh_name(const std::string& name) {
  const std::string kind = files::extension(name);
  return kind == "off" || kind == "obj" || kind == "ply" || kind == "stl";
}

/// The mesh files in it, hidden ones and those in folders within left out.
std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code fault;
  for (std::filesystem::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
    const std::string name = entry->path().filename();
    std::error_code unknown;  // then reading it says why
    if (is_mesh_name(name) && !name.starts_with('.') && !entry->is_directory(unknown)) names.push_back(name);
  }
  if (fault) throw InputError(folder, 0, "expected a readable folder, found '" + fault.message() + "'");
  std::sort(names.begin(), names.end(), files::natural_less);
  return names;
}

}  // namespace

Pieces read_pieces(const std::string& path, Decimals decimals) {
  if (!files::is_folder(path)) return parse_pieces(files::read_file(path), path, decimals);
  Pieces pieces;
  for (const std::string& name : names_in(path)) {
    const std::string file = path + (path.ends_with('/') ? "" : "/") + name;
    if (files::extension(name) == "obj")
      std::ranges::move(parse_pieces(files::read_file(file), file, decimals), std::back_inserter(pieces));
    else pieces.push_back(read_mesh(file, decimals).points);
  }
  if (pieces.empty()) throw InputError(path, 0, "expected a folder with mesh files (.off, .obj, .ply, .stl), the pieces, found none there");
  return pieces;
}

}  // namespace fathom
