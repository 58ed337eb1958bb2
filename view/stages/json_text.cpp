// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/stages/json_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fathom/numbers.hpp"

namespace fathom::stages {

void StagesText::key(std::string_view name) {
  separate();
  text_ += '"';
  text_ += name;
  text_ += "\":";
  first_ = true;
}

void StagesText::number(double value, int digits) {
  separate();
  value += 0.0;  // -0 becomes 0
  fmt::memory_buffer text;
  if (digits == 0) fmt::format_to(std::back_inserter(text), "{}", value);
  else fmt::format_to(std::back_inserter(text), "{:.{}g}", value, digits);
  text_.append(text.data(), text.size());
}

void StagesText::numbers(const std::array<double, 3>& values, int digits) {
  array([&] {
    for (const double value : values) number(value, digits);
  });
}

void StagesText::exact(const mpq_class& value) { string(exact_text(value)); }

void StagesText::string(std::string_view value) {
  plain(nlohmann::json(value).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

}  // namespace fathom::stages
