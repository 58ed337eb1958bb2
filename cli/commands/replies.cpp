// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/replies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/args/values.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/progress.hpp"
#include "fathom/files.hpp"
#include "fathom/solid.hpp"
#include "kernels/messages.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/json_values.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::cli {
namespace {

/// Refuses a flat piece of a file, or tells that it is left out.
bool stays(const std::string& input, bool skip_flat, const files::NamedPiece& piece, std::size_t number) {
  if (piece.mesh.shape) return true;  // refused by the reader
  if (!answer::is_flat_body(piece.mesh)) return true;
  const std::string which =
      fmt::format("piece {}{}", number, piece.name.empty() ? "" : fmt::format(" ({})", kernels::shown(piece.name)));
  if (!skip_flat)
    throw InputError(
        input, 0,
        fmt::format("{} is flat: the pieces of a union need interiors (--skip-flat goes on without it)", which));
  talk(fmt::format("{}: {} is flat, and left out", input, which));
  return false;
}

/// Returns the body that the input stands for. Adds its robot to those that were read before.
Body body_of_input(const std::string& input, const BodiesRequest& request, std::vector<files::Robot>& robots) {
  files::InputBody read =
      files::read_input(input, request.robots, request.joints, [&](const files::NamedPiece& piece, std::size_t number) {
        return stays(input, request.skip_flat, piece, number);
      });
  const bool again = read.robot && std::ranges::find(robots, read.robot->file, &files::Robot::file) != robots.end();
  if (!again)
    for (const std::string& note : read.notes) talk(note);
  if (read.robot) robots.push_back(*std::move(read.robot));
  return std::move(read.body);
}

/// Cuts the mesh, in its pose, into convex pieces.
Body solid_of_input(const std::string& input, const Body& mesh) try {
  return mesh.pieces ? mesh : solid_body(mesh);
} catch (const std::invalid_argument& error) {
  throw InputError(input, 0, error.what());
}

/// Returns the option for the pose. A command on one body has no options for A and B.
std::string pose_option(const BodiesRequest& request, bool of_a) {
  if (request.one_body) return "--pose";
  return of_a ? "--pose-a" : "--pose-b";
}

/// Prints what kind of map the pose is, if it is no rotation.
void tell_of(const files::GivenPose& pose, const std::string& option, bool has_radius) {
  if (const std::string note = files::pose_note(pose, has_radius); !note.empty()) talk(option + ": " + note);
}

Case single_case(const BodiesRequest& request) {
  const std::vector<Body> bodies = bodies_of_inputs(request);
  const auto body = [&](std::size_t i) {
    const std::string& input = request.inputs[i];
    Body result = bodies[i];
    const std::string option = pose_option(request, i == 0);
    if (const std::optional<std::string>& text = i == 0 ? request.pose_a : request.pose_b) {
      const files::GivenPose pose = files::read_pose(*text, option, request.decimals);
      try {
        files::place(result, pose);
      } catch (const std::invalid_argument& error) {
        throw InputError(option, 0, error.what());
      }
      tell_of(pose, option, result.shape && result.shape->radius > 0);
    }
    return request.solids ? solid_of_input(input, result) : result;
  };
  Case single = request.one_body ? Case{request.inputs[0], body(0), {}}
                                 : Case{request.inputs[0] + " " + request.inputs[1], body(0), body(1)};
  single.id = text::valid_utf8(single.id);  // of names of files: result and certificate must agree on it
  return single;
}

constexpr std::size_t most_ids = 12;  // listed in a message

/// Returns "a, b, c", and how many more there are.
std::string ids_text(const std::vector<std::string>& ids, std::size_t count) {
  std::string result;
  for (const std::string& id : ids) result += (result.empty() ? "" : ", ") + kernels::shown(id);
  return count > ids.size() ? fmt::format("{} and {} more", result, count - ids.size()) : result;
}

/// Sets `text_of_case`, if it is given.
Case case_of_stream(const std::string& input, const std::optional<std::string>& asked, std::string* text_of_case) {
  CaseInput source(input, interrupt_requested);
  files::UnreadCases texts = source.texts();
  std::vector<std::string> ids;
  std::size_t count = 0;
  std::vector<CaseItem> first;  // at most one case
  while (const std::optional<files::UnreadCase> text = texts.next()) {
    CaseItem item = files::read_case(*text, texts.name());
    if (text_of_case && (item.id == asked || count == 0)) *text_of_case = text->text;
    if (item.id == asked) return item.ok() ? item.value() : throw item.error();
    if (ids.size() < most_ids) ids.push_back(item.id);
    if (++count == 1) first.push_back(std::move(item));
    if (interrupt_requested()) throw Interrupted();
  }
  if (count == 1 && (!asked || !first[0].ok())) return first[0].ok() ? first[0].value() : throw first[0].error();
  const std::string found = fmt::format("found {} case{}: {}", count, count == 1 ? "" : "s", ids_text(ids, count));
  throw InputError(texts.name(), 0,
                   asked ? fmt::format("expected a case with the id {}, {}", kernels::shown(*asked), found)
                         : fmt::format("expected a single case, or --case ID with the id of one, {}", found));
}

/// Returns whether the input holds cases, of which the request may choose one.
bool holds_cases(const BodiesRequest& request) {
  if (!request.one_body) return request.inputs.size() == 1;
  return request.inputs[0] == "-" || is_cases_name(request.inputs[0]);  // by its name
}

void refuse_poses_of_stream(const BodiesRequest& request) {
  if (holds_cases(request) && (request.pose_a || request.pose_b))
    throw InputError(pose_option(request, request.pose_a.has_value()), 0,
                     "expected bodies, found a stream of cases, which have poses of their own");
}

}  // namespace

BodiesRequest::BodiesRequest(const Given& given)
    : inputs(given.inputs()),
      one_body(given.command == "width"),
      pieces(given.flag("--pieces")),
      skip_flat(given.flag("--skip-flat")),
      solids(given.flag("--solid")),
      decimals(given.flag("--exact-decimals") ? Decimals::exact : Decimals::binary64),
      pose_a(given.value("--pose-a")),
      pose_b(given.value("--pose-b")),
      require_convex(given.flag("--require-convex")),
      case_id(given.value("--case")),
      threads(given.integer<unsigned>("--threads")),
      json(given.flag("--json")) {
  robots.decimals = decimals;
  robots.meshes = pieces ? files::MeshAs::pieces : solids ? files::MeshAs::solid : files::MeshAs::hull;
  robots.package_paths = given.words("--package-path");
  joints = files::parse_joints(given.text("--joints"), decimals).value_or(files::JointValues());
}

Body union_of_input(const std::string& input, Decimals decimals, bool skip_flat) {
  Body body = files::read_union(input, decimals, [&](const files::NamedPiece& piece, std::size_t number) {
    return stays(input, skip_flat, piece, number);
  });
  for (const std::string& note : files::file_notes(body)) talk(input + ": " + note);
  return body;
}

std::vector<Body> bodies_of_inputs(const BodiesRequest& request) {
  std::vector<Body> bodies;
  std::vector<files::Robot> robots;
  for (const std::string& input : request.inputs) bodies.push_back(body_of_input(input, request, robots));
  files::require_joints(robots, request.joints);
  return bodies;
}

Body mesh_of_input(const std::string& input, Decimals decimals) {
  Body body = read_mesh(input, decimals);
  for (const std::string& note : files::file_notes(body)) talk(input + ": " + note);
  return body;
}

Case asked_case(const BodiesRequest& request, const std::string& refuses_unions, const std::string& refuses_shapes,
                const std::string& refuses_plane, std::string* text) {
  refuse_poses_of_stream(request);
  Case single = holds_cases(request) ? case_of_stream(request.inputs[0], request.case_id, text) : single_case(request);
  const std::string fault = wrong_bodies(single, request.one_body, refuses_shapes, refuses_unions, refuses_plane);
  return fault.empty() ? single : throw InputError(single.id, 0, fault);
}

AskedCase looked_at(const Case& single, const BodiesRequest& request) {
  AskedCase asked(single, request.one_body);
  const std::string fault = wrong_meshes(asked.bodies.hull, request.require_convex);
  return fault.empty() ? asked : throw InputError(single.id, 0, fault);
}

void say_about_hulls(const AskedCase& asked, bool in_text) {
  const std::string sentence = shapes::about_hulls(asked.bodies.hull, asked.bodies.sizes.one_body);
  if (!sentence.empty()) in_text ? print(fitted(sentence, 2)) : talk(sentence);
}

files::GivenPose asked_pose(const std::string& text, const std::string& option, Decimals decimals, bool has_radius) {
  files::GivenPose pose = files::read_pose(text, option, decimals);
  tell_of(pose, option, has_radius);
  return pose;
}

bool is_stream(const BodiesRequest& request) { return holds_cases(request) && !request.case_id; }

void require_depth(const std::string& id, const Shape& a, const Shape& b) {
  if (shapes::is_halfspace(a) && shapes::is_halfspace(b))
    throw InputError(id, 0, "expected one half-space at most, found two: they have no depth");
}

StreamWork stream_work(const BodiesRequest& request, const Replies& replies) {
  StreamWork work;
  work.one_body = request.one_body;
  work.header = replies.header;
  work.error_line = replies.error_line;
  work.lost = replies.lost;
  work.refuses_shapes = replies.refuses_shapes;
  work.refuses_unions = replies.refuses_unions;
  work.refuses_plane = replies.refuses_plane;
  work.reads_text = replies.reads_text;
  work.answer = replies.reply;
  work.require_convex = request.require_convex;
  work.threads = request.threads.value_or(usual_threads());
  return work;
}

ExitCode reply_to_inputs(const BodiesRequest& request, const Replies& replies) {
  refuse_poses_of_stream(request);
  if (is_stream(request)) return for_each_case(request.inputs[0], stream_work(request, replies));
  std::string text;
  const Case single = asked_case(request, replies.refuses_unions, replies.refuses_shapes, replies.refuses_plane,
                                 replies.reads_text ? &text : nullptr);
  const InterruptGuard interrupt_guard;
  Progress progress;
  AskedCase asked = looked_at(single, request);
  asked.text = text;
  Workspace workspace;
  const CaseReply reply = replies.reply(asked, progress, workspace);
  if (reply.keep) reply.keep();
  progress.answered();
  if (const std::optional<std::string> note = shapes::sizes_note(asked.bodies.sizes)) talk(*note);
  if (!has_shape(single) && !files::has_union(single)) tell_of_hulls(single, request.one_body, progress);
  say_about_hulls(asked, !request.json && replies.header.empty());
  if (!replies.header.empty()) print(replies.header);
  print(reply.text);
  return reply.code;
}

}  // namespace fathom::cli
