// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies from files: meshes (OFF, OBJ, PLY, STL, plain points; glTF, COLLADA, 3MF by Assimp),
// bodies of the plane (SVG, plain points of two coordinates), and cases of two bodies as JSON, one
// a line or one a file.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"

namespace fathom {

/// Two bodies about which a question is asked, with a name.
struct Case {
  std::string id;                     ///< its name; may be empty
  Body a, b;                          ///< with their poses applied
  std::optional<Motion> motion = {};  ///< how they begin to move, for questions about the derivative
};

/// Malformed, missing or unreadable input. what() is one complete sentence for the user:
/// "cube.off:12: expected a vertex index below 8, found '9'".
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::size_t line, const std::string& message);  ///< line 0: no line
  [[nodiscard]] const std::string& file() const { return file_; }              ///< as the message names it
  [[nodiscard]] std::size_t line() const { return line_; }                     ///< 0: no line

 private:
  std::string file_;
  std::size_t line_;
};

// ---- meshes ----

/// The mesh formats that are read. PLY, STL and glTF may be text or binary, as the file itself
/// says. The last three are scenes, which Assimp reads: its coordinates, in binary32, are taken
/// exactly.
enum class MeshFormat { off, obj, ply, stl, xyz, svg, gltf, collada, threemf };

/// Returns the points of the mesh in the file `path`, exactly, in order of appearance; repeated
/// points stay (an STL repeats each corner). Binary floats, hexadecimal floats, integers and
/// ratios p/q are taken as they are. `decimals` says what a decimal stands for: the nearest
/// binary64, which is what other programs read, or its own value. Faces are kept as they are,
/// once their indices are checked. Whatever else a mesh holds (normals, colours, texture) is
/// skipped; a mesh without faces is a point set. The extension tells the format (.off .obj .ply
/// .stl .xyz .txt .pts .svg .gltf .glb .dae .3mf), else the first bytes do. Lines of two numbers,
/// and an SVG of one shape, are a body of the plane (fathom/plane.hpp); y is as it is written. Of
/// a scene, each node's meshes are placed by the transforms above it, exactly, and corners of
/// faces are its points, in the order of the nodes; only buffers in the folder of the file are
/// read beside it. "scene.glb#name" is the one node, or the node that shows the one mesh, of this
/// name; of OBJ the group, of STL the solid, of SVG the shape. Throws InputError, with file and
/// line (in binary files, the byte or the part), for anything missing, truncated, out of range or
/// not a number.
Body read_mesh(const std::string& path, Decimals decimals = Decimals::binary64);

/// The same for a mesh in memory; `name` is its file name, which may tell the format and appears in
/// messages. No file is read.
Body parse_mesh(std::string_view bytes, const std::string& name, Decimals decimals = Decimals::binary64);

/// The same for a known format.
Body parse_mesh(std::string_view bytes, const std::string& name, Decimals decimals, MeshFormat format);

// ---- cases ----
//
// A case is a JSON object of the schema fathom/case/1 (case.schema.json). A JSON number
// means the nearest binary64 of its decimal text, as in any other program, integers too; 1e400 is
// an error. A string is exact: integer, p/q, decimal, C99 hex float. "pose" is applied exactly, as
// an affine map: a matrix of 3 or 4 rows, a quaternion or angles and a translation, or text as on
// the command line. "pose_rounding": "binary64", in the case or in one body, then rounds the placed
// vertices once. "twist" tells how the bodies begin to move, whose points were placed. Unknown
// fields are skipped. A known field that is given twice is an error, since readers differ in which
// one they take. null stands for an optional field that is not given.

/// What may be a slip in a case that can be read: a field that is not read and looks like one that
/// is ("poze"), or a pose that is no rotation and translation. One sentence for the user.
struct CaseNote {
  enum Kind { field, pose };  ///< what the note is about
  Kind kind;                  ///< of the two
  std::string text;           ///< the sentence
};

/// One case of a stream, or the reason why it cannot be read.
struct CaseItem {
  std::size_t line = 1;  ///< where it begins
  std::string id;        ///< its id, else its line number as text; also of a bad case, if it could be read
  std::variant<Case, InputError> outcome;  ///< the case, or why there is none
  std::vector<CaseNote> notes = {};        ///< of a case that could be read

  /// Which of the two it is.
  [[nodiscard]] bool ok() const { return std::holds_alternative<Case>(outcome); }
  [[nodiscard]] const Case& value() const {
    return std::get<Case>(outcome);
  }  ///< throws std::bad_variant_access unless ok()
  [[nodiscard]] const InputError& error() const { return std::get<InputError>(outcome); }  ///< throws it if ok()
};

/// Reads the case in `text`, which begins on line `line` of the input called `name`. Throws nothing
/// on bad input.
CaseItem parse_case(std::string_view text, const std::string& name, std::size_t line = 1);

/// How cases lie in an input.
enum class CaseLayout {
  lines,    ///< one a line; but a line that is "{" alone starts a case that runs until its braces balance (or an
            ///< unindented "{")
  document  ///< a single case, however it is broken into lines
};

/// Reads cases one after another: each can be answered before the line after it is read. Blank
/// lines are skipped. A bad case is an item of its own, and the stream goes on. An input without
/// any case yields one error.
class CaseStream {
 public:
  /// Reads `input`, which must outlive the stream; `name` is for messages.
  CaseStream(std::istream& input, std::string name, CaseLayout layout = CaseLayout::lines);
  CaseStream(CaseStream&&) noexcept;             ///< the other one may only be assigned to, or destroyed
  CaseStream& operator=(CaseStream&&) noexcept;  ///< in the same way
  ~CaseStream();

  /// Opens a file; "-" is `standard_input`, named "<stdin>". A .json file is a document, unless
  /// more follows its first value. Throws InputError if it cannot be read.
  static CaseStream open(const std::string& path, std::istream& standard_input);

  /// Returns the next case, or nullopt at the end. A case of more than 256 MiB is a bad one. Throws
  /// std::bad_alloc if memory runs out: the case, which begins on line case_line(), is skipped
  /// then, and the stream can go on.
  std::optional<CaseItem> next();
  [[nodiscard]] std::size_t case_line() const;  ///< where the latest case begins

 private:
  class Reader;
  explicit CaseStream(std::unique_ptr<Reader> reader);

  std::unique_ptr<Reader> reader_;
};

}  // namespace fathom
