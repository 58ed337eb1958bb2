// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/subjects/subject.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "verify/subjects/read_shape.hpp"

namespace subject {
namespace {

using nlohmann::json;

constexpr const char* protocol = "fathom/subject/1";

/// The part of a program that is known once its command line is read.
struct Running {
  const Program& program;
  const Mode& mode;
  Settings settings;
  Solver solve;
};

/// JSON has no NaN and no infinities: they go as strings.
json number_json(double x) {
  if (std::isnan(x)) return std::signbit(x) ? "-nan" : "nan";
  if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
  return x;
}

json vector_json(const Vector& v) { return json::array({number_json(v[0]), number_json(v[1]), number_json(v[2])}); }

json hello(const Running& running) {
  const Mode& mode = running.mode;
  return {{"type", "hello"},
          {"protocol", protocol},
          {"name", mode.name},
          {"version", running.program.version},
          {"library", running.program.library},
          {"precision", running.program.precision},
          {"conventions", {{"touching", "either"}, {"depth", mode.depth}, {"moves", mode.moves}, {"unit", true}}},
          {"capabilities", {{"faces", mode.faces}, {"shapes", mode.shapes}}},
          {"settings", running.settings.in_force()}};
}

Body read_body(const json& from) {
  if (from.contains("shape")) return read_shape(from);
  Body body;
  body.vertices = from.at("vertices").get<std::vector<Vector>>();
  if (body.vertices.empty()) throw std::invalid_argument("a body without vertices");
  if (from.contains("faces")) body.faces = from.at("faces").get<std::vector<std::vector<int>>>();
  const int vertices = static_cast<int>(body.vertices.size());
  for (const std::vector<int>& face : body.faces)
    if (face.size() < 3 || std::ranges::any_of(face, [vertices](int i) { return i < 0 || i >= vertices; }))
      throw std::invalid_argument("a face needs three vertices of its body, or more");
  return body;
}

void tell(const Reply& answer, json& reply) {
  reply["overlap"] = answer.overlap;
  if (answer.depth) reply["depth"] = number_json(*answer.depth);
  if (answer.distance) reply["distance"] = number_json(*answer.distance);
  if (answer.direction) reply["direction"] = vector_json(*answer.direction);
  if (answer.witness) reply["witness"] = {{"a", vector_json((*answer.witness)[0])}, {"b", vector_json((*answer.witness)[1])}};
  for (const Contact& contact : answer.contacts)
    reply["contacts"].push_back({{"position", vector_json(contact.position)}, {"depth", number_json(contact.depth)}});
}

json reply_to(const json& request, const Running& running) {
  const Body a = read_body(request.at("a")), b = read_body(request.at("b"));
  json reply = {{"type", "reply"}, {"id", request.at("id")}};
  try {
    check_taken(a, running.mode);
    check_taken(b, running.mode);
    tell(running.solve(a, b), reply);
  } catch (const Unsupported& reason) {
    reply["unsupported"] = reason.what();
  } catch (const std::exception& failure) {
    reply["failed"] = failure.what();
  }
  return reply;
}

/// The line that answers `line`; nullopt for "stop". Throws for a line that is not of the protocol.
std::optional<json> answer_to(const std::string& line, const Running& running) {
  const json request = json::parse(line);
  const std::string type = request.at("type").get<std::string>();
  if (type == "hello") {
    const std::string spoken = request.at("protocol").get<std::string>();
    if (spoken != protocol) throw std::invalid_argument("this subject speaks " + std::string(protocol) + ", not " + spoken);
    return hello(running);
  }
  if (type == "run") return reply_to(request, running);
  if (type == "stop") return std::nullopt;
  throw std::invalid_argument("expected a line of type hello, run or stop, found " + type);
}

/// The stream for answers. Behind it nothing but answers is written: the library's own prints go to the standard error.
std::FILE* answers() {
  std::FILE* const stream = fdopen(dup(STDOUT_FILENO), "w");
  if (!stream || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) throw std::runtime_error("the standard output cannot be used");
  return stream;
}

void serve(const Running& running) {
  std::FILE* const out = answers();
  std::ios::sync_with_stdio(false);
  std::string line;
  for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
    std::optional<json> answer;
    try {
      answer = answer_to(line, running);
    } catch (const std::exception& reason) {
      throw std::invalid_argument("line " + std::to_string(number) + ": " + reason.what());
    }
    if (!answer) return;
    // A library's message may hold bytes that are not UTF-8.
    const std::string text = answer->dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
    if (std::fwrite(text.data(), 1, text.size(), out) != text.size() || std::fflush(out) != 0)
      throw std::runtime_error("an answer cannot be written");
  }
}

Running prepared(const Program& program, const std::vector<std::string>& words) {
  std::string modes;
  for (const Mode& mode : program.modes) modes += (modes.empty() ? "" : " | ") + mode.argument;
  if (words.empty()) throw std::invalid_argument("usage: " + modes + "   [KEY=VALUE...]");
  const auto mode = std::ranges::find(program.modes, words[0], &Mode::argument);
  if (mode == program.modes.end()) throw std::invalid_argument("expected " + modes + ", found " + words[0]);
  Running running{program, *mode, Settings({words.begin() + 1, words.end()}), {}};
  running.solve = mode->make(running.settings);
  running.settings.check_all_used();
  return running;
}

}  // namespace

Settings::Settings(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == 0 || sign == std::string::npos) throw std::invalid_argument("expected KEY=VALUE, found " + word);
    if (!given_.emplace(word.substr(0, sign), word.substr(sign + 1)).second) throw std::invalid_argument(word + " sets a key again");
  }
}

std::optional<std::string> Settings::taken(const std::string& key) {
  const auto found = given_.find(key);
  if (found == given_.end()) return std::nullopt;
  std::string value = found->second;
  given_.erase(found);
  return value;
}

double Settings::number(const std::string& key, double usual) {
  double value = usual;
  if (const auto text = taken(key)) {
    const json read = json::parse(*text, nullptr, false);
    if (!read.is_number()) throw std::invalid_argument(key + " expects a number, found " + *text);
    value = read.get<double>();
  }
  note(key, json(value).dump());
  return value;
}

unsigned long Settings::count(const std::string& key, unsigned long usual) {
  constexpr unsigned long endless = std::numeric_limits<unsigned long>::max();
  constexpr const char* no_limit = "no limit";
  unsigned long value = usual;
  if (const auto text = taken(key)) {
    const json read = json::parse(*text, nullptr, false);
    if (*text != no_limit && !read.is_number_unsigned()) throw std::invalid_argument(key + " expects a whole number, found " + *text);
    value = *text == no_limit ? endless : read.get<unsigned long>();
  }
  note(key, value == endless ? no_limit : std::to_string(value));
  return value;
}

std::optional<Vector> Settings::vector(const std::string& key, const std::string& usual) {
  const auto text = taken(key);
  note(key, text.value_or(usual));
  if (!text) return std::nullopt;
  Vector v{};
  std::istringstream from(*text);
  char colon = ':', second = ':';
  if (!(from >> v[0] >> colon >> v[1] >> second >> v[2]) || colon != ':' || second != ':' || from.peek() != EOF)
    throw std::invalid_argument(key + " expects three numbers x:y:z, found " + *text);
  return v;
}

void Settings::note(const std::string& key, const std::string& text) { told_[key] = text; }

void Settings::check_all_used() const {
  if (given_.empty()) return;
  std::string keys;
  for (const auto& [key, value] : told_) keys += " " + key;
  throw std::invalid_argument(given_.begin()->first + " is no setting of this mode; it has" + (keys.empty() ? " none" : keys));
}

Vector mean(const std::vector<Vector>& points) {
  Vector mean{};
  for (const Vector& point : points)
    for (int i = 0; i < 3; ++i) mean[i] += point[i] / static_cast<double>(points.size());
  return mean;
}

Body hull(const Body& body) {
  if (body.faces.empty()) throw Unsupported("a flat body: the library's convex bodies are made of faces");
  constexpr int unused = -1;
  std::vector<int> names(body.vertices.size(), unused);
  for (const std::vector<int>& face : body.faces)
    for (const int i : face) names[i] = 0;
  Body hull{{}, body.faces};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == unused) continue;
    names[i] = static_cast<int>(hull.vertices.size());
    hull.vertices.push_back(body.vertices[i]);
  }
  for (std::vector<int>& face : hull.faces)
    for (int& i : face) i = names[i];
  return hull;
}

int run(const Program& program, int argc, char** argv) {
  try {
    serve(prepared(program, {argv + std::min(argc, 1), argv + argc}));
    return 0;
  } catch (const std::exception& reason) {
    std::cerr << (argc > 0 ? argv[0] : "subject") << ": " << reason.what() << std::endl;
    return 2;
  }
}

}  // namespace subject
