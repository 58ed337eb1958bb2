// SPDX-License-Identifier: GPL-3.0-or-later
// Robots as URDF describes them: what each link collides with, where the joints put it.
//
// Of a file the collision elements are read (box, sphere, cylinder, capsule, mesh with scale, each
// with an origin), and the joints. Visual and inertial elements, materials and all else are not.
// Numbers are those of the text: a decimal is the nearest binary64, or its own value; angles are in
// radians. Each angle becomes an exact rotation, off by less than 2^-45 (turn_near).
//                                                                                 [docs/robots.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {

/// What a mesh of a link stands for: its hull; the union of the groups in its file; what it goes
/// around.
enum class MeshAs { hull, pieces, solid };

/// The values of joints by their names: radians, or lengths.
using JointValues = std::map<std::string, mpq_class, std::less<>>;

/// The values in "shoulder=1/2,elbow=-0.3", of which each joint is named once; nullopt for another
/// text.
std::optional<JointValues> parse_joints(std::string_view text, Decimals decimals = Decimals::exact);

/// How a robot is read.
struct RobotOptions {
  Decimals decimals = Decimals::binary64;  ///< of the file, and of text meshes
  MeshAs meshes = MeshAs::hull;
  std::vector<std::string> package_paths = {};  ///< folders for package://
};

/// What a link collides with, in the frame of the link.
struct CollisionElement {
  std::size_t line;
  NamedBody shape = {};     ///< unless there is a mesh
  std::string mesh = {};    ///< as the file names it
  Point scale = {1, 1, 1};  ///< of the mesh
  GivenPose origin = {};
};

struct RobotLink {
  std::string name;
  std::size_t line;
  std::vector<CollisionElement> elements = {};
  std::optional<std::size_t> joint = {};  ///< of which it is the child; of the root none
};

/// How a joint moves. Planar and floating joints are read, and stand still.
enum class JointKind { fixed, revolute, continuous, prismatic, planar, floating };

struct RobotJoint {
  std::string name;
  std::size_t line;
  JointKind kind;
  std::size_t parent, child;  ///< links
  GivenPose origin = {};
  Point axis = {1, 0, 0};
  std::optional<mpq_class> lower = {}, upper = {};  ///< of revolute and prismatic joints
  std::string mimics = {};                          ///< the joint that it follows, or ""
  mpq_class multiplier = 1, offset = 0;             ///< value = multiplier * that of the other + offset

  /// Whether it has a value.
  [[nodiscard]] bool moves() const {
    return kind == JointKind::revolute || kind == JointKind::continuous || kind == JointKind::prismatic;
  }
};

/// A tree of links. How many angles of its file are not 0: each is off by less than 2^-45.
struct Robot {
  std::string file;
  std::vector<RobotLink> links;  ///< in the order of the file
  std::vector<RobotJoint> joints;
  std::size_t angles = 0;
};

/// A robot in one position: the pose of each link in the frame of the root.
struct PosedRobot {
  Robot robot;
  std::vector<mpq_class> values = {};   ///< of each joint; 0 of those that do not move
  std::vector<GivenPose> poses = {};    ///< of each link
  std::vector<std::string> notes = {};  ///< what users may not expect of this position
};

/// The most links that a robot may have.
inline constexpr std::size_t most_links = 1000;

/// Reads the file. Throws InputError, with file and line, for what is malformed, unknown, or no
/// tree. No mesh is read yet.
Robot read_robot(const std::string& path, Decimals decimals);

/// Puts the robot into the position where the joints have these values: 0 of those that are not
/// named, or the limit that is nearest to 0. A joint that mimics another follows it. Throws
/// InputError for a value that no joint of the robot can have; a name that it does not know is left
/// to require_joints.
PosedRobot posed(Robot robot, const JointValues& joints);

/// Throws InputError if a name is that of no joint of these robots that moves by itself.
void require_joints(const std::vector<Robot>& robots, const JointValues& joints);

/// The bodies that the link is, in the frame of the root: none, or one if it has one element or
/// those that it has make a union of convex pieces; else one for each element. A mesh must lie in
/// the folder of the file, or below it, or below a package path, once links of the file system are
/// followed. Throws InputError if it does not, or cannot be read.
std::vector<Body> bodies_of(const PosedRobot& posed, std::size_t link, const RobotOptions& options);

/// Whether links that are not the same can touch only by design: between them there is at most one
/// joint that is not fixed, as links that fixed joints hold together are one body.
bool are_adjacent(const Robot& robot, std::size_t a, std::size_t b);

// ---- one link as a body ----

/// Whether the word is FILE.urdf or FILE.urdf#LINK.
bool is_robot_text(const std::string& word);
/// FILE.urdf of such a word.
std::string file_of_robot(const std::string& word);

/// The robot that the word names, and of which link it speaks. Throws InputError, with the links
/// that there are, if it names none.
struct LinkOfRobot {
  Robot robot;
  std::size_t link;
};
LinkOfRobot read_link(const std::string& word, Decimals decimals);

/// The one body of the link. Throws InputError for a link without an element, or with several that
/// are no union of convex pieces.
Body body_of(const PosedRobot& posed, std::size_t link, const RobotOptions& options);

// ---- any input as a body ----

/// What an input stands for, and sentences on what users may not expect of it.
struct InputBody {
  Body body;
  std::vector<std::string> notes = {};
  std::optional<Robot> robot = {};  ///< of which it is a link
};

/// Reads a link of a robot, in this position; a shape in short words; or a file, which for a union
/// of pieces may be a folder, of which `stays` may leave out some. Links and shapes are unions if
/// meshes are not hulls; a file's mesh of which a solid is wanted stays one, to be cut where it
/// stands in the end. Throws InputError. Names of joints are left to require_joints.
InputBody read_input(const std::string& input, const RobotOptions& options, const JointValues& joints,
                     const PieceFilter& stays = {});

}  // namespace fathom::files
