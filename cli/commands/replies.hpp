// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands on bodies share: they reply to one case of mesh files, or to each case of a stream.
#pragma once

#include <functional>
#include <string>

#include "cli/args/request.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/exit_code.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

/// Returns whether the request's input is a stream of cases. Otherwise it is the meshes of a single case.
bool is_stream(const Request& request);

/// How a command replies to cases.
struct Replies {
  /// Returns the reply to a case: several lines for a single case, one line in a stream. For a stream it is called by several threads at
  /// once. May throw anything.
  std::function<CaseReply(const Case&, Monitor&, Workspace&)> reply;
  /// As in StreamWork.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line = {};
  /// Printed before all replies, unless empty.
  std::string header = {};
  /// Whether `reply` takes bodies that are no polytopes.
  bool takes_shapes = false;
};

/// What the replies are to the cases of a stream, on as many threads as the request says. The request must outlive it.
StreamWork stream_work(const Request& request, const Replies& replies);

/// Prints the replies to the request's inputs. Throws as for_each_case does.
ExitCode reply_to_inputs(const Request& request, const Replies& replies);

}  // namespace fathom::cli
