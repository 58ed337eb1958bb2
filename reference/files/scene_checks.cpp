// SPDX-License-Identifier: GPL-3.0-or-later
// What is checked of a scene's file before Assimp sees it, so that an error names its place: that
// glTF's parts name each other rightly, hold finite numbers and lie in buffers that are there (it
// would leave out a face with a wrong corner, and take integers for floats), that COLLADA is
// well-formed XML, and that 3MF is a whole ZIP archive.
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/scene_files.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::files {
namespace {

using text::JsonValue;

std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t size = 4) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// The bytes that `text` stands for in base 64; nullopt if it is none.
std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t held = 0, bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    held = (held << 6) | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>((held >> bits) & 0xFF));
  }
  return bytes;
}

/// "%20" is a blank.
std::string without_percents(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      return std::string_view("0123456789abcdef").find(kernels::lower(uri[at]));
    };
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && digit(i + 1) < 16 && digit(i + 2) < 16;
    path.push_back(escape ? static_cast<char>(16 * digit(i + 1) + digit(i + 2)) : uri[i]);
    i += escape ? 2 : 0;
  }
  return path;
}

// ---- glTF ----

class GltfCheck {
 public:
  GltfCheck(CheckedScene& scene, const std::string* folder) : scene_(scene), folder_(folder) {}

  void run(std::string_view json, std::optional<std::string_view> chunk) {
    text::JsonRead read = text::read_json(json);
    if (!read.whole) throw InputError(scene_.name, 1 + line_of(json, read.error_at), "glTF: " + read.error);
    root_ = std::move(read.value);
    if (!root_.is_object()) fail("its JSON", "an object", "none");
    const JsonValue* const asset = root_.find("asset");
    const JsonValue* const version = asset ? asset->find("version") : nullptr;
    if (!version || !version->text().starts_with("2.")) fail("asset.version", "2.0", shown(version));
    check_extensions();
    check_buffers(chunk);
    check_nodes();
    faces_.resize(count("meshes"));
    for (std::size_t i = 0; i < count("meshes"); ++i) check_mesh(i);
    scene_.faces = faces_of_scene();
    if (count("skins") > 0 || morphs_)
      scene_.notes.emplace_back("skins and morph targets are not applied: meshes are taken as they are stored");
  }

 private:
  using Natural = std::uint64_t;
  static constexpr Natural no_limit = Natural{1} << 40;

  static std::size_t line_of(std::string_view text, std::size_t at) {
    return static_cast<std::size_t>(std::ranges::count(text.substr(0, at), '\n'));
  }
  [[noreturn]] void fail(const std::string& place, const std::string& expected, const std::string& found) const {
    throw InputError(scene_.name, 0, place + ": expected " + expected + ", found " + found);
  }
  static std::string shown(const JsonValue* value) { return value ? kernels::shown(value->text()) : "none"; }

  std::size_t count(std::string_view list) const {
    const JsonValue* const all = root_.find(list);
    return all ? all->items().size() : 0;
  }
  static std::string item(std::string_view list, std::size_t i) {
    return std::string(list) + "[" + std::to_string(i) + "]";
  }
  const JsonValue& at(std::string_view list, std::size_t i) const { return root_.find(list)->items()[i]; }

  Natural natural(const JsonValue* value, const std::string& place, Natural below, const std::string& what) const {
    Natural found = 0;
    if (value && value->is_natural() && parse_count(value->text(), found) && found < below) return found;
    fail(place, what, shown(value));
  }
  Natural size_field(const JsonValue& of, const char* field, const std::string& place, bool required) const {
    const JsonValue* const value = of.find(field);
    if (!value && !required) return 0;
    return natural(value, place + "." + field, no_limit, "a number of bytes or items");
  }
  /// An index into a list of the file.
  std::size_t index(const JsonValue* value, const std::string& place, std::string_view list) const {
    return natural(value, place, count(list),
                   "an index below " + std::to_string(count(list)) + " of " + std::string(list));
  }

  void check_extensions() const {
    const JsonValue* const required = root_.find("extensionsRequired");
    if (!required) return;
    for (const JsonValue& one : required->items())
      if (const std::string word = one.text(); !word.starts_with("KHR_materials_") &&
                                               !word.starts_with("KHR_texture_") && !word.starts_with("KHR_lights_") &&
                                               !word.starts_with("EXT_texture_"))
        fail("extensionsRequired", "extensions of materials, textures and lights alone", kernels::shown(word));
  }

  std::string buffer_beside(const std::string& uri, const std::string& place) {
    const std::string file = without_percents(uri);
    if (file.empty() || file == "." || file == ".." ||
        file.find_first_of(std::string_view("/\\:\0", 4)) != std::string::npos)
      fail(place, "a file in the folder of this one, by its name alone", kernels::shown(uri));
    if (!folder_) fail(place, "a buffer within the file, as it is read from memory", kernels::shown(uri));
    const std::string path = (std::filesystem::path(*folder_) / file).string();
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) fail(place, "a file beside this one", kernels::shown(uri));
    return scene_.beside[uri] = read_file(path);
  }

  void check_buffers(std::optional<std::string_view> chunk) {
    for (std::size_t i = 0; i < count("buffers"); ++i) {
      const std::string place = item("buffers", i);
      const JsonValue &buffer = at("buffers", i), *const uri = buffer.find("uri");
      std::string& bytes = buffers_.emplace_back();
      if (!uri) {
        if (i > 0 || !chunk) fail(place + ".uri", "where its bytes are", "none");
        bytes = *chunk;
      } else if (const std::string text = uri->text(); text.starts_with("data:")) {
        const std::size_t comma = text.find(";base64,");
        std::optional<std::string> decoded;
        if (comma != std::string::npos) decoded = from_base64(std::string_view(text).substr(comma + 8));
        if (!decoded) fail(place + ".uri", "data in base 64", kernels::shown(text));
        bytes = *std::move(decoded);
      } else {
        bytes = buffer_beside(text, place + ".uri");
      }
      if (const Natural length = size_field(buffer, "byteLength", place, true); length > bytes.size())
        fail(place, std::to_string(length) + " bytes", std::to_string(bytes.size()) + " bytes");
    }
  }

  /// Each node has one parent at most, so that what a scene names is a tree.
  void check_nodes() const {
    if (count("scenes") == 0) fail("scenes", "at least one scene", "none");
    std::vector<std::size_t> parents(count("nodes"));
    const auto each = [&](const JsonValue& of, const char* field, const std::string& place, const auto& f) {
      const JsonValue* const list = of.find(field);
      for (std::size_t i = 0; list && i < list->items().size(); ++i) {
        const std::string here = place + "." + item(field, i);
        f(index(&list->items()[i], here, "nodes"), here);
      }
    };
    for (std::size_t i = 0; i < count("nodes"); ++i) {
      const JsonValue& node = at("nodes", i);
      if (const JsonValue* const mesh = node.find("mesh")) index(mesh, item("nodes", i) + ".mesh", "meshes");
      each(node, "children", item("nodes", i), [&](std::size_t child, const std::string& place) {
        if (parents[child]++ > 0) fail(place, "a node that has no other parent", std::to_string(child));
      });
    }
    const JsonValue* const chosen = root_.find("scene");
    if (chosen) index(chosen, "scene", "scenes");
    for (std::size_t i = 0; i < count("scenes"); ++i)
      each(at("scenes", i), "nodes", item("scenes", i), [&](std::size_t root, const std::string& place) {
        if (parents[root] > 0) fail(place, "a node without a parent", std::to_string(root));
      });
  }

  /// The elements of an accessor: where each begins.
  struct Elements {
    std::string_view bytes;
    Natural count, stride;
  };

  Elements elements(std::size_t i, const char* type, std::size_t size) const {
    const JsonValue& accessor = at("accessors", i);
    const std::string place = item("accessors", i);
    const JsonValue* const typed = accessor.find("type");
    if (!typed || typed->text() != type) fail(place + ".type", type, shown(typed));
    if (accessor.find("sparse")) fail(place, "values in a bufferView", "a sparse accessor");
    const std::size_t view_index = index(accessor.find("bufferView"), place + ".bufferView", "bufferViews");
    const JsonValue& view = at("bufferViews", view_index);
    const std::string view_place = item("bufferViews", view_index);
    const std::string& buffer = buffers_[index(view.find("buffer"), view_place + ".buffer", "buffers")];
    const Natural begin = size_field(view, "byteOffset", view_place, false),
                  length = size_field(view, "byteLength", view_place, true),
                  items = size_field(accessor, "count", place, true),
                  offset = size_field(accessor, "byteOffset", place, false),
                  given = size_field(view, "byteStride", view_place, false), stride = given ? given : size;
    if (begin + length > buffer.size())
      fail(view_place, "bytes within its buffer of " + std::to_string(buffer.size()),
           "an end at " + std::to_string(begin + length));
    if (items == 0 || stride < size || items > length || offset + stride * (items - 1) + size > length)
      fail(place, "at least one element, within its bufferView of " + std::to_string(length) + " bytes",
           std::to_string(items) + " of " + std::to_string(stride) + " bytes each");
    return {std::string_view(buffer).substr(begin + offset, stride * (items - 1) + size), items, stride};
  }

  Natural check_positions(const JsonValue* accessor, const std::string& place) {
    const std::size_t i = index(accessor, place, "accessors");
    const JsonValue* const component = at("accessors", i).find("componentType");
    if (!component || component->text() != "5126")
      fail(item("accessors", i) + ".componentType", "5126, floats, for positions", shown(component));
    const Elements all = elements(i, "VEC3", 12);
    for (Natural k = 0; k < all.count; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        if (const float x = std::bit_cast<float>(little_endian(all.bytes, k * all.stride + 4 * c)); !std::isfinite(x))
          fail(place, "finite numbers", std::string(std::isnan(x) ? "nan" : "inf") + " in vertex " + std::to_string(k));
    return all.count;
  }

  /// Returns the number of corners.
  Natural check_indices(const JsonValue* accessor, const std::string& place, Natural vertices) const {
    const std::size_t i = index(accessor, place, "accessors");
    const JsonValue* const component = at("accessors", i).find("componentType");
    const std::string code = component ? component->text() : "";
    const std::size_t size = code == "5121" ? 1 : code == "5123" ? 2 : code == "5125" ? 4 : 0;
    if (size == 0) fail(item("accessors", i) + ".componentType", "5121, 5123 or 5125, for indices", shown(component));
    const Elements all = elements(i, "SCALAR", size);
    if (all.stride != size) fail(place, "indices one after another", "a byteStride of " + std::to_string(all.stride));
    for (Natural k = 0; k < all.count; ++k)
      if (const std::uint32_t corner = little_endian(all.bytes, k * size, size); corner >= vertices)
        fail(place, "a vertex index below " + std::to_string(vertices),
             std::to_string(corner) + " as number " + std::to_string(k));
    return all.count;
  }

  void check_mesh(std::size_t i) {
    const JsonValue* const primitives = at("meshes", i).find("primitives");
    const std::size_t parts = primitives ? primitives->items().size() : 0;
    if (parts == 0) fail(item("meshes", i) + ".primitives", "at least one", "none");
    for (std::size_t k = 0; k < parts; ++k) {
      const JsonValue& one = primitives->items()[k];
      const std::string place = item("meshes", i) + "." + item("primitives", k);
      const JsonValue* const attributes = one.find("attributes");
      const Natural vertices =
          check_positions(attributes ? attributes->find("POSITION") : nullptr, place + ".attributes.POSITION");
      const JsonValue *const indices = one.find("indices"), *const mode = one.find("mode");
      const Natural corners = indices ? check_indices(indices, place + ".indices", vertices) : vertices;
      const Natural kind = mode ? natural(mode, place + ".mode", 7, "a number from 0 to 6") : 4;
      if (kind == 4 && corners % 3 != 0)
        fail(place, "three corners for each triangle", std::to_string(corners) + " corners");
      if (kind > 4 && corners < 3) fail(place, "at least three corners", std::to_string(corners));
      faces_[i] += kind == 4 ? corners / 3 : kind > 4 ? corners - 2 : 0;
      morphs_ = morphs_ || one.find("targets");
    }
  }

  /// Of all its nodes, which are checked.
  Natural faces_of_scene() const {
    Natural faces = 0, next = 0;
    if (const JsonValue* const chosen = root_.find("scene")) parse_count(chosen->text(), next);
    std::vector<const JsonValue*> lists{at("scenes", next).find("nodes")};
    while (!lists.empty()) {
      const JsonValue* const list = lists.back();
      lists.pop_back();
      for (std::size_t i = 0; list && i < list->items().size(); ++i) {
        parse_count(list->items()[i].text(), next);
        const JsonValue &node = at("nodes", next), *const mesh = node.find("mesh");
        if (mesh && parse_count(mesh->text(), next)) faces += faces_[next];
        lists.push_back(node.find("children"));
      }
    }
    return faces;
  }

  CheckedScene& scene_;
  const std::string* folder_;
  JsonValue root_;
  std::vector<std::string> buffers_;
  std::vector<Natural> faces_;  // of each mesh
  bool morphs_ = false;
};

void check_glb(CheckedScene& scene, const std::string* folder) {
  const std::string_view bytes = scene.bytes;
  const auto fail = [&](const std::string& expected, const std::string& found) {
    throw InputError(scene.name, 0, "expected " + expected + ", found " + found);
  };
  if (bytes.size() < 20 || !bytes.starts_with("glTF"))
    fail("a header 'glTF' of 12 bytes and a chunk of JSON", kernels::shown(bytes));
  if (little_endian(bytes, 4) != 2) fail("version 2 of GLB", std::to_string(little_endian(bytes, 4)));
  if (little_endian(bytes, 8) != bytes.size())
    fail(std::to_string(little_endian(bytes, 8)) + " bytes, as the header says", std::to_string(bytes.size()));
  std::vector<std::string_view> chunks;
  for (std::size_t at = 12; at + 8 <= bytes.size(); at += 8 + chunks.back().size()) {
    const std::size_t size = little_endian(bytes, at);
    if (size > bytes.size() - at - 8)
      fail("a chunk of " + std::to_string(size) + " bytes at byte " + std::to_string(at), "the end of the file");
    const std::string_view type = bytes.substr(at + 4, 4),
                           wanted = chunks.empty() ? "JSON" : std::string_view("BIN\0", 4);
    if (chunks.size() < 2 && type != wanted)
      fail("a chunk " + kernels::shown(wanted) + " at byte " + std::to_string(at), kernels::shown(type));
    chunks.push_back(bytes.substr(at + 8, size));
  }
  GltfCheck(scene, folder).run(chunks.at(0), chunks.size() > 1 ? std::optional(chunks[1]) : std::nullopt);
}

// ---- XML ----

/// An element that begins: its name, what stands beside it in its tag, and the text up to the next
/// tag.
struct XmlElement {
  std::string_view name, attributes, text;
  std::size_t line;
};

/// Calls `f` with each element. Throws InputError unless tags are closed in their order. Entities
/// and attributes are left to the parser proper.
void for_each_element(std::string_view text, const std::string& name, const std::function<void(const XmlElement&)>& f) {
  std::vector<XmlElement> open;
  std::size_t line = 1, counted = 0, at = 0;
  const auto fail = [&](const std::string& expected, const std::string& found) {
    throw InputError(name, line, "expected " + expected + ", found " + found);
  };
  const auto count_to = [&](std::size_t to) {
    line += static_cast<std::size_t>(std::ranges::count(text.substr(counted, to - counted), '\n'));
    counted = to;
  };
  const auto skip_to = [&](std::string_view end) {
    const std::size_t found = text.find(end, at);
    if (found == std::string_view::npos) fail("'" + std::string(end) + "'", "the end of the file");
    at = found + end.size();
  };
  bool any = false;
  while ((at = text.find('<', at)) != std::string_view::npos) {
    count_to(at);
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) skip_to("-->");
    else if (rest.starts_with("<![CDATA[")) skip_to("]]>");
    else if (rest.starts_with("<?")) skip_to("?>");
    else if (rest.starts_with("<!")) skip_to(">");
    else {
      std::size_t end = at + 1;
      for (char quote = '\0'; end < text.size() && (quote || text[end] != '>'); ++end)
        quote = quote ? (text[end] == quote ? '\0' : quote) : text[end] == '"' || text[end] == '\'' ? text[end] : '\0';
      if (end == text.size()) fail("'>'", "the end of the file");
      std::string_view tag = text.substr(at + 1, end - at - 1);
      at = end + 1;
      const bool closes = tag.starts_with('/'), empty = tag.ends_with('/');
      if (closes) tag.remove_prefix(1);
      if (empty) tag.remove_suffix(1);
      const std::size_t blank = std::min(tag.find_first_of(" \t\r\n"), tag.size());
      const std::string_view word = tag.substr(0, blank);
      if (closes) {
        if (open.empty()) fail("no end of an element", kernels::shown(word));
        if (open.back().name != word)
          fail("'</" + kernels::printable(open.back().name, kernels::readable) + ">', for line " +
                   std::to_string(open.back().line),
               "'</" + kernels::printable(word, kernels::readable) + ">'");
        open.pop_back();
        continue;
      }
      if (open.empty() && std::exchange(any, true)) fail("one element around all", kernels::shown(word));
      const XmlElement element{word, tag.substr(blank),
                               trimmed(text.substr(at, std::min(text.find('<', at), text.size()) - at)), line};
      f(element);
      if (!empty) open.push_back(element);
    }
  }
  count_to(text.size());
  if (!open.empty())
    fail("'</" + kernels::printable(open.back().name, kernels::readable) + ">', for line " +
             std::to_string(open.back().line),
         "the end of the file");
  if (!any) fail("an element of XML", kernels::shown(text));
}

std::string attribute(const XmlElement& element, const std::string& name) {
  std::size_t at = element.attributes.find(name + "=");
  if (at == std::string_view::npos) return "";
  at += name.size() + 1;
  if (at >= element.attributes.size()) return "";
  const std::size_t end = element.attributes.find(element.attributes[at], at + 1);
  return std::string(element.attributes.substr(at + 1, end - at - 1));
}

void check_collada(CheckedScene& scene) {
  bool first = true;
  for_each_element(scene.bytes, scene.name, [&](const XmlElement& element) {
    const auto fail = [&](const std::string& expected, const std::string& found) {
      throw InputError(scene.name, element.line, "expected " + expected + ", found " + found);
    };
    if (std::exchange(first, false) && element.name != "COLLADA")
      fail("the element COLLADA", kernels::shown(element.name));
    if (element.name.starts_with("instance_"))
      if (const std::string url = attribute(element, "url");
          !url.empty() && !url.starts_with('#') && element.name != "instance_effect")
        fail("an element of this file, as url=\"#...\"", kernels::shown(url));
    if (element.name == "unit")
      if (const std::string meter = attribute(element, "meter"); !meter.empty() && meter != "1" && meter != "1.0")
        scene.notes.push_back("its unit of " + kernels::printable(meter, kernels::readable) +
                              " m is applied: coordinates are in metres");
    if (element.name == "up_axis" && element.text != "Y_UP")
      scene.notes.push_back("its up axis is " + kernels::printable(element.text.substr(0, 1), 1) +
                            ": all is turned so that y points up");
    if (element.name == "controller")
      scene.notes.emplace_back("skins are not applied: meshes are taken as they are stored");
  });
}

// ---- 3MF ----

void check_threemf(CheckedScene& scene) {
  constexpr std::size_t end_record = 22, longest_comment = 65535;
  const std::string_view bytes = scene.bytes;
  if (!bytes.starts_with("PK"))
    throw InputError(scene.name, 0, "expected a ZIP archive, found " + kernels::shown(bytes));
  const std::string_view tail = bytes.substr(bytes.size() - std::min(bytes.size(), end_record + longest_comment));
  if (tail.rfind("PK\5\6") == std::string_view::npos)
    throw InputError(scene.name, 0,
                     "expected a ZIP archive with its directory at the end, found " + std::to_string(bytes.size()) +
                         " bytes without one");
  scene.notes.emplace_back(
      "coordinates are in the unit of the file, millimetres unless it names another: Assimp does not tell, and none is "
      "applied");
}

}  // namespace

CheckedScene checked_scene(std::string_view bytes, const std::string& name, MeshFormat format,
                           const std::string* folder) {
  CheckedScene scene{format, name, bytes, {}, {}, {}};
  switch (format) {
    case MeshFormat::gltf:
      if (bytes.starts_with("glTF")) check_glb(scene, folder);
      else GltfCheck(scene, folder).run(bytes, std::nullopt);
      break;
    case MeshFormat::collada: check_collada(scene); break;
    default: check_threemf(scene);
  }
  return scene;
}

}  // namespace fathom::files
