// SPDX-License-Identifier: GPL-3.0-or-later
// Placing a body: an exact affine map, and the one rounding that a program in doubles would add;
// and poses as people write them.
//                                                                            [docs/command_line.md]
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"

namespace fathom::files {

using fathom::Pose;
using kernels::AngleUnit;

/// The turn by q, and then by p.
Quaternion product(const Quaternion& p, const Quaternion& q);

/// The map `first`, and then `second`.
Pose product(const Pose& second, const Pose& first);

/// A matrix in either form.
using AnyPose = std::variant<PoseBinary64, Pose>;

/// Throws std::invalid_argument unless its numbers are finite, or in lowest terms.
void require_numbers(const AnyPose& pose);

/// Its numbers, exactly: as require_numbers asks for them.
Pose exact_pose(const AnyPose& pose);

/// Returns M p + t, exactly. M may be any matrix: it need be neither orthonormal nor regular.
Point placed(const Point& p, const Pose& pose);

/// Sets `point` to the nearest binary64 numbers, ties to even. Returns false if a coordinate is too
/// large; then the point is unusable.
bool round_to_binary64(Point& point);

/// A pose as it was given: a matrix; or a rotation, and then a translation.
struct GivenPose {
  std::optional<Pose> matrix = std::nullopt;  ///< if set, in the place of `turn` and `place`
  Quaternion turn{1, 0, 0, 0};
  Point place = {};
  bool transposed = false;  ///< the matrix was written column by column
  bool plane = false;       ///< it was written as one of the plane, of which bodies in space have no use
};

/// The map that it is, exactly. Throws as rigid_pose does.
Pose exact_pose(const GivenPose& given);

/// What there is to say of a pose that is no rotation and translation, as "det 0.98, not a
/// rotation: the body is scaled or sheared by it"; or of one that was transposed. Empty if the
/// matrix is a rotation but for 1/100000: that of floats, or of decimals, is no exact one.
/// `has_radius`: of a body with a radius, which no pose maps.
std::string pose_note(const GivenPose& given, bool has_radius);

/// Places the body, exactly, and its words with it. Throws std::invalid_argument as moved does, and
/// if the pose and the body are not both of the plane or both of space.
void place(Body& body, const GivenPose& given);

/// The words for a rotation and a translation, and what they are called in short.
enum class PoseWord { translation, quaternion, xyzw, rpy, euler, xy, half_angle };

/// "translation" or "xyz"; "quaternion" or "quat"; "xyzw"; "rpy"; "euler"; and in the plane "xy";
/// "half_angle".
std::optional<PoseWord> pose_word(std::string_view name);
constexpr bool is_of_plane(PoseWord word) { return word == PoseWord::xy || word == PoseWord::half_angle; }
std::string_view name(PoseWord word);
/// How many numbers are written behind it.
std::size_t numbers_of(PoseWord word);

/// What was read for each word; for euler what euler_turns makes of it.
using PoseWords = std::map<PoseWord, std::vector<mpq_class>>;

/// Three turns in the order in which the body makes them about the fixed axes, each as the number
/// of its axis and the angle. `order` is "extrinsic xyz", or with any letters of which no two
/// neighbours are alike: the first angle is about the first axis, all axes are fixed. "intrinsic
/// zyx": each axis is turned by the turns before, as in MJCF's eulerseq="zyx". Returns a sentence
/// in `fault` if it is neither: small and capital letters mean opposite things in different
/// programs.
std::vector<mpq_class> euler_turns(std::string_view order, const std::vector<mpq_class>& angles, std::string& fault);

/// The pose of these words, with as many numbers each as belong to it. A quaternion is (w, x, y,
/// z), or (x, y, z, w) as `xyzw`. rpy: angles about the fixed axes x, then y, then z, as in URDF.
/// So are euler's, in the order that it names. The body is turned about each axis by the quaternion
/// of the half angle's cosine and sine, both rounded to 53 bits: an exact rotation by an angle that
/// is off by less than 2^-51, and not at all at multiples of 90 degrees. half_angle is the tangent
/// of half the angle of a turn in the plane. Returns a sentence in `fault` if the words do not go
/// together.
GivenPose pose_of(const PoseWords& words, AngleUnit unit, std::string& fault);

/// A turn about the axis, which is not 0, by an angle that is off by less than 2^-45 radians: that
/// of the fraction with the least numbers for which so much is proved. So an angle that is written
/// to 15 digits as a multiple of a quarter turn about x, y or z is exactly that.
///                                                                            [proofs/number.md]
Quaternion turn_near(const Point& axis, const mpq_class& radians);

/// The length of the vector: itself if it is rational, else from below within 2^-60 of itself.
mpq_class length_near(const Point& v);

/// The rotation and translation `first`, and then `second`; neither is a matrix. Its quaternion is
/// of integers without a common factor.
GivenPose composed(const GivenPose& second, const GivenPose& first);

/// The pose of two rows of three numbers: one of the plane, which leaves z as it is.
GivenPose plane_pose(const std::array<std::array<mpq_class, 3>, 2>& rows);

/// The pose of a matrix of three or four rows of four numbers. Of four, the last row must be 0 0 0
/// 1; or the last column, and then it was written column by column. Returns a sentence in `fault`
/// if neither is so.
GivenPose pose_of(const std::vector<std::array<mpq_class, 4>>& rows, std::string& fault);

// ---- as text ----

/// Reads a pose as people write it: one of
///   12 or 16 numbers, row by row: between them commas, white space, semicolons, brackets; quotes
///   around one make it exact, as in JSON xyz=X,Y,Z and one of quat=W,X,Y,Z xyzw=X,Y,Z,W
///   rpy=ROLL,PITCH,YAWdeg (or rad) euler=intrinsic zyx A,B,Cdeg (or rad), in any order, one of
///   both may be missing; in the plane 6 numbers, or xy=X,Y and half_angle=T. Decimals mean what
///   `decimals` says; integers, p/q and hexadecimal floats are exact. Returns a sentence in `fault`
///   if it is neither.
GivenPose parse_pose(std::string_view text, Decimals decimals, std::string& fault);

/// The same of an argument; "@FILE" stands for what is in that file. Throws InputError that names
/// `option`, or the file.
GivenPose read_pose(const std::string& argument, const std::string& option, Decimals decimals);

}  // namespace fathom::files
