// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of `depth` and of `width`.
#pragma once

#include "cli/commands/replies.hpp"
#include "cli/output/answer_output.hpp"

namespace fathom::cli {

/// What depth, and width without --delta, are asked for.
struct DepthRequest : BodiesRequest {
  DepthRequest() = default;
  explicit DepthRequest(const Given& given);

  AnswerForm form;
  Method method = Method::automatic;
  bool shallow = false;  ///< use shallow_depth instead of a Method
  std::optional<ClosestLines> closest_lines;
  std::uint64_t seed = 1;
  std::optional<unsigned> bits;  ///< how near the bounds of curved bodies are to be
  std::string certificate, svg;  ///< a file, or of a stream a folder; empty: none
};

/// How the request wants depths to be found.
Question question_of(const DepthRequest& request, Monitor& monitor, Workspace& workspace);

/// Returns the answer to a case, without its certificate. Throws InputError if the request asks for
/// what bodies of these kinds do not have, and for pieces without an interior. A search that is
/// interrupted answers between which bounds the depth lies.
AnsweredCase answered_by(const AskedCase& asked, const DepthRequest& request, const Question& question);

/// Answers with the method of the request, and with a certificate if it asks for one. `request`
/// must outlive the replies. Throws InputError if certificates cannot be written where they should
/// go.
Replies exact_replies(const DepthRequest& request);

}  // namespace fathom::cli
