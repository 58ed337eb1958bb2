// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/approximate_replies.hpp"

#include <fmt/format.h>

#include "cli/io/output.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/approx_output.hpp"
#include "fathom/approximate.hpp"
#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

ApproxDepth solve(const Case& single, const Request& request, Monitor& monitor) {
  return has_one_body(request) ? approx_width(single.a.points, *request.delta, &monitor)
                               : approx_depth(single.a.points, single.b.points, *request.delta, &monitor);
}

/// Not refused: a run can be interrupted, and its progress is shown.
void warn_of_many_rays(const Request& request) {
  constexpr long many = 10'000'000;
  const mpq_class rays = (has_one_body(request) ? 2 : 4) / *request.delta;  // the grid itself takes long to find
  if (rays > many) talk(fmt::format("--delta {} asks for about {} rays a case", exact_text(*request.delta), mpz_class(rays).get_str()));
}

}  // namespace

Replies approximate_replies(const Request& request) {
  warn_of_many_rays(request);
  Replies replies;
  replies.tells_of_dents = true;
  replies.refuses_shapes = has_one_body(request)
                               ? "width without --delta answers about those, exactly or within bounds as near as --bits asks for"
                               : "depth answers about those, exactly or within bounds as near as --bits asks for";
  replies.reply = [&request](const AskedCase& asked, Monitor& monitor, Workspace&) -> CaseReply {
    const std::string& id = asked.input.id;
    const ApproxDepth depth = solve(asked, request, monitor);
    if (request.json) return {approx_json(id, depth, asked.bodies, request)};
    return {is_stream(request) ? approx_line(id, depth, request) : approx_block(depth, asked.bodies, request)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return output::json_error(item.id, item.line, fault); };
  return replies;
}

}  // namespace fathom::cli
