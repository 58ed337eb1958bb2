// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: the header (ply_header.hpp) says what follows; text and binary bodies differ only in how one value is taken (ply_values.hpp).
// Values are exact whatever their declared type: a binary float is itself, a text "0.1" is read like any other decimal.
#include <algorithm>
#include <array>
#include <utility>

#include "reference/files/mesh_formats.hpp"
#include "reference/files/ply_header.hpp"
#include "reference/files/ply_values.hpp"

namespace fathom::files {
namespace {

bool is_list(const PlyProperty& property) { return property.count_type.has_value(); }

template <class Values>
void skip_property(Values& values, const PlyProperty& property) {
  if (!is_list(property)) return values.skip(property.type, 1);
  const std::int64_t length = values.integer(*property.count_type);
  if (length < 0) values.fail("the length of a list", std::to_string(length));
  values.skip(property.type, static_cast<std::uint64_t>(length));
}

template <class Values>
void read_vertex(Values& values, const PlyElement& element, CollectedPoints& points) {
  std::array<Coordinate, 3> point;
  for (const PlyProperty& property : element.properties) {
    const bool is_coordinate = property.name == "x" || property.name == "y" || property.name == "z";
    if (is_coordinate) point[static_cast<std::size_t>(property.name[0] - 'x')] = values.coordinate(property.type);
    else skip_property(values, property);
  }
  points.add(std::move(point));
}

template <class Values>
void read_face(Values& values, const PlyElement& element, std::uint64_t vertices, MeshFaces& faces) {
  for (const PlyProperty& property : element.properties) {
    if (property.name != "vertex_indices" && property.name != "vertex_index") {
      skip_property(values, property);
      continue;
    }
    const std::int64_t corners = values.integer(*property.count_type);
    if (corners < 0) values.fail("the number of corners of a face", std::to_string(corners));
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t index = values.integer(property.type);
      const bool good = index >= 0 && static_cast<std::uint64_t>(index) < vertices;
      if (!good) values.fail("a vertex index below " + std::to_string(vertices), std::to_string(index));
      faces.corners.push_back(static_cast<std::uint32_t>(index));
    }
    faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
}

// Bytes that one element takes at least: what bounds the room reserved for a count that nobody has checked yet.
std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties)
    size += encoding == PlyEncoding::ascii ? 2 : size_of(property.count_type.value_or(property.type));
  return size;
}

template <class Values>
Body read_elements(Values values, const PlyHeader& header, std::uint64_t vertices) {
  CollectedPoints points;
  MeshFaces faces;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;  // takes no room, whatever its count
    if (element.name == "vertex") reserve_within(points, vertices, values.bytes_left(), least_size(element, header.encoding));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values.begin({&element, i});
      if (element.name == "vertex") {
        read_vertex(values, element, points);
      } else if (element.name == "face") {
        read_face(values, element, vertices, faces);
      } else {
        for (const PlyProperty& property : element.properties) skip_property(values, property);
      }
      values.end();
    }
  }
  values.finish();
  return mesh_body(std::move(points), std::move(faces));
}

// Checks the shape of what will be read; returns the number of vertices.
std::uint64_t require_vertices(const PlyHeader& header, const std::string& name) {
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  const auto refuse = [&](const std::string& expected, const std::string& found) {
    throw InputError(name, header.body_line - 1, "expected " + expected + ", found " + found + " in the header");
  };
  if (vertex == header.elements.end()) refuse("an element 'vertex'", "none");
  for (const PlyElement& element : header.elements) {
    const bool again = element.name == "vertex" && &element != &*vertex;
    if (again) refuse("one element 'vertex'", "two");
    for (const PlyProperty& property : element.properties) {
      const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
      if (element.name == "face" && indices && !(is_list(property) && is_integer(property.type)))
        refuse("'" + property.name + "' to be a list of integers", "another type");
    }
  }
  for (const std::string coordinate : {"x", "y", "z"}) {
    const auto count = std::ranges::count(vertex->properties, coordinate, &PlyProperty::name);
    const auto property = std::ranges::find(vertex->properties, coordinate, &PlyProperty::name);
    if (count != 1) refuse("one property '" + coordinate + "' of the vertices", std::to_string(count));
    if (is_list(*property)) refuse("'" + coordinate + "' to be a number", "a list");
  }
  if (vertex->count == 0) refuse("at least one vertex", "0");
  return vertex->count;
}

}  // namespace

Body parse_ply(std::string_view bytes, const std::string& name, Decimals decimals) {
  const PlyHeader header = parse_ply_header(bytes, name);
  const std::uint64_t vertices = require_vertices(header, name);
  if (header.encoding == PlyEncoding::ascii) return read_elements(TextValues(bytes, name, header, decimals), header, vertices);
  return read_elements(BinaryValues(bytes, name, header), header, vertices);
}

}  // namespace fathom::files
