// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/case_faces.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "kernels/printable.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

using Json = nlohmann::json;

std::string shown(const Json& value) {
  constexpr std::size_t readable = 40;
  return kernels::printable(value.dump(-1, ' ', true, Json::error_handler_t::replace), readable);
}

std::string take_faces(const Json& faces, const std::string& path, Body& body) {
  if (faces.is_null()) return "";
  if (!faces.is_array()) return path + ": expected an array of faces, found " + shown(faces);
  MeshFaces read;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::string place = path + "[" + std::to_string(i) + "]";
    if (!faces[i].is_array()) return place + ": expected an array of vertex indices, found " + shown(faces[i]);
    for (const Json& index : faces[i]) {
      if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= body.points.size())
        return place + ": expected vertex indices below " + std::to_string(body.points.size()) + ", found " + shown(index);
      read.corners.push_back(index.get<std::uint32_t>());
    }
    read.ends.push_back(static_cast<std::uint32_t>(read.corners.size()));
  }
  body.faces = faces_of(std::move(read));
  return "";
}

}  // namespace

std::string read_faces(std::string_view text, const char* name, Body& body) {
  return take_faces(Json::parse(text).at(name).at("faces"), std::string(name) + ".faces", body);
}

std::string read_array_of_faces(std::string_view text, const std::string& path, Body& body) {
  return take_faces(Json::parse(text), path, body);
}

}  // namespace fathom::files
