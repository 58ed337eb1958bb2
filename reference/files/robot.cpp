// SPDX-License-Identifier: GPL-3.0-or-later
// URDF is read by pugixml, which keeps the text of numbers and the place of each element; urdfdom
// keeps neither.
#include "reference/files/robot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <pugixml.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/solid.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/files/piece_files.hpp"

namespace fathom::files {
namespace {

using kernels::shown;
using pugi::xml_node;
using Indices = std::map<std::string, std::size_t, std::less<>>;

constexpr std::string_view xml_spaces = " \t\r\n";

std::string text_of(const mpq_class& value) { return fmt::format("{}", round_binary64(value) + 0.0); }

// ---- the text ----

class Urdf {
 public:
  Urdf(const std::string& path, Decimals decimals) : decimals_(decimals), text_(read_file(path)) {
    robot_.file = path;
    for (std::size_t i = 0; i < text_.size(); ++i)
      if (text_[i] == '\n') line_ends_.push_back(i);
  }

  Robot read() {
    const xml_node root = parsed();
    if (root.name() != std::string_view("robot"))
      fail(root, fmt::format("expected <robot>, the root of a URDF, found {}: SDF, MJCF and xacro are not read",
                             shown(root.name())));
    for (const xml_node& link : root.children("link")) add_link(link);
    if (robot_.links.empty()) fail(root, "expected a <link>, found none");
    for (const xml_node& joint : root.children("joint")) add_joint(joint);
    for (const RobotJoint& joint : robot_.joints) require_mimicked(joint);
    require_tree();
    return std::move(robot_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& sentence) const {
    throw InputError(robot_.file, line, sentence);
  }
  [[noreturn]] void fail(const xml_node& at, const std::string& sentence) const { fail(line_of(at), sentence); }
  [[nodiscard]] std::size_t line_at(std::size_t offset) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, offset) - line_ends_.begin()) + 1;
  }
  [[nodiscard]] std::size_t line_of(const xml_node& node) const {
    return line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  }

  xml_node parsed() {
    if (const std::size_t zero = text_.find('\0'); zero != std::string::npos)
      fail(line_at(zero), "expected XML in UTF-8, found a null byte");
    const pugi::xml_parse_result result = document_.load_buffer(
        text_.data(), text_.size(), pugi::parse_escapes | pugi::parse_wconv_attribute, pugi::encoding_utf8);
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (result.status == pugi::status_no_document_element)
      fail(1, "expected <robot>, the root of a URDF, found no element");
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    if (result.status == pugi::status_end_element_mismatch)
      fail(line_at(at), "expected the end of the element that was begun last, found that of another");
    const bool ended = at + 1 >= text_.size();
    if (!result)
      fail(line_at(at),
           "expected XML, found " +
               (ended ? "the end of the file" : "a fault before " + shown(std::string_view(text_).substr(at))));
    return document_.document_element();
  }

  /// Null if there is none.
  xml_node child(const xml_node& of, const char* name, const std::string& whose, bool required = false) const {
    const xml_node first = of.child(name);
    if (!first && required) fail(of, fmt::format("{}: expected <{}>, found none", whose, name));
    if (const xml_node second = first.next_sibling(name))
      fail(second, fmt::format("{}: expected one <{}>, found two", whose, name));
    return first;
  }
  std::string attribute(const xml_node& of, const char* name, const std::string& whose) const {
    const pugi::xml_attribute found = of.attribute(name);
    if (!found) fail(of, fmt::format("{}: expected {}=\"...\" in <{}>, found none", whose, name, of.name()));
    for (pugi::xml_attribute next = found.next_attribute(); next; next = next.next_attribute())
      if (next.name() == std::string_view(name))
        fail(of, fmt::format("{}: expected {}= once in <{}>, found it twice", whose, name, of.name()));
    return found.value();
  }
  std::vector<mpq_class> numbers(const xml_node& of, const char* name, std::size_t count,
                                 const std::string& whose) const {
    const std::string text = attribute(of, name, whose);
    std::vector<mpq_class> result;
    std::string_view rest = trimmed(text);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find_first_of(xml_spaces), rest.size());
      ParsedNumber number = parse_number(rest.substr(0, end), decimals_);
      if (!number.value) fail(of, fmt::format("{}: {}=: {}", whose, name, number.error));
      result.push_back(*std::move(number.value));
      rest = trimmed(rest.substr(end));
      if (result.size() > count) break;
    }
    if (result.size() != count)
      fail(of, fmt::format("{}: {}=: expected {}, found {}", whose, name, kernels::counted(count, "number", "numbers"),
                           shown(text)));
    return result;
  }
  Point point(const xml_node& of, const char* name, const Point& otherwise, const std::string& whose) const {
    if (!of.attribute(name)) return otherwise;
    const std::vector<mpq_class> x = numbers(of, name, 3, whose);
    return {x[0], x[1], x[2]};
  }
  mpq_class number(const xml_node& of, const char* name, const mpq_class& otherwise, const std::string& whose) const {
    return of.attribute(name) ? numbers(of, name, 1, whose).front() : otherwise;
  }
  mpq_class length(const xml_node& of, const char* name, const std::string& whose) const {
    const mpq_class value = numbers(of, name, 1, whose).front();
    if (value <= 0) fail(of, fmt::format("{}: {}=: expected a length above 0, found {}", whose, name, text_of(value)));
    return value;
  }
  std::string new_name(const xml_node& of, const Indices& known) const {
    std::string name = attribute(of, "name", of.name());
    if (known.contains(name))
      fail(of, fmt::format("expected one {} of a name, found a second {}", of.name(), shown(name)));
    return name;
  }
  [[nodiscard]] std::size_t link_in(const xml_node& joint, const char* role, const std::string& whose) const {
    const xml_node node = child(joint, role, whose, true);
    const std::string name = attribute(node, "link", whose);
    const auto found = links_.find(name);
    if (found == links_.end())
      fail(node, fmt::format("{}: expected a {} that is a link of the robot, found {}", whose, role, shown(name)));
    return found->second;
  }

  GivenPose origin(const xml_node& of, const std::string& whose) {
    GivenPose pose;
    const xml_node node = child(of, "origin", whose);
    pose.place = point(node, "xyz", {}, whose);
    const Point rpy = point(node, "rpy", {}, whose);
    for (const auto& [axis, angle] : {std::pair(Point{1, 0, 0}, rpy.x), {{0, 1, 0}, rpy.y}, {{0, 0, 1}, rpy.z}}) {
      if (angle == 0) continue;
      pose.turn = product(turn_near(axis, angle), pose.turn);
      ++robot_.angles;
    }
    return pose;
  }

  CollisionElement element(const xml_node& collision, const std::string& whose) {
    CollisionElement result{line_of(collision)};
    result.origin = origin(collision, whose);
    const xml_node geometry = child(collision, "geometry", whose, true);
    const auto is_element = [](const xml_node& node) { return node.type() == pugi::node_element; };
    const xml_node body = geometry.find_child(is_element);
    const std::string_view kind = body.name();
    if (std::ranges::count_if(geometry.children(), is_element) > 1)
      fail(geometry, whose + ": expected one shape in <geometry>, found two");
    if (kind == "box") {
      const std::vector<mpq_class> size = numbers(body, "size", 3, whose);
      if (std::ranges::min(size) <= 0) fail(body, whose + ": size=: expected three lengths above 0, found another");
      result.shape = named("box", {{"half", {size[0] / 2, size[1] / 2, size[2] / 2}}});
    } else if (kind == "sphere") {
      result.shape = named("sphere", {{"radius", {length(body, "radius", whose)}}});
    } else if (kind == "cylinder" || kind == "capsule") {
      result.shape = named(std::string(kind), {{"radius", {length(body, "radius", whose)}},
                                               {"half_length", {length(body, "length", whose) / 2}}});
    } else if (kind == "mesh") {
      result.mesh = attribute(body, "filename", whose);
      if (result.mesh.empty()) fail(body, whose + ": filename=: expected the name of a mesh, found nothing");
      result.scale = point(body, "scale", {1, 1, 1}, whose);
      if (result.scale.x * result.scale.y * result.scale.z == 0)
        fail(body, whose + ": scale=: expected factors other than 0, found 0");
    } else {
      fail(geometry, fmt::format("{}: expected box, sphere, cylinder, capsule or mesh in <geometry>, found {}", whose,
                                 shown(kind)));
    }
    return result;
  }

  void add_link(const xml_node& node) {
    if (robot_.links.size() == most_links) fail(node, fmt::format("expected at most {} links, found more", most_links));
    RobotLink link{new_name(node, links_), line_of(node)};
    for (const xml_node& collision : node.children("collision"))
      link.elements.push_back(element(collision, "link " + shown(link.name)));
    links_.emplace(link.name, robot_.links.size());
    robot_.links.push_back(std::move(link));
  }

  void add_joint(const xml_node& node) {
    RobotJoint joint{new_name(node, joints_), line_of(node), JointKind::fixed, 0, 0};
    const std::string whose = "joint " + shown(joint.name), type = attribute(node, "type", whose);
    constexpr std::string_view kinds[] = {"fixed", "revolute", "continuous", "prismatic", "planar", "floating"};
    const auto* const kind = std::ranges::find(kinds, type);
    if (kind == std::end(kinds))
      fail(node, fmt::format("{}: expected the type {}, found {}", whose, fmt::join(kinds, ", "), shown(type)));
    joint.kind = static_cast<JointKind>(kind - std::begin(kinds));
    joint.parent = link_in(node, "parent", whose);
    joint.child = link_in(node, "child", whose);
    joint.origin = origin(node, whose);
    joint.axis = point(child(node, "axis", whose), "xyz", joint.axis, whose);
    if (joint.moves() && joint.axis == Point{}) fail(node, whose + ": expected an axis other than 0, found 0 0 0");
    if (joint.kind == JointKind::revolute || joint.kind == JointKind::prismatic) {
      const xml_node limit = child(node, "limit", whose, true);
      joint.lower = number(limit, "lower", 0, whose);
      joint.upper = number(limit, "upper", 0, whose);
      if (joint.lower > joint.upper) fail(limit, whose + ": expected lower= at most upper=, found more");
    }
    if (const xml_node mimic = child(node, "mimic", whose)) {
      joint.mimics = attribute(mimic, "joint", whose);
      joint.multiplier = number(mimic, "multiplier", 1, whose);
      joint.offset = number(mimic, "offset", 0, whose);
    }
    RobotLink& moved = robot_.links[joint.child];
    if (moved.joint)
      fail(node, fmt::format("{}: expected one joint with the child {}, found a second: links make a tree", whose,
                             shown(moved.name)));
    moved.joint = robot_.joints.size();
    joints_.emplace(joint.name, robot_.joints.size());
    robot_.joints.push_back(std::move(joint));
  }

  void require_mimicked(const RobotJoint& joint) const {
    if (joint.mimics.empty()) return;
    const auto found = joints_.find(joint.mimics);
    if (found == joints_.end() || !robot_.joints[found->second].moves())
      fail(joint.line, fmt::format("joint {}: expected <mimic> of a joint that moves, found {}", shown(joint.name),
                                   shown(joint.mimics)));
  }

  void require_tree() const {
    const auto is_root = [](const RobotLink& link) { return !link.joint; };
    for (const RobotLink& link : robot_.links) {
      const RobotLink* at = &link;
      for (std::size_t steps = 0; at->joint; ++steps) {
        if (steps > robot_.links.size())
          fail(link.line,
               fmt::format("expected links that make a tree, found {} in a cycle, or below one", shown(link.name)));
        at = &robot_.links[robot_.joints[*at->joint].parent];
      }
    }
    const auto first = std::ranges::find_if(robot_.links, is_root);
    const auto second = std::find_if(first + 1, robot_.links.end(), is_root);
    if (second != robot_.links.end())
      fail(second->line, fmt::format("expected one link without a parent, found {} beside {}", shown(second->name),
                                     shown(first->name)));
  }

  Decimals decimals_;
  std::string text_;
  std::vector<std::size_t> line_ends_;
  pugi::xml_document document_;
  Robot robot_;
  Indices links_, joints_;
};

// ---- meshes ----

bool lies_below(const std::filesystem::path& file, const std::string& folder) {
  std::error_code fault;
  const std::filesystem::path whole = std::filesystem::canonical(folder.empty() ? "." : folder, fault);
  return !fault && std::mismatch(whole.begin(), whole.end(), file.begin(), file.end()).first == whole.end();
}

/// Where a mesh with this name may be.
std::vector<std::string> places_of(const std::string& name, const std::string& folder,
                                   const std::vector<std::string>& package_paths) {
  constexpr std::string_view package = "package://", file = "file://";
  if (name.starts_with(file)) return {name.substr(file.size())};
  if (!name.starts_with(package)) return {(std::filesystem::path(folder) / name).string()};
  const std::string rest = name.substr(package.size());
  std::vector<std::string> places;
  for (const std::string& path : package_paths) {
    places.push_back((std::filesystem::path(path) / rest).string());
    const std::filesystem::path own = (std::filesystem::path(path) / "").parent_path().filename();  // of a package
    if (rest.starts_with(own.string() + "/")) places.push_back(path + rest.substr(own.string().size()));
  }
  return places;
}

std::string path_of_mesh(const Robot& robot, const CollisionElement& element,
                         const std::vector<std::string>& package_paths) {
  const std::string folder = std::filesystem::path(robot.file).parent_path().string();
  bool elsewhere = false;
  for (const std::string& place : places_of(element.mesh, folder, package_paths)) {
    std::error_code fault;
    const std::filesystem::path whole = std::filesystem::canonical(place, fault);
    if (fault || !std::filesystem::is_regular_file(whole, fault)) continue;
    if (lies_below(whole, folder) ||
        std::ranges::any_of(package_paths, [&](const auto& p) { return lies_below(whole, p); }))
      return place;
    elsewhere = true;
  }
  throw InputError(robot.file, element.line,
                   fmt::format("expected a mesh in the folder of the file, or below a folder that --package-path "
                               "names, found {} {}",
                               shown(element.mesh), elsewhere ? "elsewhere" : "in none of them"));
}

Body body_of_element(const PosedRobot& posed, std::size_t link, const CollisionElement& element,
                     const RobotOptions& options) try {
  Body body;
  if (element.mesh.empty()) {
    body = body_of(element.shape);
  } else {
    const std::string path = path_of_mesh(posed.robot, element, options.package_paths);
    body = options.meshes == MeshAs::pieces ? read_union(path, options.decimals) : read_mesh(path, options.decimals);
    if (body.dimension == 2) throw std::invalid_argument("expected a mesh, found a body of the plane");
    const Point& s = element.scale;
    if (s != Point{1, 1, 1}) place(body, {Pose{{{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}}}});
  }
  place(body, composed(posed.poses[link], element.origin));
  return options.meshes == MeshAs::solid && !element.mesh.empty() ? solid_body(body) : body;
} catch (const std::invalid_argument& error) {
  throw InputError(posed.robot.file, element.line, error.what());
}

// ---- positions ----

mpq_class least_value(const RobotJoint& joint) {
  if (joint.lower && *joint.lower > 0) return *joint.lower;
  return joint.upper && *joint.upper < 0 ? *joint.upper : mpq_class(0);
}

/// Of a joint that may follow others, and in the end one that moves by itself.
mpq_class value_of(const Robot& robot, const RobotJoint& joint, const Indices& indices, const JointValues& given) {
  const RobotJoint* source = &joint;
  mpq_class multiplier = 1, offset = 0;
  for (std::size_t steps = 0; !source->mimics.empty(); ++steps) {
    if (steps > robot.joints.size())
      throw InputError(robot.file, joint.line,
                       fmt::format("joint {}: expected <mimic> of a joint that does not follow it, found a cycle",
                                   shown(joint.name)));
    offset += multiplier * source->offset;
    multiplier *= source->multiplier;
    source = &robot.joints[indices.at(source->mimics)];
  }
  const auto found = given.find(source->name);
  const mpq_class value = multiplier * (found == given.end() ? least_value(*source) : found->second) + offset;
  if ((joint.lower && value < *joint.lower) || (joint.upper && value > *joint.upper))
    throw InputError(robot.file, joint.line,
                     fmt::format("joint {}: expected a value from {} to {}, found {}", shown(joint.name),
                                 text_of(*joint.lower), text_of(*joint.upper), text_of(value)));
  return value;
}

GivenPose motion_of(const RobotJoint& joint, const mpq_class& value) {
  GivenPose motion;
  if (value == 0) return motion;
  if (joint.kind != JointKind::prismatic) {
    motion.turn = turn_near(joint.axis, value);
    return motion;
  }
  const mpq_class factor = value / length_near(joint.axis);
  motion.place = {joint.axis.x * factor, joint.axis.y * factor, joint.axis.z * factor};
  return motion;
}

/// The link nearest to the root that fixed joints hold together with this one.
std::size_t held_by(const Robot& robot, std::size_t link) {
  while (robot.links[link].joint && robot.joints[*robot.links[link].joint].kind == JointKind::fixed)
    link = robot.joints[*robot.links[link].joint].parent;
  return link;
}

}  // namespace

Robot read_robot(const std::string& path, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  return Urdf(path, decimals).read();
}

void require_joints(const std::vector<Robot>& robots, const JointValues& joints) {
  for (const auto& [name, value] : joints) {
    std::vector<std::string> known;
    for (const Robot& robot : robots)
      for (const RobotJoint& joint : robot.joints)
        if (joint.moves() && joint.mimics.empty()) known.push_back(joint.name);
    if (std::ranges::find(known, name) != known.end()) continue;
    for (std::string& other : known) other = shown(other);
    throw InputError("--joints", 0,
                     fmt::format("expected a joint that moves by itself ({}), found {}", listed(known), shown(name)));
  }
}

PosedRobot posed(Robot robot, const JointValues& joints) {
  const kernels::DefaultFloatEnvironment environment;
  PosedRobot result{std::move(robot)};
  Robot& of = result.robot;
  Indices indices;
  for (std::size_t i = 0; i < of.joints.size(); ++i) indices.emplace(of.joints[i].name, i);
  for (const RobotJoint& joint : of.joints) {
    result.values.push_back(joint.moves() ? value_of(of, joint, indices, joints) : mpq_class(0));
    if (joint.moves() && joint.kind != JointKind::prismatic && result.values.back() != 0) ++of.angles;
    if (joint.kind == JointKind::planar || joint.kind == JointKind::floating)
      result.notes.push_back(
          fmt::format("the joint {} is not moved: planar and floating ones stand still", shown(joint.name)));
    else if (joint.mimics.empty() && !joints.contains(joint.name) && result.values.back() != 0)
      result.notes.push_back(fmt::format("the joint {} stands at its limit, {}, as it cannot be at 0",
                                         shown(joint.name), text_of(result.values.back())));
  }
  result.poses.resize(of.links.size());
  std::vector<bool> known(of.links.size());
  for (std::size_t link = 0; link < of.links.size(); ++link) {
    std::vector<std::size_t> above;  // up to one that is known
    for (std::size_t at = link; !known[at]; at = of.joints[*of.links[at].joint].parent) {
      above.push_back(at);
      if (!of.links[at].joint) break;
    }
    for (; !above.empty(); above.pop_back()) {
      const std::size_t at = above.back();
      known[at] = true;
      if (!of.links[at].joint) continue;
      const RobotJoint& joint = of.joints[*of.links[at].joint];
      const GivenPose moved = composed(joint.origin, motion_of(joint, result.values[*of.links[at].joint]));
      result.poses[at] = composed(result.poses[joint.parent], moved);
    }
  }
  if (of.angles > 0)
    result.notes.push_back(fmt::format("{}, each turned by an exact rotation less than 2^-45 rad off",
                                       kernels::counted(of.angles, "angle that is not 0", "angles that are not 0")));
  return result;
}

std::vector<Body> bodies_of(const PosedRobot& posed, std::size_t link, const RobotOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  std::vector<Body> bodies;
  for (const CollisionElement& element : posed.robot.links[link].elements)
    bodies.push_back(body_of_element(posed, link, element, options));
  if (bodies.size() < 2 || std::ranges::any_of(bodies, [](const Body& body) { return body.shape.has_value(); }))
    return bodies;
  std::vector<Body> pieces;
  for (const Body& body : bodies) {
    if (body.pieces)
      for (const std::vector<Point>& piece : *body.pieces) pieces.push_back({piece});
    else pieces.push_back(body);
  }
  return {union_of(pieces)};
}

std::optional<JointValues> parse_joints(std::string_view text, Decimals decimals) {
  JointValues values;
  while (true) {
    const std::string_view word = text.substr(0, text.find(','));
    const std::size_t equals = word.rfind('=');
    if (equals == word.npos || equals == 0) return std::nullopt;
    const ParsedNumber number = parse_number(word.substr(equals + 1), decimals);
    if (!number.value || !values.emplace(word.substr(0, equals), *number.value).second) return std::nullopt;
    if (word.size() == text.size()) return values;
    text.remove_prefix(word.size() + 1);
  }
}

Body body_of(const PosedRobot& posed, std::size_t link, const RobotOptions& options) {
  std::vector<Body> bodies = bodies_of(posed, link, options);
  if (bodies.size() == 1) return std::move(bodies.front());
  const RobotLink& named = posed.robot.links[link];
  throw InputError(
      posed.robot.file, named.line,
      fmt::format("link {}: expected a <collision>, or several boxes and meshes, found {}", shown(named.name),
                  bodies.empty() ? "none"
                                 : "a round shape beside others, of which no union is taken; fathom robot "
                                   "tells what is known of it"));
}

bool are_adjacent(const Robot& robot, std::size_t a, std::size_t b) {
  const auto parent = [&](std::size_t link) {
    const std::optional<std::size_t> joint = robot.links[link].joint;
    return joint ? held_by(robot, robot.joints[*joint].parent) : link;
  };
  const std::size_t p = held_by(robot, a), q = held_by(robot, b);
  return p == q || parent(p) == q || parent(q) == p;
}

std::string file_of_robot(const std::string& word) {
  std::size_t mark = word.find('#');
  while (mark != std::string::npos && extension(word.substr(0, mark)) != "urdf") mark = word.find('#', mark + 1);
  return word.substr(0, mark);
}

bool is_robot_text(const std::string& word) { return extension(file_of_robot(word)) == "urdf"; }

LinkOfRobot read_link(const std::string& word, Decimals decimals) {
  Robot robot = read_robot(file_of_robot(word), decimals);
  const std::string name = word.size() > robot.file.size() ? word.substr(robot.file.size() + 1) : "";
  const auto found = std::ranges::find(robot.links, name, &RobotLink::name);
  if (found != robot.links.end()) {
    const auto link = static_cast<std::size_t>(found - robot.links.begin());
    return {std::move(robot), link};
  }
  std::vector<std::string> names;
  for (const RobotLink& link : robot.links) names.push_back(shown(link.name));
  throw InputError(
      robot.file, 0,
      fmt::format("expected FILE.urdf#LINK with a link of the robot ({}), found {}", listed(names), shown(name)));
}

InputBody read_input(const std::string& input, const RobotOptions& options, const JointValues& joints,
                     const PieceFilter& stays) {
  InputBody read;
  const bool is_link = is_robot_text(input);
  if (!is_link && !is_shape_text(input)) {
    read.body = options.meshes == MeshAs::pieces ? read_union(input, options.decimals, stays)
                                                 : read_mesh(input, options.decimals);
    for (const std::string& note : file_notes(read.body)) read.notes.push_back(input + ": " + note);
    return read;
  }
  if (is_link) {
    LinkOfRobot found = read_link(input, options.decimals);
    read.robot = found.robot;
    const PosedRobot position = posed(std::move(found.robot), joints);
    for (const std::string& note : position.notes) read.notes.push_back(read.robot->file + ": " + note);
    read.body = body_of(position, found.link, options);
  } else {
    read.body = parse_shape(input, options.decimals);
  }
  if (options.meshes == MeshAs::hull) return read;
  if (read.body.shape)
    throw InputError(
        input, 0,
        "expected a polytope, found a shape that is none: unions with radii have another depth than their cores");
  if (!read.body.pieces) read.body = union_of(std::vector<Body>{std::move(read.body)});
  return read;
}

}  // namespace fathom::files
