// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/line_parts.hpp"

#include <array>
#include <string>

#include "verify/golden/records/names.hpp"

namespace fathom::golden {
namespace {

constexpr std::array<std::string_view, 3> mode_names{"rn", "rd", "ru"};

/// put(out, values of one format, mode) writes a value.
template <class Put>
void in_both_formats(JsonText& out, Put put) {
  const auto in_every_mode = [&](std::string_view name, std::array<double, 3> Rounded::*format) {
    out.key(name).open('{');
    for (std::size_t mode = 0; mode < mode_names.size(); ++mode) {
      out.key(mode_names[mode]);
      put(format, mode);
    }
    out.close('}');
  };
  in_every_mode("f64", &Rounded::binary64);
  in_every_mode("f32", &Rounded::binary32);
}

}  // namespace

void write_modes(JsonText& out, const Rounded& value) {
  in_both_formats(out, [&](auto format, std::size_t mode) { out.hex((value.*format)[mode]); });
}

void write_rounded(JsonText& out, std::string_view key, const RoundedVector& vector) {
  out.key(key).open('{');
  in_both_formats(out, [&](auto format, std::size_t mode) {
    out.open('[');
    for (const Rounded& component : vector) out.hex((component.*format)[mode]);
    out.close(']');
  });
  out.close('}');
}

void write_direction(JsonText& out, const Vector& n, const RoundedVector& unit) {
  out.key("direction").exact(n);
  write_rounded(out, "unit", unit);
}

void write_source(JsonText& out, const Recipe& recipe, Form form) {
  out.key("kind").text(name_of(recipe.source)).key("name").text(recipe.name);
  if (from_family(recipe.source)) out.key("size").number(recipe.size).key("seed").text(std::to_string(recipe.seed));
  out.key("form").text(name_of(form));
}

void write_formats(JsonText& out, bool in_binary64, bool in_binary32) {
  out.key("formats").open('[').text("exact");
  if (in_binary64) out.text("binary64");
  if (in_binary32) out.text("binary32");
  out.close(']');
}

}  // namespace fathom::golden
