// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of fields: one row for each member of a struct, with its name, meaning, unit and first
// version. Writers, readers and tests go through a table; none of them lists the fields again.
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace fathom::text {

inline constexpr std::string_view first_version = "0.1.0";

/// A member of a struct, as all know it who hand it out or take it.
template <class Struct, class Value>
struct Field {
  std::string_view name;  ///< in JSON and in Python
  Value Struct::*member;  ///< where it is
  std::string_view unit;  ///< "length", "length^2", "ratio", "ratio^2", "ulp", "uR", "us"; empty of what is no number
  std::string_view meaning;  ///< one sentence; the schema's description
  std::string_view since;    ///< the first version of fathom that has it
  std::string_view label;    ///< what stands before it among the residuals of a page; empty if it is none
  /// whether a struct has it; null of optional members, and of those that are always there
  bool (*there)(const Struct&);
  static constexpr bool stored = true;
};

/// What is calculated from a struct, and handed out with it.
template <class Struct, class Value>
struct Derived {
  std::string_view name;
  Value (*value)(const Struct&);
  std::string_view unit, meaning;
  std::string_view since = first_version;
  static constexpr bool stored = false;
};

template <class Struct, class Value>
constexpr Field<Struct, Value> field(std::string_view name, Value Struct::*member, std::string_view unit,
                                     std::string_view meaning, std::string_view label = "",
                                     std::type_identity_t<bool (*)(const Struct&)> there = nullptr,
                                     std::string_view since = first_version) {
  return {name, member, unit, meaning, since, label, there};
}

template <class Struct, class Value>
Value value_of(const Derived<Struct, Value>& field, const Struct& of) {
  return field.value(of);
}
template <class Struct, class Value>
const Value& value_of(const Field<Struct, Value>& field, const Struct& of) {
  return of.*field.member;
}

/// Whether the struct has the field.
template <class Row, class Struct>
bool has(const Row& field, const Struct& of) {
  if constexpr (requires { field.there; }) {
    if (field.there) return field.there(of);
  }
  if constexpr (requires { value_of(field, of).has_value(); }) return value_of(field, of).has_value();
  if constexpr (std::is_pointer_v<std::decay_t<decltype(value_of(field, of))>>) return value_of(field, of) != nullptr;
  return true;
}

template <class... Rows, class Use>
constexpr void for_each_field(const std::tuple<Rows...>& fields, Use use) {
  std::apply([&](const auto&... field) { (use(field), ...); }, fields);
}

/// The names in a table, each once: of "witness.a" and "witness.b" the one of their object.
template <class... Rows>
std::vector<std::string_view> names_of(const std::tuple<Rows...>& fields) {
  std::vector<std::string_view> names;
  for_each_field(fields, [&](const auto& field) {
    const std::string_view name = field.name.substr(0, field.name.find('.'));
    if (names.empty() || names.back() != name) names.push_back(name);
  });
  return names;
}

/// How many members of a table are stored, not calculated.
template <class... Rows>
constexpr std::size_t stored_fields(const std::tuple<Rows...>&) {
  return (std::size_t{0} + ... + std::size_t{Rows::stored});
}

/// What stands for any member when members are counted.
struct AnyMember {
  template <class T>
  operator T() const;
};

/// How many members an aggregate has: the most that it can be made from.
template <class Struct, class... Members>
constexpr std::size_t member_count() {
  if constexpr (requires { Struct{std::declval<Members>()..., AnyMember()}; })
    return member_count<Struct, Members..., AnyMember>();
  else return sizeof...(Members);
}

}  // namespace fathom::text
