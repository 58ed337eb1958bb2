// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/misspelt_fields.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "kernels/near_miss.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string_view>;

constexpr std::array<std::string_view, 8> of_cases = {"schema", "id", "a", "b", "pose_rounding", "flags", "source", "comment"};
constexpr std::array<std::string_view, 7> of_bodies = {"vertices", "faces", "pose", "shape", "margin", "pose_rounding", "pieces"};
constexpr std::array<std::string_view, 7> of_poses = {"translation", "quaternion", "xyz", "quat", "xyzw", "rpy", "unit"};

void add_fields(const ShapeName& shape, Names& names) {
  for (const NumberField& field : shape.numbers) names.push_back(field.name);
  if (shape.part == ShapePart::axis) names.push_back("axis");
  if (shape.part == ShapePart::terms) names.push_back("terms");
}

const Names& of_any_body() {
  static const Names names = [] {
    Names all(of_bodies.begin(), of_bodies.end());
    for (const ShapeName& shape : shape_names()) add_fields(shape, all);
    return all;
  }();
  return names;
}

template <class Known>
bool is_near_one(std::string_view key, const Known& known) {
  if (std::ranges::find(known, key) != known.end()) return false;
  return std::ranges::any_of(known, [key](std::string_view word) { return kernels::is_near(key, word); });
}

void note(const Json& object, const std::string& path, std::span<const std::string_view> known, std::vector<CaseNote>& notes) {
  std::vector<std::string> there;
  for (const auto& [key, value] : object.items()) there.push_back(key);
  const std::string sentence = kernels::near_misses(there, known);
  if (!sentence.empty()) notes.push_back({CaseNote::field, (path.empty() ? "" : path + ": ") + sentence});
}

}  // namespace

bool looks_misspelt(std::string_view key, bool of_body) { return of_body ? is_near_one(key, of_any_body()) : is_near_one(key, of_cases); }

std::string misspelt_in_pose(std::span<const std::string> keys) { return kernels::near_misses(keys, of_poses); }

std::vector<CaseNote> misspelt_fields(std::string_view text) {
  // Arrays may be large, and are not looked into.
  const auto no_arrays = [](int, Json::parse_event_t event, const Json&) { return event != Json::parse_event_t::array_start; };
  const Json document = Json::parse(text, no_arrays, false);
  std::vector<CaseNote> notes;
  if (!document.is_object()) return notes;
  note(document, "", of_cases, notes);
  for (const char* name : {"a", "b"}) {
    const auto body = document.find(name);
    if (body == document.end() || !body->is_object()) continue;
    Names known(of_bodies.begin(), of_bodies.end());
    const auto shape = body->find("shape");
    if (shape != body->end() && shape->is_string())
      if (const ShapeName* const named = named_shape(shape->get_ref<const std::string&>()).shape) add_fields(*named, known);
    note(*body, name, known, notes);
  }
  return notes;
}

}  // namespace fathom::files
