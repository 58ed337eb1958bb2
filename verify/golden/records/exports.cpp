// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/exports.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fathom::golden {
namespace {

using Json = nlohmann::json;

constexpr std::array<const char*, 3> modes{"rn", "rd", "ru"};

/// A record and the place of its answer: the first optimum, else what separates the bodies or shows that they touch.
struct Parts {
  Json record;

  explicit Parts(std::string_view line) try : record(Json::parse(line)) {
    if (!record.at("id").is_string()) throw std::invalid_argument("this is no record: its id is no text");
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("this is no record: ") + error.what());
  }

  [[nodiscard]] static const std::string& text(const Json& value) { return value.get_ref<const std::string&>(); }
  [[nodiscard]] const std::string& id() const { return text(record.at("id")); }
  [[nodiscard]] const Json& expected() const { return record.at("expected"); }
  [[nodiscard]] const std::string& status() const { return text(expected().at("status")); }
  [[nodiscard]] const Json& depth() const { return expected().at("depth"); }
  [[nodiscard]] const Json& answer() const { return status() == "penetrating" ? expected().at("optima").at(0) : expected(); }
  [[nodiscard]] bool in_binary64() const {
    const Json& formats = record.at("formats");
    return std::find(formats.begin(), formats.end(), "binary64") != formats.end();
  }
  [[nodiscard]] bool in_binary32() const {
    const Json& formats = record.at("formats");
    return std::find(formats.begin(), formats.end(), "binary32") != formats.end();
  }
  /// The translation, rounded to nearest; zeros for touching bodies, what brings disjoint ones together.
  [[nodiscard]] Json translation() const {
    if (status() == "touching") return Json::array({"0x0p+0", "0x0p+0", "0x0p+0"});
    const Json& holder = status() == "disjoint" ? expected().at("distance") : answer();
    return holder.at("rounded").at("f64").at("rn");
  }
  [[nodiscard]] std::string distance() const {
    return status() == "disjoint" ? text(expected().at("distance").at("f64").at("rn")) : "0x0p+0";
  }
};

/// Texts of a list of lists, one after another.
template <class Each>
void for_each_text(const Json& value, Each each) {
  if (value.is_string()) each(Parts::text(value));
  else
    for (const Json& part : value) for_each_text(part, each);
}

std::string joined(const Json& list, std::string_view separator) {
  std::string result;
  for_each_text(list, [&](const std::string& item) {
    if (!result.empty()) result += separator;
    result += item;
  });
  return result;
}

/// A hexadecimal float as C++ writes it.
std::string literal(const std::string& hex) {
  constexpr std::string_view infinity = "std::numeric_limits<double>::infinity()";
  return hex == "inf" ? std::string(infinity) : hex == "-inf" ? "-" + std::string(infinity) : hex;
}

std::string literals(const Json& list) {
  std::string result;
  for_each_text(list, [&](const std::string& hex) { result += (result.empty() ? "" : ", ") + literal(hex); });
  return "{" + result + "}";
}

std::string points(const Json& body) {
  std::string result;
  for (const Json& vertex : body.at("vertices")) result += (result.empty() ? "" : ", ") + literals(vertex);
  return "{" + result + "}";
}

std::string row_of(const Parts& parts) {
  const Json &record = parts.record, &depth = parts.depth(), &optima = parts.expected().at("optima");
  std::string row = parts.id() + "," + parts.status() + "," + (parts.in_binary32() ? "binary32" : "binary64") + "," +
                    joined(record.at("flags"), " ") + "," + Parts::text(depth.at("squared"));
  for (const char* format : {"f64", "f32"}) {
    for (const char* mode : modes) row += "," + Parts::text(depth.at(format).at(mode));
  }
  row += "," + joined(parts.answer().at("unit").at("f64").at("rn"), ",") + "," + joined(parts.translation(), ",");
  row += "," + std::to_string(optima.size()) + ",";
  if (!optima.empty()) row += Parts::text(optima[0].at("contact").at("kind"));
  row += "," + parts.distance();
  for (const char* body : {"a", "b"}) {
    const Json& vertices = record.at(body).at("vertices");
    row += "," + std::to_string(vertices.size()) + "," + joined(vertices, " ");
  }
  return row + "\n";
}

std::string entry_of(const Parts& parts) {
  const Json& depth = parts.depth().at("f64");
  std::string entry = "FATHOM_GOLDEN_CASE(\"" + parts.id() + "\", \"" + parts.status() + "\", ";
  for (const char* mode : modes) entry += literal(Parts::text(depth.at(mode))) + ", ";
  entry += literals(parts.answer().at("unit").at("f64").at("rn")) + ", " + literals(parts.translation()) + ", ";
  entry += std::to_string(parts.expected().at("optima").size()) + ", " + literal(parts.distance()) + ", ";
  return entry + points(parts.record.at("a")) + ", " + points(parts.record.at("b")) + ")\n";
}

}  // namespace

std::string csv_header() {
  return "id,status,format,flags,depth_squared,depth_f64_rn,depth_f64_rd,depth_f64_ru,depth_f32_rn,depth_f32_rd,depth_f32_ru,"
         "direction_x,direction_y,direction_z,translation_x,translation_y,translation_z,optima,contact,distance,"
         "a_count,a_points,b_count,b_points\n";
}

std::string include_head() {
  return R"(// SPDX-License-Identifier: CC0-1.0
// Golden cases of fathom with binary64 points: NOTES.md explains them. Before this file is included, say what becomes of a case:
//   struct Case {
//     const char *id, *status;                      // "penetrating", "touching", "disjoint"
//     double depth, depth_down, depth_up;           // correctly rounded: to nearest, down, up
//     std::array<double, 3> direction, translation; // of the first optimum, to nearest; disjoint: those of the distance
//     int optima;                                   // how many directions tie
//     double distance;                              // of disjoint bodies, to nearest
//     std::vector<std::array<double, 3>> a, b;      // the bodies are the convex hulls
//   };
//   std::vector<Case> cases;
//   void fill() {
//   #define FATHOM_GOLDEN_CASE(...) cases.push_back(Case{__VA_ARGS__});
//   #include "golden-L0-0000.inc"
//   }
// C++17, with <limits> included. The macro is undefined again at the end.
#ifndef FATHOM_GOLDEN_CASE
#error "define FATHOM_GOLDEN_CASE(...) before this file is included"
#endif
)";
}

std::string include_tail() { return "#undef FATHOM_GOLDEN_CASE\n"; }

Exports exports_of(std::string_view line) try {
  const Parts parts(line);
  if (!parts.in_binary64()) return {};
  return {row_of(parts), entry_of(parts)};
} catch (const Json::exception& error) {
  throw std::invalid_argument(std::string("this is no record: ") + error.what());
}

}  // namespace fathom::golden
