// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/pose_text.hpp"

#include <algorithm>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "reference/files/source.hpp"
#include "reference/files/text_scanner.hpp"

namespace fathom::files {
namespace {

constexpr std::string_view spaces = " \t\r\n", between = " \t\r\n,;()[]{}";
constexpr std::size_t longest = std::size_t{1} << 20;  // of the text of a pose: numbers may have many digits

/// A number and whether it stood in quotes.
struct Entry {
  std::string_view text;
  bool quoted;
};
using TypedRows = std::vector<std::vector<Entry>>;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Rows end at semicolons and brackets, and at the ends of lines if there are no brackets.
TypedRows rows_of(std::string_view text) {
  const bool bracketed = text.find_first_of("[({") != std::string_view::npos;
  TypedRows rows(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (between.find(c) != std::string_view::npos) {
      ++at;
      const bool ends = c == ';' || c == ')' || c == ']' || c == '}' || (c == '\n' && !bracketed);
      if (ends && !rows.back().empty()) rows.emplace_back();
    } else if (c == '"') {
      const std::size_t end = std::min(text.find('"', at + 1), text.size());
      rows.back().push_back({text.substr(at + 1, end - at - 1), true});
      at = end + 1;
    } else {
      const std::size_t end = std::min(text.find_first_of(between, at), text.size());
      const std::string_view word = text.substr(at, end - at);
      at = end;
      const bool call = at < text.size() && text[at] == '(' && is_letter(word.front());  // array([[..]]), as Python prints it
      if (!call) rows.back().push_back({word, false});
    }
  }
  if (rows.back().empty()) rows.pop_back();
  return rows;
}

/// Twelve or sixteen numbers in one row are three or four rows.
void break_long_row(TypedRows& rows) {
  if (rows.size() != 1 || (rows[0].size() != 12 && rows[0].size() != 16)) return;
  const std::vector<Entry> all = std::exchange(rows, {}).front();
  for (std::size_t i = 0; i < all.size(); i += 4)
    rows.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i), all.begin() + static_cast<std::ptrdiff_t>(i) + 4);
}

/// What is there instead of a matrix, and what may be meant.
std::string found_rows(const TypedRows& rows, std::string_view text) {
  const std::size_t width = rows.empty() ? 0 : rows[0].size();
  const bool even = std::ranges::all_of(rows, [&](const auto& row) { return row.size() == width; });
  if (!even || width < 2) return kernels::shown(text);
  const std::string found = std::to_string(rows.size()) + " row" + (rows.size() == 1 ? "" : "s") + " of " + std::to_string(width);
  if (rows.size() == 3 && width == 3) return found + ": the translation, a fourth column, is missing";
  if (rows.size() == 4 && width == 3) return found + ": it looks transposed";
  if (rows.size() == 1 && width == 9) return found + ": the translation, a fourth column, is missing";
  if (rows.size() == 1 && width == 7)
    return found + ": write xyz=X,Y,Z quat=W,X,Y,Z or xyz=X,Y,Z xyzw=X,Y,Z,W, since both orders are in use";
  return found;
}

mpq_class number(const Entry& entry, Decimals decimals, const std::string& place, std::string& fault) {
  ParsedNumber parsed = parse_number(entry.text, entry.quoted ? Decimals::exact : decimals);
  if (parsed.value) return *std::move(parsed.value);
  if (fault.empty()) fault = place + ": " + parsed.error;
  return 0;
}

GivenPose matrix(std::string_view text, Decimals decimals, std::string& fault) {
  TypedRows rows = rows_of(text);
  break_long_row(rows);
  const bool good = (rows.size() == 3 || rows.size() == 4) && std::ranges::all_of(rows, [](const auto& row) { return row.size() == 4; });
  if (!good) {
    fault =
        "expected three rows of four numbers, \"r11 r12 r13 t1; r21 ...; r31 ...\", or four rows, or xyz=X,Y,Z quat=W,X,Y,Z "
        "(or xyzw=X,Y,Z,W, or rpy=ROLL,PITCH,YAWdeg), found " +
        found_rows(rows, text);
    return {};
  }
  std::vector<std::array<mpq_class, 4>> numbers(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < 4; ++j)
      numbers[i][j] = number(rows[i][j], decimals, "row " + std::to_string(i + 1) + ", number " + std::to_string(j + 1), fault);
  return pose_of(numbers, fault);
}

/// NAME=NUMBERS, one after another.
class Words {
 public:
  Words(Decimals decimals, std::string& fault) : decimals_(decimals), fault_(&fault) {}

  GivenPose read(std::string_view text) {
    while (true) {
      text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,;"), text.size()));
      if (text.empty()) break;
      const std::size_t equals = text.find('=');
      const std::string_view typed = trimmed(text.substr(0, equals));
      const std::optional<PoseWord> word = pose_word(typed);
      if (!word || equals == std::string_view::npos) {
        fail("expected xyz=, quat=, xyzw= or rpy=, found " + kernels::shown(typed));
        break;
      }
      text.remove_prefix(equals + 1);
      const std::size_t next = text.find('=');
      std::size_t end = next == std::string_view::npos ? text.size() : next;
      if (next != std::string_view::npos) {  // back over the name of the next word
        while (end > 0 && spaces.find(text[end - 1]) != std::string_view::npos) --end;
        while (end > 0 && (is_letter(text[end - 1]))) --end;
      }
      value(*word, typed, text.substr(0, end));
      text.remove_prefix(end);
    }
    if (!fault_->empty()) return {};
    return pose_of(words_, unit_, *fault_);
  }

 private:
  static std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
    return text.substr(0, text.find_last_not_of(spaces) + 1);
  }
  void fail(const std::string& sentence) {
    if (fault_->empty()) *fault_ = sentence;
  }

  void value(PoseWord word, std::string_view typed, std::string_view text) {
    text = text.substr(0, text.find_last_not_of(" \t\r\n,;)]}") + 1);
    if (word == PoseWord::rpy) {
      const bool degrees = text.ends_with("deg"), radians = text.ends_with("rad");
      if (!degrees && !radians) return fail("expected rpy=ROLL,PITCH,YAW with deg or rad behind, found " + kernels::shown(text));
      unit_ = degrees ? AngleUnit::degrees : AngleUnit::radians;
      text.remove_suffix(3);
    }
    std::vector<Entry> entries;
    for (const auto& row : rows_of(text)) entries.insert(entries.end(), row.begin(), row.end());
    const std::string place(typed);
    if (entries.size() != numbers_of(word))
      return fail(place + ": expected " + (numbers_of(word) == 4 ? "four" : "three") + " numbers, found " + std::to_string(entries.size()));
    std::vector<mpq_class> numbers;
    for (const Entry& entry : entries) numbers.push_back(number(entry, decimals_, place, *fault_));
    if (!words_.emplace(word, std::move(numbers)).second) fail("expected one " + std::string(name(word)) + ", found two");
  }

  Decimals decimals_;
  std::string* fault_;
  PoseWords words_;
  AngleUnit unit_ = AngleUnit::degrees;
};

}  // namespace

GivenPose parse_pose(std::string_view text, Decimals decimals, std::string& fault) {
  if (text.find('=') != std::string_view::npos) return Words(decimals, fault).read(text);
  return matrix(text, decimals, fault);
}

GivenPose read_pose(const std::string& argument, const std::string& option, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  const bool in_file = argument.starts_with('@');
  const std::string path = in_file ? argument.substr(1) : option, given = in_file ? read_file(path, longest) : argument;
  std::string_view text = given;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::string fault = text.size() > longest ? "expected a pose, found more than a MiB" : "";
  GivenPose pose;
  if (fault.empty()) pose = parse_pose(text, decimals, fault);
  if (!fault.empty()) throw InputError(path, 0, fault);
  return pose;
}

}  // namespace fathom::files
