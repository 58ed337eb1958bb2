// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands on bodies share: they reply to one case of mesh files, or to each case of a
// stream.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "fathom/shape.hpp"
#include "reference/files/pose.hpp"

namespace fathom::cli {

/// The bodies or cases that a command is asked about, and how it takes them and replies.
struct BodiesRequest {
  BodiesRequest() = default;
  explicit BodiesRequest(const Given& given);

  std::vector<std::string> inputs;            ///< meshes or shapes, or one stream
  bool one_body = false;                      ///< `width` looks at one body, against itself
  bool pieces = false;                        ///< the bodies are unions of the pieces in their files
  bool solids = false;                        ///< the bodies are the solids of their meshes
  Decimals decimals = Decimals::binary64;     ///< of text meshes; cases say it themselves
  std::optional<std::string> pose_a, pose_b;  ///< where the two bodies stand, as typed
  bool require_convex = false;                ///< of bodies with faces
  std::optional<std::string> case_id;         ///< one case of a stream
  std::optional<unsigned> threads;            ///< for a stream; as many as there are cores unless given
  bool json = false;
};

/// Returns whether the request is about all cases of a stream. Otherwise it is about a single case:
/// its meshes, or one of a stream.
bool is_stream(const BodiesRequest& request);

/// Returns the pose that an option asks for, and notes on standard error if it is no rotation and
/// translation, of a body with a radius or without. Throws InputError.
files::GivenPose asked_pose(const std::string& text, const std::string& option, Decimals decimals, bool has_radius);

/// How a command replies to cases.
struct Replies {
  /// Returns the reply to a case: several lines for a single case, one line in a stream. For a
  /// stream it is called by several threads at once. May throw anything.
  std::function<CaseReply(const AskedCase&, Monitor&, Workspace&)> reply;
  /// As in StreamWork.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line = {};
  /// As in StreamWork.
  std::function<void(const std::string& sentence)> lost = {};
  /// Printed before all replies, unless empty.
  std::string header = {};
  /// As in StreamWork.
  std::string refuses_shapes = {};
  /// As in StreamWork.
  std::string refuses_unions = {};
};

/// Throws InputError if both shapes are half-spaces.
void require_depth(const std::string& id, const Shape& a, const Shape& b);

/// Returns the one case that the request is about: its meshes, where they stand; or of a stream the
/// case called `case_id`, the first of that id, and if there is no id, its only case. Throws
/// InputError, with the ids that there are; and if there is a reason not to take a body: a union of
/// pieces, or a shape.
Case asked_case(const BodiesRequest& request, const std::string& refuses_unions = "",
                const std::string& refuses_shapes = "");

/// Returns the case with what is known of its bodies. Throws InputError if the request wants convex
/// meshes and one is not.
AskedCase looked_at(const Case& single, const BodiesRequest& request);

/// Says that the answer is about hulls, unless the bodies are these: as the first line of an answer
/// in text, else on standard error.
void say_about_hulls(const AskedCase& asked, bool in_text);

/// Returns the work that gives these replies to the cases of a stream, on as many threads as the
/// request says. The request must outlive it.
StreamWork stream_work(const BodiesRequest& request, const Replies& replies);

/// Prints the replies to the request's inputs. Throws as for_each_case does.
ExitCode reply_to_inputs(const BodiesRequest& request, const Replies& replies);

// Files beside the replies: one of a single case, one for each case of a stream.

/// Where the certificates of a run go, or its pictures: a file, or for a stream a folder.
class FilePlaces {
 public:
  FilePlaces(const BodiesRequest& request, std::string path, std::string what, const std::string& ending)
      : path_(std::move(path)), what_(std::move(what)) {
    if (!path_.empty() && is_stream(request)) folder_.emplace(path_, what_, ending);
  }

  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  /// Returns the file of a single case; null for a stream, or if nothing is to be written.
  [[nodiscard]] std::unique_ptr<CertificateFile> single() const {
    return folder_ ? nullptr : wanted_file(path_, what_);
  }
  /// Writes the file of a case of a stream, if it is to be written. Call it in the order of the
  /// cases: of two with one id, the first gets the file.
  void write_to_folder(const std::string& id, const std::string& text) {
    if (folder_) CertificateFile(folder_->file(id), what_).write(text);
  }

 private:
  std::string path_, what_;
  std::optional<CertificateFolder> folder_;
};

}  // namespace fathom::cli
