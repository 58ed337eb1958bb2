// SPDX-License-Identifier: Apache-2.0
// Lets `fathom certify` put cases to your code: one function that answers a pair of bodies. Copy
// this file; it needs C++17 and POSIX alone.
//
//   int main() { return fathom_subject::run({"my library", "1.0"}, [](const fathom_subject::Body&
//   a, const fathom_subject::Body& b) { const Hit hit = my_library::collide(a.vertices,
//   b.vertices); return fathom_subject::Reply{hit.overlap, hit.depth, hit.normal}; }); }
//
// and then `fathom certify --subject ./my_subject cases.jsonl`. It speaks the protocol
// fathom/subject/1 (verify/PROTOCOL.md): lines are flushed, NaN and infinities are written so that
// they are judged, whatever your code prints goes to standard error, its exceptions become the
// answer `failed`, and each answer says how many microseconds it took. Any compiler of C++17 to
// C++23 and any standard library will do.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fathom_subject {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  ///< rows

/// A velocity: the body's point p moves with v + w x p. w is about the origin of the world.
struct Twist {
  Vector v, w;
};

/// One body of a case: the convex hull of `vertices`; or a shape, if the subject declared some.
/// docs/shapes.md says what its fields mean. A body of the plane has z = 0: it is the hull of
/// `vertices`, grown by `margin`, and its faces are edges, one behind the other.
struct Body {
  std::vector<Vector> vertices;  ///< of a shape, only hulls and triangles have them
  /// facets of the hull, counter-clockwise from outside; none unless asked for, or if it is flat
  std::vector<std::vector<int>> faces;
  std::vector<std::vector<Vector>> pieces;  ///< of a union, if the subject declared "pieces"; it has no vertices then
  std::string shape;                        ///< "sphere", "cylinder", ...; empty for a body of vertices
  std::map<std::string, double> number;     ///< of a shape: "radius", "half_length", "offset", ...
  std::map<std::string, Vector> triple;     ///< of a shape: "half", "radii", "normal"
  char axis = 'z';    ///< along which a shape lies before it is placed; the declared one, if one was declared
  double margin = 0;  ///< the radius of the ball that is added around a shape
  /// w, x, y, z, of any length but 0; not there if the case gave a matrix
  std::optional<std::array<double, 4>> quaternion;
  Matrix rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< a shape's point p is at rotation p + translation
  Vector translation{};
  std::optional<Twist> twist = {};  ///< how it begins to move, if the subject declared "twist" and the case says so
};

/// One point of a contact manifold, in both bodies, and maybe how deep they overlap there along the
/// reply's direction.
struct Contact {
  Vector position{};
  std::optional<double> depth = {};
};

/// What the code under test answers. Only `overlap` is needed, and what is there is judged.
struct Reply {
  bool overlap = false;
  std::optional<double> depth = {};      ///< with the sign that is declared
  std::optional<Vector> direction = {};  ///< moving the declared body by |depth| * direction takes the bodies apart
  /// a point of A and one of B, which differ by that translation of A
  std::optional<std::array<Vector, 2>> witness = {};
  /// of bodies that are apart; direction and witness then lead farther apart, and are nearest
  /// points
  std::optional<double> distance = {};
  std::vector<Contact> contacts = {};  ///< of a depth, which is the largest of theirs
  /// of bodies with a twist: how fast the signed depth grows as they begin to move, from then on.
  /// Deeper is positive, whatever sign depths have; minus the distance counts of bodies apart
  std::optional<double> derivative = {};
  /// the vertices of A's and B's hull that were really used, if they may be others; or none
  std::array<std::vector<Vector>, 2> hull = {};
  std::optional<double> microseconds = {};  ///< how long it took, if you timed a part of your function yourself
};

/// Throw it for a pair that your code does not take: the case is not judged then. Any other
/// exception is a failure to answer.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Called once for each case. What it throws is an answer too.
using Solve = std::function<Reply(const Body& a, const Body& b)>;

/// What the subject declares of itself.
struct Subject {
  std::string name, version;  ///< of what is tested
  /// or "binary32": in which it computes. Bodies are rounded to it before they are sent
  std::string precision = "binary64";
  /// what it says of bodies that touch: "overlap", "separate"; "either" makes no promise
  std::string touching = "either";
  std::string depth = "positive";  ///< or "negative": the sign of the depth of bodies that overlap
  std::string moves = "a";         ///< or "b": which body |depth| * direction moves apart
  bool unit = true;                ///< whether directions are promised to have length 1
  bool faces = false;              ///< whether bodies of vertices need faces
  /// that it takes, "margin" if they may have one, "pieces" for unions; others come as vertices. In
  /// the plane of "circle", "capsule", "margin" (of polygons) and "pieces"
  std::vector<std::string> shapes = {};
  /// of "depth", "direction", "witness", "contacts": what answers with overlap hold; "distance",
  /// what others do; "derivative", what answers about bodies with a twist do
  std::vector<std::string> promises = {};
  std::map<std::string, std::string> settings = {};  ///< shown beside the verdicts
  std::string library = {};                          ///< "libccd", "fcl", "bullet" or "ode", if it is one of them
  std::string answers = {};  ///< the precision of answers, if `precision` is that of points alone
  /// radii by which it rounds bodies: of "vertices", "box", ...; of "" for all
  std::map<std::string, double> rounding = {};
  /// of its contacts: "most", how many an answer has at most; "margin", how much less deep those
  /// without a depth may be
  std::optional<std::map<std::string, double>> manifold = {};
  /// or "separating": a depth with a direction claims no more than that this translation separates
  std::string claims = "minimum";
  char axis = 0;  ///< 'x', 'y' or 'z': along which the library's own shapes lie. Bodies then come turned to it; 0: as
                  ///< the case has them
  bool timed = true;   ///< whether answers say how many microseconds they took
  bool twist = false;  ///< whether bodies come with their twists, to be asked for the derivative
  int dimension = 3;   ///< 2 for bodies of the plane: then z is 0 everywhere, and not sent
};

namespace details {

/// A value of JSON. Of true, false and null no more is known: no message to a subject has them
/// where it matters.
struct Json {
  struct Member;
  std::optional<double> number;
  std::string text;
  std::vector<Json> items;      ///< of a list
  std::vector<Member> members;  ///< of an object

  const Json& at(const char* name) const;
};

struct Json::Member {
  std::string name;
  Json value;
};

inline const Json& Json::at(const char* name) const {
  for (const Member& member : members)
    if (member.name == name) return member.value;
  throw std::invalid_argument(std::string("a message without ") + name);
}

class JsonReader {
 public:
  explicit JsonReader(const std::string& text) : at_(text.c_str()), end_(at_ + text.size()) {}

  Json read() {
    Json value = this->value();
    skip_spaces();
    if (at_ != end_) fail();
    return value;
  }

 private:
  [[noreturn]] static void fail() { throw std::invalid_argument("a line that is no JSON"); }
  void skip_spaces() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\n')) ++at_;
  }
  bool take(char c) {
    skip_spaces();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  bool take_word(const std::string& word) {
    if (std::string(at_, std::min(at_ + word.size(), end_)) != word) return false;
    at_ += word.size();
    return true;
  }

  Json value() {
    Json json;
    if (take('{')) {
      if (!take('}')) members(json);
    } else if (take('[')) {
      if (!take(']')) items(json);
    } else if (take('"')) {
      json.text = text();
    } else if (!take_word("true") && !take_word("false") && !take_word("null")) {
      json.number = number();
    }
    return json;
  }

  void members(Json& json) {
    do {
      if (!take('"')) fail();
      std::string name = text();
      if (!take(':')) fail();
      json.members.push_back({std::move(name), value()});
    } while (take(','));
    if (!take('}')) fail();
  }

  void items(Json& json) {
    do json.items.push_back(value());
    while (take(','));
    if (!take(']')) fail();
  }

  // Not by a stream: libc++'s fail on subnormal numbers. strtod takes the decimal point of the
  // program's locale.
  double number() {
    const char* const begin = at_;
    while (at_ != end_ && std::strchr("+-.0123456789eE", *at_) && *at_ != '\0') ++at_;
    std::string text(begin, at_);
    if (const std::size_t point = text.find('.'); point != std::string::npos)
      text.replace(point, 1, std::localeconv()->decimal_point);
    char* rest = nullptr;
    const double value = std::strtod(text.c_str(), &rest);
    if (text.empty() || *rest != '\0') fail();
    return value;
  }

  // What is escaped stays so: names of fields and shapes never are, and an id goes back as it came.
  std::string text() {
    const char* const begin = at_;
    while (at_ != end_ && *at_ != '"') at_ += *at_ == '\\' && at_ + 1 != end_ ? 2 : 1;
    if (at_ == end_) fail();
    return {begin, at_++};
  }

  const char *at_, *end_;
};

/// The text of an exception, cut where it is long; null if it has none.
inline std::string reason(const char* text) {
  constexpr std::size_t longest = 1000;
  return std::string(text ? text : "an exception without a text").substr(0, longest);
}

inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c >= ' ' && c <= '~' ? c : '?';  // a library's message may hold bytes that are not UTF-8
  }
  return result + '"';
}

/// The fewest digits that read back as the number. JSON has no NaN and no infinities: they go as
/// texts.
inline std::string number(double x) {
  if (std::isnan(x)) return "\"nan\"";
  if (std::isinf(x)) return x < 0 ? "\"-inf\"" : "\"inf\"";
#ifdef __cpp_lib_to_chars
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
#else
  for (int digits = std::numeric_limits<double>::digits10;; ++digits) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    text << x;
    const std::string written = text.str();
    if (digits == std::numeric_limits<double>::max_digits10 || JsonReader(written).read().number == x) return written;
  }
#endif
}

inline std::string vector(const Vector& v, int dimension) {
  return '[' + number(v[0]) + ',' + number(v[1]) + (dimension == 2 ? "" : ',' + number(v[2])) + ']';
}

/// What `text` makes of each item, with commas.
template <class Items, class Text>
std::string joined(const Items& items, Text text) {
  std::string result;
  for (const auto& item : items) result += (result.empty() ? "" : ",") + text(item);
  return result;
}

inline std::string list(const std::vector<std::string>& words) { return '[' + joined(words, quoted) + ']'; }

template <std::size_t n>
std::array<double, n> numbers(const Json& from) {
  if (from.items.size() != n) throw std::invalid_argument("a list of another length than " + std::to_string(n));
  std::array<double, n> result{};
  for (std::size_t i = 0; i < n; ++i) {
    if (!from.items[i].number) throw std::invalid_argument("a list that is not of numbers");
    result[i] = *from.items[i].number;
  }
  return result;
}

/// A point of the plane gets z = 0.
inline Vector point(const Json& from, int dimension) {
  if (dimension != 2) return numbers<3>(from);
  const std::array<double, 2> p = numbers<2>(from);
  return {p[0], p[1], 0};
}

/// The matrix of v -> q v q^-1.
inline Matrix rotation_of(const std::array<double, 4>& q) {
  double largest = 0;
  for (const double c : q) largest = std::fmax(largest, std::fabs(c));
  if (!(largest > 0)) throw std::invalid_argument("a quaternion of zeros");
  const double w = q[0] / largest, x = q[1] / largest, y = q[2] / largest, z = q[3] / largest,
               s = 2 / (w * w + x * x + y * y + z * z);
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
}

inline void place(const Json& pose, Body& body) {
  if (!pose.members.empty()) {
    body.quaternion = numbers<4>(pose.at("quaternion"));
    body.rotation = rotation_of(*body.quaternion);
    body.translation = numbers<3>(pose.at("translation"));
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 4> row = numbers<4>(pose.items.at(i));
    body.rotation[i] = {row[0], row[1], row[2]};
    body.translation[i] = row[3];
  }
}

/// A shape that lies along body.axis, as the library's own that lies along `axis`: a cyclic
/// exchange of axes goes before its rotation.
inline void turn(Body& body, char axis) {
  const std::size_t by = static_cast<std::size_t>(3 + body.axis - axis) % 3;
  body.axis = axis;
  if (by == 0) return;
  for (Vector& row : body.rotation) row = {row[by % 3], row[(1 + by) % 3], row[(2 + by) % 3]};
  if (!body.quaternion) return;
  const auto [w, x, y, z] = *body.quaternion;
  const double s = by == 1 ? 0.5 : -0.5;  // times the quaternion (0.5, s, s, s)
  body.quaternion = {0.5 * w - s * (x + y + z), 0.5 * x + s * (w + y - z), 0.5 * y + s * (w + z - x),
                     0.5 * z + s * (w + x - y)};
}

/// Throws for a shape that lacks its fields, or has others than it can have. Of shapes that are not
/// listed here nothing is known.
inline void check_shape(const Body& body, bool has_pose) {
  static const std::map<std::string, std::vector<std::string>> fields{{"sphere", {"radius"}},
                                                                      {"capsule", {"radius", "half_length"}},
                                                                      {"box", {"half"}},
                                                                      {"cylinder", {"radius", "half_length"}},
                                                                      {"ellipsoid", {"radii"}},
                                                                      {"cone", {"radius", "half_length"}},
                                                                      {"halfspace", {"normal", "offset"}},
                                                                      {"hull", {"vertices"}}};
  const auto found = fields.find(body.shape);
  if (found == fields.end()) return;
  const auto demand = [&body](bool good, const std::string& name) {
    if (!good) throw std::invalid_argument("a " + body.shape + " needs a " + name + ", and one that can be");
  };
  demand(has_pose, "pose");
  for (const std::string& name : found->second) {
    if (name == "vertices") {
      demand(!body.vertices.empty(), name);
    } else if (const auto number = body.number.find(name); number != body.number.end()) {
      demand(name == "offset" || number->second > 0, name);
    } else {
      const auto triple = body.triple.find(name);
      demand(triple != body.triple.end(), name);
      const auto is_positive = [](double x) { return x > 0; };
      const bool all = std::all_of(triple->second.begin(), triple->second.end(), is_positive);
      demand(name == "normal" ? triple->second != Vector{} : all, name);
    }
  }
}

inline void check_faces(const Body& body, bool in_plane) {
  const int vertices = static_cast<int>(body.vertices.size());
  const std::size_t least = in_plane ? 2 : 3;
  for (const std::vector<int>& face : body.faces)
    if (face.size() < least ||
        std::any_of(face.begin(), face.end(), [vertices](int i) { return i < 0 || i >= vertices; }))
      throw std::invalid_argument(in_plane ? "an edge needs two vertices of its body"
                                           : "a face needs three vertices of its body, or more");
}

inline Body body_of(const Json& from, char axis, int dimension) {
  Body body;
  bool has_axis = false, has_pose = false;
  for (const auto& [name, value] : from.members) {
    if (name == "pieces") {
      for (const Json& piece : value.items) body.pieces.push_back(body_of(piece, 0, dimension).vertices);
    } else if (name == "vertices") {
      for (const Json& vertex : value.items) body.vertices.push_back(point(vertex, dimension));
    } else if (name == "faces") {
      for (const Json& face : value.items) {
        body.faces.emplace_back();
        for (const Json& corner : face.items) body.faces.back().push_back(static_cast<int>(corner.number.value()));
      }
    } else if (name == "shape") {
      body.shape = value.text;
    } else if (name == "axis") {
      if (value.text != "x" && value.text != "y" && value.text != "z")
        throw std::invalid_argument("an axis is x, y or z");
      body.axis = value.text[0];
      has_axis = true;
    } else if (name == "margin") {
      if (!value.number || !(*value.number >= 0)) throw std::invalid_argument("a margin is a number, not below 0");
      body.margin = *value.number;
    } else if (name == "pose") {
      place(value, body);
      has_pose = true;
    } else if (value.number) {
      body.number[name] = *value.number;
    } else if (value.items.size() == 3) {
      body.triple[name] = numbers<3>(value);
    }
  }
  if (body.shape.empty() && body.vertices.empty() && body.pieces.empty())
    throw std::invalid_argument("a body without vertices");
  check_faces(body, dimension == 2);
  check_shape(body, has_pose);
  if (has_axis && axis) turn(body, axis);
  return body;
}

inline Twist twist_of(const Json& from) { return {numbers<3>(from.at("v")), numbers<3>(from.at("w"))}; }

inline std::string precision(const Subject& subject) {
  if (subject.answers.empty()) return quoted(subject.precision);
  return "{\"points\":" + quoted(subject.precision) + ",\"answers\":" + quoted(subject.answers) + '}';
}

inline std::string numbers(const std::map<std::string, double>& all) {
  return '{' + joined(all, [](const auto& each) { return quoted(each.first) + ':' + number(each.second); }) + '}';
}

inline std::string rounding(const std::map<std::string, double>& radii) {
  if (radii.empty()) return "";
  const auto of_all = radii.find("");
  return ",\"rounding\":" + (of_all != radii.end() ? number(of_all->second) : numbers(radii));
}

inline std::string hello(const Subject& subject) {
  const std::string settings =
      joined(subject.settings, [](const auto& each) { return quoted(each.first) + ':' + quoted(each.second); });
  return R"({"type":"hello","protocol":"fathom/subject/1","name":)" + quoted(subject.name) +
         (subject.dimension == 2 ? ",\"dimension\":2" : "") + ",\"version\":" + quoted(subject.version) +
         ",\"precision\":" + precision(subject) + ",\"conventions\":{\"touching\":" + quoted(subject.touching) +
         ",\"depth\":" + quoted(subject.depth) + ",\"moves\":" + quoted(subject.moves) +
         ",\"unit\":" + (subject.unit ? "true" : "false") + ",\"claims\":" + quoted(subject.claims) +
         "},\"capabilities\":{\"faces\":" + (subject.faces ? "true" : "false") + ",\"shapes\":" + list(subject.shapes) +
         ",\"twist\":" + (subject.twist ? "true" : "false") + '}' +
         (subject.library.empty() ? "" : ",\"library\":" + quoted(subject.library)) +
         ",\"promises\":" + list(subject.promises) + rounding(subject.rounding) +
         (subject.manifold ? ",\"manifold\":" + numbers(*subject.manifold) : "") + ",\"settings\":{" + settings + "}}";
}

inline std::string contact_text(const Contact& contact, int dimension) {
  return "{\"position\":" + vector(contact.position, dimension) +
         (contact.depth ? ",\"depth\":" + number(*contact.depth) : "") + '}';
}

inline std::string answer(const Reply& reply, int dimension) {
  const auto vector = [dimension](const Vector& v) { return details::vector(v, dimension); };
  const auto contact = [dimension](const Contact& each) { return contact_text(each, dimension); };
  std::string result = std::string("\"overlap\":") + (reply.overlap ? "true" : "false");
  if (reply.depth) result += ",\"depth\":" + number(*reply.depth);
  if (reply.direction) result += ",\"direction\":" + vector(*reply.direction);
  if (reply.witness)
    result += ",\"witness\":{\"a\":" + vector((*reply.witness)[0]) + ",\"b\":" + vector((*reply.witness)[1]) + '}';
  if (reply.distance) result += ",\"distance\":" + number(*reply.distance);
  if (!reply.contacts.empty()) result += ",\"contacts\":[" + joined(reply.contacts, contact) + ']';
  if (reply.derivative) result += ",\"derivative\":" + number(*reply.derivative);
  std::string hulls;
  for (const std::size_t i : {0U, 1U})
    if (!reply.hull[i].empty())
      hulls += (hulls.empty() ? "\"" : ",\"") + std::string(1, "ab"[i]) + "\":[" + joined(reply.hull[i], vector) + ']';
  if (!hulls.empty()) result += ",\"hull\":{" + hulls + '}';
  return result;
}

inline std::string reply_to(const Json& message, const Subject& subject, const Solve& solve) {
  Body a = body_of(message.at("a"), subject.axis, subject.dimension),
       b = body_of(message.at("b"), subject.axis, subject.dimension);
  for (const auto& [name, twist] : message.members) {
    if (name != "twist") continue;
    a.twist = twist_of(twist.at("a"));
    b.twist = twist_of(twist.at("b"));
  }
  std::string said;
  try {
    const auto start = std::chrono::steady_clock::now();
    const Reply reply = solve(a, b);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
    said = answer(reply, subject.dimension);
    if (subject.timed) said += ",\"microseconds\":" + number(reply.microseconds.value_or(spent.count()));
  } catch (const Unsupported& why) {
    said = "\"unsupported\":" + quoted(reason(why.what()));
  } catch (const std::exception& why) {
    said = "\"failed\":" + quoted(reason(why.what()));
  } catch (...) {
    said = R"("failed":"an exception of an unknown type")";
  }
  return R"({"type":"reply","id":")" + message.at("id").text + "\"," + said + '}';
}

/// Answers go to what is the standard output now; what is printed there later, or is still held
/// back, goes to the standard error.
inline void serve(const Subject& subject, const Solve& solve) {
  std::FILE* const out = fdopen(dup(STDOUT_FILENO), "w");
  if (!out || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) throw std::runtime_error("the standard output cannot be used");
  std::fflush(stdout);
  std::string line;
  for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
    std::string text;
    try {
      const Json message = JsonReader(line).read();
      const std::string& type = message.at("type").text;
      if (type == "stop") return;
      if (type == "hello" && message.at("protocol").text != "fathom/subject/1")
        throw std::invalid_argument("this subject speaks fathom/subject/1, not " + message.at("protocol").text);
      if (type == "hello") text = hello(subject);
      else if (type == "run") text = reply_to(message, subject, solve);
      else throw std::invalid_argument("a message that is no hello, run or stop");
    } catch (const std::exception& why) {
      throw std::invalid_argument("line " + std::to_string(number) + ": " + why.what());
    }
    text += '\n';
    if (std::fwrite(text.data(), 1, text.size(), out) != text.size() || std::fflush(out) != 0)
      throw std::runtime_error("an answer cannot be written");
  }
}

}  // namespace details

/// Answers cases until there are no more. Returns the exit code of the program: 0, or 2 for a line
/// that is not of the protocol, which is reported on standard error.
inline int run(const Subject& subject, const Solve& solve) {
  try {
    details::serve(subject, solve);
    return 0;
  } catch (const std::exception& why) {
    std::cerr << subject.name << ": " << why.what() << std::endl;
    return 2;
  }
}

}  // namespace fathom_subject
