// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/cases_json.hpp"

#include "reference/files/body_json.hpp"

namespace fathom::cli {

std::string case_json(const CaseText& text) {
  std::string result = R"({"schema":"fathom/case/1","id":)" + files::text_json(text.id);
  result += ",\"a\":" + text.a + ",\"b\":" + text.b;
  if (text.pose_rounding) result += R"(,"pose_rounding":"binary64")";
  if (!text.flags.empty()) result += ",\"flags\":" + files::array_json(text.flags, files::text_json);
  if (!text.source.empty()) {
    std::string source;
    for (const auto& [key, value] : text.source)
      source += (source.empty() ? "" : ",") + files::text_json(key) + ':' + files::text_json(value);
    result += ",\"source\":{" + source + '}';
  }
  if (!text.comment.empty()) result += ",\"comment\":" + files::text_json(text.comment);
  return result + '}';
}

}  // namespace fathom::cli
