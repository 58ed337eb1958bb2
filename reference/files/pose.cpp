// SPDX-License-Identifier: GPL-3.0-or-later
// Poses: what they do to a body, what they are made of, and their text.
#include "reference/files/pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

/// Whether it maps points of the plane z = 0 to such, whatever z is.
bool keeps_plane(const Pose& pose) {
  return pose[0][2] == 0 && pose[1][2] == 0 && pose[2][0] == 0 && pose[2][1] == 0 && pose[2][3] == 0;
}

using Rows = std::array<std::array<mpq_class, 3>, 3>;

mpq_class applied(const std::array<mpq_class, 4>& row, const Point& p) {
  return mpq_class(row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]);
}

bool round_coordinate(mpq_class& value) {
  const double rounded = round_binary64(value, Rounding::rn);
  if (std::isinf(rounded)) return false;
  value = exact_value(rounded);
  return true;
}

mpq_class determinant(const Rows& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Whether the rows are orthogonal and of one length, but for 1/100000 of its square.
bool is_similarity(const Rows& m) {
  const auto dot = [&](std::size_t i, std::size_t j) {
    return mpq_class(m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2]);
  };
  const mpq_class square = dot(0, 0), slack = square / 100000;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      if (abs(mpq_class(dot(i, j) - (i == j ? square : mpq_class(0)))) > slack) return false;
  return square != 0;
}

bool is_near_1(const mpq_class& value) { return abs(mpq_class(value - 1)) * 100000 <= 3; }

bool is_rotation(const Rows& m) { return is_similarity(m) && is_near_1(determinant(m)); }

std::string short_text(const mpq_class& value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", round_binary64(value));
  return text;
}

std::string note_on(const Rows& m) {
  if (m == Rows{}) return "the matrix is 0: the body becomes a point";
  const mpq_class det = determinant(m);
  if (det == 0) return "det 0, not a rotation: the body becomes flat";
  const std::string found = "det " + short_text(det);
  if (is_similarity(m)) {
    if (is_near_1(det)) return "";
    if (is_near_1(abs(det))) return found + ", a reflection: the body is mirrored";
    const double scale = std::cbrt(round_binary64(abs(det)));
    char text[48];
    std::snprintf(text, sizeof text, ": the body is %sscaled by %.4g", det < 0 ? "mirrored and " : "", scale);
    return found + ", not a rotation" + text;
  }
  return found + ", not a rotation: the body is scaled or sheared by it";
}

Rows linear_part(const Pose& pose) {
  Rows result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = pose[i][j];
  return result;
}

/// The twelve numbers, three rows of four, taken as four columns of three.
Rows by_columns(const Pose& pose) {
  Rows result;
  for (std::size_t i = 0; i < 9; ++i) result[i % 3][i / 3] = pose[i / 4][i % 4];
  return result;
}

bool is_last(const std::array<mpq_class, 4>& row) { return row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == 1; }

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
      const bool call =
          at < text.size() && text[at] == '(' && is_letter(word.front());  // array([[..]]), as Python prints it
      if (!call) rows.back().push_back({word, false});
    }
  }
  if (rows.back().empty()) rows.pop_back();
  return rows;
}

/// Twelve or sixteen numbers in one row are three or four rows; six are two of the plane.
void break_long_row(TypedRows& rows) {
  if (rows.size() != 1) return;
  const std::ptrdiff_t count = std::ssize(rows[0]), width = count == 6 ? 3 : 4;
  if (count != 6 && count != 12 && count != 16) return;
  const std::vector<Entry> all = std::exchange(rows, {}).front();
  for (auto row = all.begin(); row != all.end(); row += width) rows.emplace_back(row, row + width);
}

/// What is there instead of a matrix, and what may be meant.
std::string found_rows(const TypedRows& rows, std::string_view text) {
  const std::size_t width = rows.empty() ? 0 : rows[0].size();
  const bool even = std::ranges::all_of(rows, [&](const auto& row) { return row.size() == width; });
  if (!even || width < 2) return kernels::shown(text);
  const std::string found =
      std::to_string(rows.size()) + " row" + (rows.size() == 1 ? "" : "s") + " of " + std::to_string(width);
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
  const auto entry = [&](std::size_t i, std::size_t j) {
    return number(rows[i][j], decimals, "row " + std::to_string(i + 1) + ", number " + std::to_string(j + 1), fault);
  };
  if (rows.size() == 2 && rows[0].size() == 3 && rows[1].size() == 3) {
    std::array<std::array<mpq_class, 3>, 2> of_plane;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 3; ++j) of_plane[i][j] = entry(i, j);
    return plane_pose(of_plane);
  }
  const bool good = (rows.size() == 3 || rows.size() == 4) &&
                    std::ranges::all_of(rows, [](const auto& row) { return row.size() == 4; });
  if (!good) {
    fault =
        "expected three rows of four numbers, \"r11 r12 r13 t1; r21 ...; r31 ...\", or four rows, or xyz=X,Y,Z "
        "quat=W,X,Y,Z "
        "(or xyzw=X,Y,Z,W, or rpy=ROLL,PITCH,YAWdeg), in the plane two rows of three, found " +
        found_rows(rows, text);
    return {};
  }
  std::vector<std::array<mpq_class, 4>> numbers(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < 4; ++j) numbers[i][j] = entry(i, j);
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
        fail("expected xyz=, quat=, xyzw=, rpy= or euler=, in the plane xy= or half_angle=, found " +
             kernels::shown(typed));
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
    const bool euler = word == PoseWord::euler;
    if (word == PoseWord::rpy || euler) {
      const bool degrees = text.ends_with("deg"), radians = text.ends_with("rad");
      if (!degrees && !radians)
        return fail(std::string(euler ? "expected euler=intrinsic zyx A,B,C" : "expected rpy=ROLL,PITCH,YAW") +
                    " with deg or rad behind, found " + kernels::shown(text));
      unit_ = degrees ? AngleUnit::degrees : AngleUnit::radians;
      text.remove_suffix(3);
    }
    std::string_view order = euler ? trimmed(text) : "";
    order = trimmed(order.substr(0, order.find_first_of("+-.0123456789\"")));
    if (euler) text = trimmed(text).substr(order.size());
    std::vector<Entry> entries;
    for (const auto& row : rows_of(text)) entries.insert(entries.end(), row.begin(), row.end());
    const std::string place(typed);
    if (entries.size() != numbers_of(word)) {
      constexpr std::array<const char*, 5> counts = {"", "one number", "two numbers", "three numbers", "four numbers"};
      return fail(place + ": expected " + counts.at(numbers_of(word)) + ", found " + std::to_string(entries.size()));
    }
    std::vector<mpq_class> numbers;
    for (const Entry& entry : entries) numbers.push_back(number(entry, decimals_, place, *fault_));
    if (euler) numbers = euler_turns(order, numbers, *fault_);
    if (!words_.emplace(word, std::move(numbers)).second)
      fail("expected one " + std::string(name(word)) + ", found two");
  }

  Decimals decimals_;
  std::string* fault_;
  PoseWords words_;
  AngleUnit unit_ = AngleUnit::degrees;
};

/// The rotation that these turns are, as euler_turns returns them.
Quaternion rotation_of(const std::vector<mpq_class>& turns, AngleUnit unit) {
  Quaternion result{1, 0, 0, 0};
  for (std::size_t i = 0; i + 1 < turns.size(); i += 2) {
    const auto [cosine, sine] = kernels::cosine_and_sine(turns[i + 1] / 2, unit);
    const auto along = [&, s = sine](int axis) { return turns[i] == axis ? s : mpq_class(0); };
    result = product({cosine, along(0), along(1), along(2)}, result);
  }
  return result;
}

/// The fraction with the least denominator, and of these with the least numerator, in [low, high],
/// low < high: the first one that the tree of Stern and Brocot has there.
mpq_class simplest(const mpq_class& low, const mpq_class& high) {
  if (low <= 0 && high >= 0) return 0;
  if (high < 0) return -simplest(-high, -low);
  mpz_class whole;
  mpz_cdiv_q(whole.get_mpz_t(), low.get_num_mpz_t(), low.get_den_mpz_t());
  if (whole <= high) return whole;
  whole -= 1;
  return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole));
}

/// Null if it becomes flat. Of a mirrored one, corners are listed the other way around.
std::shared_ptr<const Solid> placed_solid(Solid solid, const Pose& pose) {
  const int turn = sgn(determinant(linear_part(pose)));
  if (turn == 0) return nullptr;
  for (Point& p : solid.points) p = placed(p, pose);
  for (Point& p : solid.mesh_points.edit()) p = placed(p, pose);
  if (turn > 0) return std::make_shared<const Solid>(std::move(solid));
  for (auto& triangle : solid.triangles) std::ranges::reverse(triangle);
  for (Solid::Piece& piece : solid.pieces)
    for (std::vector<std::uint32_t>& facet : piece.facets) std::ranges::reverse(facet);
  return std::make_shared<const Solid>(std::move(solid));
}

}  // namespace

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

void require_numbers(const AnyPose& pose) {
  if (const auto* const exact = std::get_if<Pose>(&pose)) {
    for (const auto& row : *exact)
      for (const mpq_class& x : row) kernels::require_lowest_terms(x);
  } else {
    for (const auto& row : std::get<PoseBinary64>(pose))
      for (const double x : row) kernels::dyadic(x);
  }
}

Pose exact_pose(const AnyPose& pose) {
  if (const auto* const exact = std::get_if<Pose>(&pose)) return *exact;
  const PoseBinary64& numbers = std::get<PoseBinary64>(pose);
  Pose exact;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) exact[i][j] = exact_value(numbers[i][j]);
  return exact;
}

Pose product(const Pose& second, const Pose& first) {
  Pose result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      result[row][column] = column == 3 ? second[row][3] : mpq_class(0);
      for (std::size_t k = 0; k < 3; ++k) result[row][column] += second[row][k] * first[k][column];
    }
  return result;
}

Point placed(const Point& p, const Pose& pose) {
  return {applied(pose[0], p), applied(pose[1], p), applied(pose[2], p)};
}

bool round_to_binary64(Point& point) {
  return round_coordinate(point.x) && round_coordinate(point.y) && round_coordinate(point.z);
}

Pose exact_pose(const GivenPose& given) { return given.matrix ? *given.matrix : rigid_pose(given.turn, given.place); }

std::string pose_note(const GivenPose& given, bool has_radius) {
  if (!given.matrix) return "";
  std::string note = note_on(linear_part(*given.matrix));
  if (!note.empty() && has_radius)
    note +=
        "; its radius or margin stays (of a tapered capsule the smaller radius: what the larger has more is mapped)";
  if (given.transposed) {
    note = "the last column is 0 0 0 1: this 4 x 4 is read as transposed" + (note.empty() ? "" : "; " + note);
  } else if (!note.empty() && !given.plane && is_rotation(by_columns(*given.matrix))) {
    note += "; four columns of three, read column by column, would be a rotation";
  }
  return note;
}

void place(Body& body, const GivenPose& given) {
  const Pose pose = exact_pose(given);
  if (given.plane && body.dimension != 2)
    throw std::invalid_argument("expected a pose in space, as the body is, found one in the plane");
  if (body.dimension == 2 && !keeps_plane(pose))
    throw std::invalid_argument("expected a pose in the plane, which leaves z as it is, found another");
  const bool flattened =
      given.matrix && determinant(linear_part(*given.matrix)) == 0;  // only points can be: there are no words for it
  if (body.words) body.words = flattened ? nullptr : std::make_shared<const NamedBody>(posed(*body.words, given));
  if (body.shape) {
    body.shape = moved(*body.shape, pose);
    return;
  }
  if (body.pieces) {
    Pieces pieces = *body.pieces;
    for (std::vector<Point>& piece : pieces)
      for (Point& point : piece) point = placed(point, pose);
    body.pieces = std::make_shared<const Pieces>(std::move(pieces));
    if (body.solid) body.solid = placed_solid(*body.solid, pose);
    return;
  }
  for (Point& point : body.points.edit()) point = placed(point, pose);
}

std::optional<PoseWord> pose_word(std::string_view name) {
  if (name == "translation" || name == "xyz") return PoseWord::translation;
  if (name == "quaternion" || name == "quat") return PoseWord::quaternion;
  if (name == "xyzw") return PoseWord::xyzw;
  if (name == "rpy") return PoseWord::rpy;
  if (name == "xy") return PoseWord::xy;
  if (name == "half_angle") return PoseWord::half_angle;
  return name == "euler" ? std::optional(PoseWord::euler) : std::nullopt;
}

std::string_view name(PoseWord word) {
  constexpr std::array<std::string_view, 7> names = {"translation", "quaternion", "xyzw",      "rpy",
                                                     "euler",       "xy",         "half_angle"};
  return names[static_cast<std::size_t>(word)];
}

std::size_t numbers_of(PoseWord word) {
  if (is_of_plane(word)) return word == PoseWord::xy ? 2 : 1;
  return word == PoseWord::quaternion || word == PoseWord::xyzw ? 4 : 3;
}

std::vector<mpq_class> euler_turns(std::string_view order, const std::vector<mpq_class>& angles, std::string& fault) {
  const std::string_view axes = trimmed(order.substr(std::min(order.find_first_of(spaces), order.size())));
  const std::string_view kind = order.substr(0, order.find_first_of(spaces));
  const bool intrinsic = kind == "intrinsic", known = intrinsic || kind == "extrinsic";
  if (!known || axes.size() != 3 || axes.find_first_not_of("xyz") != std::string_view::npos || axes[0] == axes[1] ||
      axes[1] == axes[2]) {
    fault = "euler: expected an order such as 'intrinsic zyx' or 'extrinsic xyz' before the angles, found " +
            kernels::shown(order);
    return std::vector<mpq_class>(6);
  }
  std::vector<mpq_class> turns;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = intrinsic ? 2 - i : i;  // about fixed axes the last turn comes first
    turns.emplace_back(axes[at] - 'x');
    turns.push_back(angles[at]);
  }
  return turns;
}

Quaternion turn_near(const Point& axis, const mpq_class& radians) {
  const auto [cosine, sine] = kernels::cosine_and_sine(radians / 2, AngleUnit::radians);
  const mpq_class slack(1, mpz_class(1) << 47);
  const mpq_class length = length_near(axis);
  if (abs(sine) <= abs(cosine)) {
    const mpq_class tangent = sine / cosine;
    const mpq_class k = simplest((tangent - slack) / length, (tangent + slack) / length);
    return {1, k * axis.x, k * axis.y, k * axis.z};
  }
  const mpq_class cotangent = cosine / sine;
  return {simplest((cotangent - slack) * length, (cotangent + slack) * length), axis.x, axis.y, axis.z};
}

mpq_class length_near(const Point& v) { return kernels::enclosed(Surd{0, v.x * v.x + v.y * v.y + v.z * v.z}, 60).low; }

GivenPose composed(const GivenPose& second, const GivenPose& first) {
  GivenPose result;
  const Quaternion q = product(second.turn, first.turn);
  const mpq_class s = primitive_factor({&q.w, &q.x, &q.y, &q.z});
  result.turn = {s * q.w, s * q.x, s * q.y, s * q.z};
  result.place = placed(first.place, rigid_pose(second.turn, second.place));
  return result;
}

GivenPose pose_of(const PoseWords& words, AngleUnit unit, std::string& fault) {
  GivenPose result;
  bool turned = false;
  if (words.contains(PoseWord::translation) && words.contains(PoseWord::xy))
    fault = "expected one translation, found two";
  for (const auto& [word, numbers] : words) {
    result.plane = result.plane || is_of_plane(word);
    if (word == PoseWord::translation || word == PoseWord::xy) {
      result.place = {numbers[0], numbers[1], word == PoseWord::xy ? mpq_class(0) : numbers[2]};
      continue;
    }
    if (std::exchange(turned, true)) fault = "expected one rotation, found two";
    if (word == PoseWord::half_angle) {
      result.turn = {1, 0, 0, numbers[0]};
      continue;
    }
    if (word == PoseWord::quaternion) result.turn = {numbers[0], numbers[1], numbers[2], numbers[3]};
    if (word == PoseWord::xyzw) result.turn = {numbers[3], numbers[0], numbers[1], numbers[2]};
    const std::vector<mpq_class> rpy = {0, numbers[0], 1, numbers[1], 2, numbers[2]};
    if (word == PoseWord::rpy) result.turn = rotation_of(rpy, unit);
    if (word == PoseWord::euler) result.turn = rotation_of(numbers, unit);
  }
  if (result.turn == Quaternion{0, 0, 0, 0}) fault = "expected a quaternion that is not 0, found 0";
  return result;
}

GivenPose plane_pose(const std::array<std::array<mpq_class, 3>, 2>& rows) {
  GivenPose result;
  Pose& pose = result.matrix.emplace();
  for (std::size_t i = 0; i < 2; ++i) pose[i] = {rows[i][0], rows[i][1], 0, rows[i][2]};
  pose[2] = {0, 0, 1, 0};
  result.plane = true;
  return result;
}

GivenPose pose_of(const std::vector<std::array<mpq_class, 4>>& rows, std::string& fault) {
  GivenPose result;
  Pose& pose = result.matrix.emplace();
  for (std::size_t i = 0; i < 3; ++i) pose[i] = rows.at(i);
  if (rows.size() < 4 || is_last(rows[3])) return result;
  result.transposed = is_last({rows[0][3], rows[1][3], rows[2][3], rows[3][3]});
  if (!result.transposed) fault = "expected the last row 0 0 0 1 of a 4 x 4 matrix, found another";
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) pose[i][j] = rows[j][i];
  return result;
}

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
