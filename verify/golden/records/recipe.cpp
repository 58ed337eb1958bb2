// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/recipe.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fathom/numbers.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"
#include "verify/golden/release/real_cases.hpp"

namespace fathom::golden {
namespace {

std::string suffix(Form form) { return form == Form::binary64 ? ".b64" : form == Form::binary32 ? ".b32" : ""; }

double nearest(const mpq_class& value, Form format) {
  return format == Form::binary32 ? double{round_binary32(value, fathom::Rounding::rn)} : round_binary64(value, fathom::Rounding::rn);
}

/// Numbers of a format are m 2^e with |m| < 2^precision, e >= least and |m 2^e| < 2^top.
bool representable(const mpq_class& value, Form format) {
  if (value == 0) return true;
  const long precision = format == Form::binary32 ? 24 : 53, least = format == Form::binary32 ? -149 : -1074;
  const long top = format == Form::binary32 ? 128 : 1024;
  if (mpz_popcount(value.get_den_mpz_t()) != 1) return false;
  const auto length = static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2));
  const auto zeros = static_cast<long>(mpz_scan1(value.get_num_mpz_t(), 0));
  const auto shift = static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2)) - 1;
  return length - zeros <= precision && zeros - shift >= least && length - shift <= top;
}

bool round_in_place(mpq_class& value, Form format) {
  const double rounded = nearest(value, format);
  if (!std::isfinite(rounded)) return false;
  value = exact_value(rounded);
  return true;
}

bool one_point(const Body& body) {
  return std::ranges::all_of(body.points, [&body](const Point& p) { return p == body.points.front(); });
}

template <class Function>
bool all_coordinates(const Body& body, Function function) {
  return std::ranges::all_of(body.points, [&](auto& p) { return function(p.x) && function(p.y) && function(p.z); });
}

}  // namespace

std::string_view name_of(Source source) {
  switch (source) {
    case Source::family: return "family";
    case Source::catalogue: return "catalogue";
    case Source::real: break;
  }
  return "real";
}

std::string id_of(const Recipe& recipe, Form form) {
  if (recipe.source != Source::family) return std::string(name_of(recipe.source)) + "-" + recipe.name + suffix(form);
  return recipe.name + "-n" + std::to_string(recipe.size) + "-s" + std::to_string(recipe.seed) + suffix(form);
}

Case base_case(const Recipe& recipe) {
  const auto named = [&recipe](const auto* found) {
    if (found == nullptr) throw std::invalid_argument("there is nothing called '" + recipe.name + "' to make a case from");
    return found;
  };
  Case result;
  switch (recipe.source) {
    case Source::family: result = named(families::find_family(recipe.name))->make(recipe.seed, recipe.size); break;
    case Source::catalogue: result = named(families::find_catalogue_entry(recipe.name))->pair; break;
    case Source::real: result = *named(find_real_case(recipe.name)); break;
  }
  result.id = id_of(recipe);
  return result;
}

std::optional<Case> rounded_case(const Case& base, Form form) {
  Case result = base;
  result.id += suffix(form);
  for (const auto& [before, after] : {std::pair(&base.a, &result.a), std::pair(&base.b, &result.b)}) {
    for (Point& p : after->points) {
      if (!round_in_place(p.x, form) || !round_in_place(p.y, form) || !round_in_place(p.z, form)) return std::nullopt;
    }
    if (one_point(*after) && !one_point(*before)) return std::nullopt;
  }
  return result;
}

bool in_format(const Case& points, Form format) {
  const auto fits = [format](const mpq_class& value) { return representable(value, format); };
  return format == Form::given || (all_coordinates(points.a, fits) && all_coordinates(points.b, fits));
}

}  // namespace fathom::golden
