// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/replies.hpp"

#include "cli/io/in_order.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/hull_note.hpp"
#include "cli/output/json_values.hpp"
#include "fathom/files.hpp"
#include "reference/files/shape_text.hpp"
#include "reference/files/source.hpp"

namespace fathom::cli {
namespace {

Case single_case(const Request& request) {
  const auto body = [&](std::size_t i) {
    const std::string& input = request.inputs[i];
    return files::is_shape_text(input) ? files::parse_shape(input, request.decimals) : read_mesh(input, request.decimals);
  };
  Case single =
      has_one_body(request) ? Case{request.inputs[0], body(0), {}} : Case{request.inputs[0] + " " + request.inputs[1], body(0), body(1)};
  single.id = valid_utf8(single.id);  // of file names; result and certificate are to agree on it
  return single;
}

}  // namespace

bool is_stream(const Request& request) {
  if (!has_one_body(request)) return request.inputs.size() == 1;
  const std::string& input = request.inputs[0];  // its name tells
  const std::string kind = files::extension(input);
  return input == "-" || kind == "jsonl" || kind == "ndjson" || kind == "json";
}

StreamWork stream_work(const Request& request, const Replies& replies) {
  StreamWork work;
  work.one_body = has_one_body(request);
  work.header = replies.header;
  work.error_line = replies.error_line;
  work.takes_shapes = replies.takes_shapes;
  work.answer = replies.reply;
  work.threads = request.threads.value_or(usual_threads());
  return work;
}

ExitCode reply_to_inputs(const Request& request, const Replies& replies) {
  if (is_stream(request)) return for_each_case(request.inputs[0], stream_work(request, replies));
  const Case single = single_case(request);
  if (const std::string fault = wrong_shapes(single, has_one_body(request), replies.takes_shapes); !fault.empty())
    throw InputError(single.id, 0, fault);
  const Working working;
  Progress progress;
  Workspace workspace;
  const CaseReply reply = replies.reply(single, progress, workspace);
  if (reply.keep) reply.keep();
  progress.answered();
  if (!has_shape(single)) tell_of_hulls(single, has_one_body(request), progress);
  if (!replies.header.empty()) print(replies.header);
  print(reply.text);
  return fine;
}

}  // namespace fathom::cli
