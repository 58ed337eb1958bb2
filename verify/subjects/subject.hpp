// SPDX-License-Identifier: GPL-3.0-or-later
// What the adapters add to the kit that users copy: several ways of asking one library, and
// settings from the command line. Nothing of fathom is included: the programs stand alone.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fathom_subject.hpp>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace subject {

using fathom_subject::Body, fathom_subject::Reply, fathom_subject::Unsupported, fathom_subject::Vector;
using Solver = fathom_subject::Solve;

// ---- bodies ----

inline bool is(const Body& body, const char* shape) { return body.shape == shape; }
inline double number(const Body& body, const char* name) { return body.number.at(name); }
inline const Vector& triple(const Body& body, const char* name) { return body.triple.at(name); }

/// Returns a direction of a shape's frame in the world; and the inverse.
inline Vector turned(const Body& body, const Vector& v) {
  Vector w{};
  for (std::size_t i = 0; i < 3; ++i)
    w[i] = body.rotation[i][0] * v[0] + body.rotation[i][1] * v[1] + body.rotation[i][2] * v[2];
  return w;
}
inline Vector turned_back(const Body& body, const Vector& v) {
  Vector w{};
  for (std::size_t i = 0; i < 3; ++i)
    w[i] = body.rotation[0][i] * v[0] + body.rotation[1][i] * v[1] + body.rotation[2][i] * v[2];
  return w;
}

/// Returns the mean. Divides before summing, so that no sum of finite numbers overflows.
inline Vector mean(const std::vector<Vector>& points) {
  Vector mean{};
  for (const Vector& point : points)
    for (std::size_t i = 0; i < 3; ++i) mean[i] += point[i] / static_cast<double>(points.size());
  return mean;
}

/// Returns the body without the vertices that lie in no face, for libraries that take hulls by
/// their faces. Throws Unsupported for a body without faces.
inline Body hull(const Body& body) {
  if (body.faces.empty()) throw Unsupported("a flat body: the library's convex bodies are made of faces");
  constexpr int unused = -1;
  std::vector<int> names(body.vertices.size(), unused);
  for (const std::vector<int>& face : body.faces)
    for (const int i : face) names[i] = 0;
  Body hull;
  hull.faces = body.faces;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == unused) continue;
    names[i] = static_cast<int>(hull.vertices.size());
    hull.vertices.push_back(body.vertices[i]);
  }
  for (std::vector<int>& face : hull.faces)
    for (int& i : face) i = names[i];
  return hull;
}

// ---- settings ----

/// The library's parameters: each has the library's own default unless key=value was given. The
/// hello lists all of them.
class Settings {
 public:
  /// Throws std::invalid_argument for a word that is not key=value, or a key that comes twice.
  explicit Settings(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      const std::size_t sign = word.find('=');
      if (sign == 0 || sign == std::string::npos) throw std::invalid_argument("expected KEY=VALUE, found " + word);
      if (!given_.emplace(word.substr(0, sign), word.substr(sign + 1)).second)
        throw std::invalid_argument(word + " sets a key again");
    }
  }

  /// Returns the value of a setting. Throws std::invalid_argument for a value that is not a number.
  double number(const std::string& key, double usual) {
    const auto text = taken(key);
    const double value = text ? read<double>(key, *text, "a number") : usual;
    note(key, shortest(value));
    return value;
  }

  /// Returns a whole number in the same way. The largest one means that there is no limit; it is
  /// listed and may be given as "no limit".
  unsigned long count(const std::string& key, unsigned long usual) {
    constexpr unsigned long endless = std::numeric_limits<unsigned long>::max();
    constexpr const char* no_limit = "no limit";
    unsigned long value = usual;
    if (const auto text = taken(key))
      value = *text == no_limit ? endless : read<unsigned long>(key, *text, "a whole number");
    note(key, value == endless ? no_limit : std::to_string(value));
    return value;
  }

  /// Returns x:y:z, if it was given; else nullopt, and the hello lists `usual` as the default.
  std::optional<Vector> vector(const std::string& key, const std::string& usual) {
    const auto text = taken(key);
    note(key, text.value_or(usual));
    if (!text) return std::nullopt;
    Vector v{};
    std::istringstream from(*text);
    char colon = ':', second = ':';
    if (!(from >> v[0] >> colon >> v[1] >> second >> v[2]) || colon != ':' || second != ':' || from.peek() != EOF)
      throw std::invalid_argument(key + " expects three numbers x:y:z, found " + *text);
    return v;
  }

  /// Declares the largest number of contacts of an answer.
  void most_contacts(unsigned long count) { manifold_.emplace()["most"] = static_cast<double>(count); }
  [[nodiscard]] const std::optional<std::map<std::string, double>>& manifold() const { return manifold_; }

  /// Lists a parameter that cannot be changed.
  void note(const std::string& key, const std::string& text) { told_[key] = text; }

  /// Throws std::invalid_argument if a key was given that no mode reads.
  void check_all_used() const {
    if (given_.empty()) return;
    std::string keys;
    for (const auto& [key, value] : told_) keys += " " + key;
    throw std::invalid_argument(given_.begin()->first + " is no setting of this mode; it has" +
                                (keys.empty() ? " none" : keys));
  }
  [[nodiscard]] const std::map<std::string, std::string>& in_force() const { return told_; }

 private:
  std::optional<std::string> taken(const std::string& key) {
    const auto found = given_.find(key);
    if (found == given_.end()) return std::nullopt;
    std::string value = found->second;
    given_.erase(found);
    return value;
  }

  template <class Number>
  static Number read(const std::string& key, const std::string& text, const char* expected) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    bool good = error == std::errc() && rest == end;
    if constexpr (std::is_floating_point_v<Number>) good = good && std::isfinite(value);
    if (!good) throw std::invalid_argument(key + " expects " + expected + ", found " + text);
    return value;
  }

  /// Returns the shortest decimal that reads back as the number.
  static std::string shortest(double value) {
    constexpr int least = 15, most = 17;
    char text[32];
    for (int digits = least; digits <= most; ++digits) {
      std::snprintf(text, sizeof text, "%.*g", digits, value);
      if (std::strtod(text, nullptr) == value) break;
    }
    const std::string result = text;
    return result.find_first_of(".e") == std::string::npos ? result + ".0" : result;
  }

  std::map<std::string, std::string> given_, told_;
  std::optional<std::map<std::string, double>> manifold_;
};

// ---- programs ----

/// One way to call the library.
struct Mode {
  std::string argument;               ///< the word for it on the command line
  std::string name;                   ///< "libccd-epa"
  std::string depth = "positive";     ///< the sign of the depth of bodies that overlap: "positive" or "negative"
  std::string moves = "a";            ///< the body that |depth| * direction moves
  bool faces = false;                 ///< whether it needs faces
  std::string claims = "minimum";     ///< what a depth with a direction means
  std::vector<std::string> shapes{};  ///< the shapes that it takes by name, and "margin" if any of them may have one
  std::function<Solver(Settings&)> make;
};

struct Program {
  std::string library, version, precision;  ///< precision: "binary32" or "binary64"
  std::vector<Mode> modes;
};

inline bool is_rotation(const fathom_subject::Matrix& rows) {
  constexpr double tolerance = 4e-6;  // entries that are off by 1e-6 change a product of two rows by 2 sqrt(3) as much
  const auto& [u, v, w] = rows;
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += u[i] * (v[j] * w[k] - v[k] * w[j]);
    for (std::size_t l = 0; l < 3; ++l) {
      const Vector &p = rows[i], &q = rows[l];
      const double product = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
      if (!(std::abs(product - (i == l ? 1 : 0)) <= tolerance)) return false;
    }
  }
  return determinant > 0;
}

/// Throws Unsupported for a shape or a margin that the mode does not declare, and for a pose that
/// is not a rotation.
inline void check_taken(const Body& body, const Mode& mode) {
  if (body.shape.empty()) return;
  const auto takes = [&mode](const std::string& word) { return std::ranges::count(mode.shapes, word) > 0; };
  if (body.shape == "margin" || !takes(body.shape))
    throw Unsupported("a " + body.shape + ", which " + mode.name + " has not");
  if (body.margin > 0 && !takes("margin")) throw Unsupported("a margin, which " + mode.name + " has not");
  if (!is_rotation(body.rotation)) throw Unsupported("a pose that is no rotation");
}

/// Answers cases in the mode that the command line names. Returns the exit code: 0, or 2 for wrong
/// arguments or a line that is not of the protocol, which is reported on the standard error.
inline int run(const Program& program, int argc, char** argv) {
  try {
    std::string modes;
    for (const Mode& mode : program.modes) modes += (modes.empty() ? "" : " | ") + mode.argument;
    if (argc < 2) throw std::invalid_argument("usage: " + modes + "   [KEY=VALUE...]");
    const auto mode = std::ranges::find(program.modes, argv[1], &Mode::argument);
    if (mode == program.modes.end()) throw std::invalid_argument("expected " + modes + ", found " + argv[1]);
    Settings settings({argv + 2, argv + argc});
    const Solver solve = mode->make(settings);
    settings.check_all_used();
    fathom_subject::Subject subject{mode->name, program.version, program.precision};
    subject.depth = mode->depth;
    subject.moves = mode->moves;
    subject.faces = mode->faces;
    subject.claims = mode->claims;
    subject.shapes = mode->shapes;
    subject.settings = settings.in_force();
    subject.manifold = settings.manifold();
    subject.library = program.library;
    subject.axis = 'z';
    subject.timed = false;
    return fathom_subject::run(subject, [&](const Body& a, const Body& b) {
      check_taken(a, *mode);
      check_taken(b, *mode);
      return solve(a, b);
    });
  } catch (const std::exception& reason) {
    std::cerr << (argc > 0 ? argv[0] : "subject") << ": " << reason.what() << std::endl;
    return 2;
  }
}

}  // namespace subject
