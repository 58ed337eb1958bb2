// SPDX-License-Identifier: GPL-3.0-or-later
// The common part of all commands on bodies: they reply to one case made of mesh files, or to each
// case of a stream.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "fathom/shape.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/robot.hpp"

namespace fathom::cli {

/// The bodies or cases of a request, and how to read them and reply.
struct BodiesRequest {
  BodiesRequest() = default;
  explicit BodiesRequest(const Given& given);

  std::vector<std::string> inputs;            ///< meshes or shapes, or one stream
  bool one_body = false;                      ///< `width` is about one body
  bool pieces = false;                        ///< the bodies are unions of the pieces in their files
  bool skip_flat = false;                     ///< pieces without an interior are left out
  bool solids = false;                        ///< the bodies are the solids of their meshes
  Decimals decimals = Decimals::binary64;     ///< of text meshes; cases state it themselves
  std::optional<std::string> pose_a, pose_b;  ///< the poses of the two bodies, as typed
  files::RobotOptions robots;                 ///< how links of robots are read
  files::JointValues joints;                  ///< and where their joints stand
  bool require_convex = false;                ///< refuse meshes that are not convex
  std::optional<std::string> case_id;         ///< one case of a stream
  std::optional<unsigned> threads;            ///< for a stream; as many as there are cores unless given
  bool json = false;
};

/// Returns whether the request is about all cases of a stream. Otherwise it is about a single case:
/// its meshes, or one of a stream.
bool is_stream(const BodiesRequest& request);

/// Returns the union of the pieces of a file or folder, each of which needs an interior. Pieces
/// without one are left out, and named, or refused.
Body union_of_input(const std::string& input, Decimals decimals, bool skip_flat);

/// Returns the bodies of the inputs, where the inputs put them: mesh files or folders, shapes in
/// words, links of robots. Prints notes on robots. Throws InputError.
std::vector<Body> bodies_of_inputs(const BodiesRequest& request);

/// Returns the pose that an option describes. Prints a note on standard error if it is no rotation
/// with a translation; `has_radius`: of a body with a radius. Throws InputError.
files::GivenPose asked_pose(const std::string& text, const std::string& option, Decimals decimals, bool has_radius);

/// Returns the mesh in a file. Prints what its reader has to say on standard error. Throws
/// InputError.
Body mesh_of_input(const std::string& input, Decimals decimals);

/// How a command replies to cases.
struct Replies {
  /// Returns the reply to a case: several lines for a single case, one line in a stream. For a
  /// stream it is called by several threads at once. May throw anything.
  std::function<CaseReply(const AskedCase&, Monitor&, Workspace&)> reply;
  /// As in StreamWork.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line = {};
  /// As in StreamWork.
  std::function<void(const std::string& sentence)> lost = {};
  /// A line to print before all replies, or "".
  std::string header = {};
  /// As in StreamWork.
  std::string refuses_shapes = {};
  /// As in StreamWork.
  std::string refuses_unions = {};
  /// As in StreamWork.
  std::string refuses_plane = {};
  /// As in StreamWork.
  bool reads_text = false;
};

/// Throws InputError if both shapes are half-spaces.
void require_depth(const std::string& id, const Shape& a, const Shape& b);

/// Returns the one case of the request: that of its meshes in their poses; or of a stream the first
/// case with the id `case_id`, or its only case if there is no `case_id`. Throws InputError with
/// the ids of the stream; and, for a union of pieces or a shape, with the reason to refuse it, if
/// there is one. Sets `text`, if it is given, to that of a case of a stream.
Case asked_case(const BodiesRequest& request, const std::string& refuses_unions = "",
                const std::string& refuses_shapes = "", const std::string& refuses_plane = "",
                std::string* text = nullptr);

/// Returns the case with the facts about its bodies. Throws InputError if the request requires
/// convex meshes and one is not convex.
AskedCase looked_at(const Case& single, const BodiesRequest& request);

/// Prints that the answer is about hulls, if a mesh is not convex: as the first line of an answer
/// in text, else on standard error.
void say_about_hulls(const AskedCase& asked, bool in_text);

/// Returns the work that replies to the cases of a stream, with as many threads as the request
/// says. The request must outlive it.
StreamWork stream_work(const BodiesRequest& request, const Replies& replies);

/// Prints the replies to the request's inputs. Throws as for_each_case does.
ExitCode reply_to_inputs(const BodiesRequest& request, const Replies& replies);

// Files beside the replies: one for a single case, or one for each case of a stream.

/// The path of the certificates, or of the pictures, of a run: a file, or for a stream a folder.
class FilePlaces {
 public:
  FilePlaces(const BodiesRequest& request, std::string path, std::string what, const std::string& ending)
      : path_(std::move(path)), what_(std::move(what)) {
    if (!path_.empty() && is_stream(request)) folder_.emplace(path_, what_, ending);
  }

  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  /// Returns the file for a single case; null for a stream, or if none is wanted.
  [[nodiscard]] std::unique_ptr<CertificateFile> single() const {
    return folder_ ? nullptr : wanted_file(path_, what_);
  }
  /// Writes the file for a case of a stream, if files are wanted. Call it in the order of the
  /// cases: of two cases with one id, the first gets the file.
  void write_to_folder(const std::string& id, const std::string& text) {
    if (folder_) CertificateFile(folder_->file(id), what_).write(text);
  }

 private:
  std::string path_, what_;
  std::optional<CertificateFolder> folder_;
};

}  // namespace fathom::cli
