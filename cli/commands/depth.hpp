// SPDX-License-Identifier: GPL-3.0-or-later
// The options and the replies of `depth` and of `width`.
#pragma once

#include "cli/commands/replies.hpp"
#include "cli/output/answer_output.hpp"

namespace fathom::cli {

/// The options of depth, and of width without --delta.
struct DepthRequest : BodiesRequest {
  DepthRequest() = default;
  explicit DepthRequest(const Given& given);

  AnswerForm form;
  Method method = Method::automatic;
  bool shallow = false;  ///< use shallow_depth instead of a Method
  std::optional<ClosestLines> closest_lines;
  std::uint64_t seed = 1;
  std::optional<unsigned> bits;  ///< the precision of the bounds of curved bodies
  std::string certificate, svg;  ///< a file, or for a stream a folder; empty: none
};

/// Returns how depths are to be found, by the options of the request.
Question question_of(const DepthRequest& request, Monitor& monitor, Workspace& workspace);

/// Returns the answer to a case, without its certificate. Throws InputError if bodies of these
/// kinds do not have what the request asks for, or if a piece has no interior. A search that is
/// interrupted returns bounds of the depth.
AnsweredCase answered_by(const AskedCase& asked, const DepthRequest& request, const Question& question);

/// Returns replies by the method of the request, with certificates if it asks for them. `request`
/// must outlive the replies. Throws InputError if the certificates cannot be written to the path
/// given.
Replies exact_replies(const DepthRequest& request);

}  // namespace fathom::cli
