// SPDX-License-Identifier: GPL-3.0-or-later
// What subjects answer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "kernels/near_miss.hpp"
#include "verify/harness/loose_json.hpp"
#include "verify/harness/message_json.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::json;

/// A text, or an integer.
std::string id_in(const Json& reply) {
  const Json* id = field(reply, "id");
  if (!id || !is_number(*id)) return text_in(reply, "id", "the reply");
  const std::optional<std::string> integer = read_integer(written(*id));
  if (!integer) refuse("a text or an integer for \"id\" in the reply", shown_json(*id));
  return *integer;
}

/// The reason in the place of an answer.
std::string reason_in(const Json& reply, const char* name) {
  for (const char* other : {"overlap", "depth", "distance", "direction", "witness", "contacts", "hull", "unsupported", "failed"})
    if (std::string_view(other) != name && field(reply, other))
      refuse(fmt::format("nothing but \"id\" beside \"{}\"", name), fmt::format("\"{}\"", other));
  return text_in(reply, name, "the reply");
}

/// The vertices of one used hull, if there is one.
std::optional<std::vector<Triple>> hull_in(const Json& object, const char* name, const char* called, Precision precision) {
  const Json* list = field(object, name);
  if (!list) return std::nullopt;
  if (!list->is_array() || list->empty()) refuse(fmt::format("a list of vertices for \"{}\"", called), shown_json(*list));
  std::vector<Triple> vertices;
  for (const Json& vertex : *list) {
    const std::optional<Triple> point = triple_in({{"vertex", vertex}}, "vertex", called, precision);
    if (!std::ranges::all_of(*point, [](double x) { return std::isfinite(x); }))
      refuse(fmt::format("finite numbers for \"{}\"", called), shown_json(vertex));
    vertices.push_back(*point);
  }
  return vertices;
}

/// What is beside an answer.
void read_rest(const Json& object, Precision points, SubjectAnswer& answer) {
  if (const Json* hull = field(object, "hull")) {
    if (!hull->is_object()) refuse("an object for \"hull\"", shown_json(*hull));
    answer.hull_a = hull_in(*hull, "a", "hull.a", points);
    answer.hull_b = hull_in(*hull, "b", "hull.b", points);
  }
  const Json* time = field(object, "microseconds");
  if (!time) return;
  const std::optional<double> value = is_number(*time) ? read_number(written(*time), Precision::binary64) : std::nullopt;
  if (value && std::isfinite(*value) && *value >= 0) answer.microseconds = value;
  else answer.remark += (answer.remark.empty() ? "" : "; ") + ("\"microseconds\" is no time: " + shown_json(*time));
}

std::vector<ContactPoint> contacts_in(const Json& list, Precision precision) {
  if (!list.is_array() || list.empty()) refuse("a list of contacts for \"contacts\"", shown_json(list));
  std::vector<ContactPoint> contacts;
  for (const Json& each : list) {
    const std::optional<Triple> position = each.is_object() ? triple_in(each, "position", "position", precision) : std::nullopt;
    if (!position) refuse("an object with a \"position\" in \"contacts\"", shown_json(each));
    contacts.push_back({*position, {}});
    if (const Json* depth = field(each, "depth")) contacts.back().depth = number_of(*depth, "depth", precision);
  }
  return contacts;
}

Reply read_answer(const Json& object, Precision precision) {
  Reply reply;
  reply.overlap = flag_in(object, "overlap", "the reply");
  if (const Json* depth = field(object, "depth")) reply.depth = number_of(*depth, "depth", precision);
  if (const Json* distance = field(object, "distance")) reply.distance = number_of(*distance, "distance", precision);
  reply.direction = triple_in(object, "direction", "direction", precision);
  if (const Json* witness = field(object, "witness")) {
    if (!witness->is_object()) refuse("an object for \"witness\"", shown_json(*witness));
    reply.witness_a = triple_in(*witness, "a", "witness.a", precision);
    reply.witness_b = triple_in(*witness, "b", "witness.b", precision);
  }
  if (const Json* contacts = field(object, "contacts")) reply.contacts = contacts_in(*contacts, precision);
  return reply;
}

/// Of all objects of a reply.
std::string misspelt(const Json& reply) {
  constexpr std::string_view known[] = {"type",    "id",       "overlap", "depth",        "distance",    "direction",
                                        "witness", "contacts", "hull",    "microseconds", "unsupported", "failed"};
  constexpr std::string_view of_witness[] = {"a", "b"}, of_contact[] = {"position", "depth"};
  const auto fields = [](const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) names.push_back(name);
    return names;
  };
  std::string remark = kernels::near_misses(fields(reply), known);
  const auto look_inside = [&](const Json& object, std::span<const std::string_view> names) {
    if (const std::string inside = kernels::near_misses(fields(object), names); !inside.empty())
      remark += (remark.empty() ? "" : "; ") + inside;
  };
  if (const Json* witness = field(reply, "witness")) look_inside(*witness, of_witness);
  if (const Json* contacts = field(reply, "contacts"))
    for (const Json& contact : *contacts) look_inside(contact, of_contact);
  return remark;
}

}  // namespace

SubjectAnswer read_reply(std::string_view line, const NumberFormat& format) {
  const Json object = object_on(line);
  if (text_in(object, "type", "the reply") != "reply") refuse("a message of type \"reply\"", kernels::shown(line));
  SubjectAnswer answer{id_in(object), Failed()};
  if (field(object, "unsupported")) answer.said = Unsupported{reason_in(object, "unsupported")};
  else if (field(object, "failed")) answer.said = Failed{reason_in(object, "failed")};
  else {
    answer.said = read_answer(object, format.answers);
    answer.remark = misspelt(object);
    read_rest(object, format.points, answer);
  }
  return answer;
}

}  // namespace fathom::harness
