// SPDX-License-Identifier: GPL-3.0-or-later
// What the adapters share: the protocol fathom/subject/1 on the standard streams, and settings from the command line. An adapter adds one
// function per way of asking its library. Nothing of fathom is included: the programs stand alone.                [verify/PROTOCOL.md]
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace subject {

using Vector = std::array<double, 3>;

/// A rotation and then a translation. In binary64, whatever the subject's numbers are.
struct Pose {
  std::array<Vector, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vector translation{};

  [[nodiscard]] Vector turned(const Vector& v) const;
  [[nodiscard]] Vector turned_back(const Vector& v) const;
};

/// A shape as cases name it. What its name does not have is 0.
struct Shape {
  std::string name;  ///< "sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "halfspace" or "hull"
  double radius = 0, half_length = 0, offset = 0;
  Vector half{}, radii{}, normal{};
  double margin = 0;  ///< the radius of a ball that is added around it
  Pose pose{};        ///< of the shape along z: an axis x or y is a part of the rotation
};

struct Body {
  std::vector<Vector> vertices;           ///< of a shape: those of a hull, in its own frame
  std::vector<std::vector<int>> faces{};  ///< counter-clockwise from outside; empty where the body is flat or the mode asks for none
  std::optional<Shape> shape{};
};

/// One point of a manifold: of both bodies, and how deep they overlap there.
struct Contact {
  Vector position{};
  double depth = 0;
};

/// What the library answered, in its own numbers and under the conventions of the mode.
struct Reply {
  bool overlap = false;
  std::optional<double> depth{};
  std::optional<double> distance{};  ///< of bodies that are apart; direction and witness are then those of the gap
  std::optional<Vector> direction{};
  std::optional<std::array<Vector, 2>> witness{};  ///< on A and on B
  std::vector<Contact> contacts{};                 ///< of the one direction; the largest of their depths is `depth`
};

/// Thrown for a pair that the library does not take. Any other exception is an answer that the library failed to give.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The library's parameters: each has the library's own default unless key=value was given. The hello lists all of them.
class Settings {
 public:
  /// Throws std::invalid_argument for a word that is not key=value, or a key that comes twice.
  explicit Settings(const std::vector<std::string>& words);
  /// The value in force. Throws std::invalid_argument for a value that is not a number (for `count`: no whole number; the largest, which
  /// stands for none, is listed and may be given as "no limit").
  double number(const std::string& key, double usual);
  unsigned long count(const std::string& key, unsigned long usual);
  /// x:y:z, if it was given; else nullopt, and `usual` says in the list what is taken then.
  std::optional<Vector> vector(const std::string& key, const std::string& usual);
  /// Lists what cannot be changed.
  void note(const std::string& key, const std::string& text);
  /// Throws std::invalid_argument when a key was given that nothing asked for.
  void check_all_used() const;
  const std::map<std::string, std::string>& in_force() const { return told_; }

 private:
  std::optional<std::string> taken(const std::string& key);
  std::map<std::string, std::string> given_, told_;
};

using Solver = std::function<Reply(const Body& a, const Body& b)>;

/// One way of asking the library.
struct Mode {
  std::string argument;               ///< its word on the command line
  std::string name;                   ///< "libccd-epa"
  std::string depth = "positive";     ///< the sign of the depth of bodies that overlap: "positive" or "negative"
  std::string moves = "a";            ///< the body that |depth| * direction moves apart
  bool faces = false;                 ///< whether it needs faces
  std::vector<std::string> shapes{};  ///< the names of the shapes that it takes, and "margin" if any of them may have one
  std::function<Solver(Settings&)> make;
};

struct Program {
  std::string library, version, precision;  ///< precision: "binary32" or "binary64"
  std::vector<Mode> modes;
};

/// Divided before it is summed: no sum of finite numbers overflows.
Vector mean(const std::vector<Vector>& points);

/// The body without the vertices that lie in no face: a hull, as libraries of faces take it. Throws Unsupported for a body without faces.
Body hull(const Body& body);

/// Speaks the protocol until "stop" or the end of the input. What the library prints on its standard output goes to the standard error.
/// Returns the exit code: 0, or 2 for wrong arguments or a line that is not of the protocol (reported on the standard error).
int run(const Program& program, int argc, char** argv);

}  // namespace subject
