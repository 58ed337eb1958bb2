// SPDX-License-Identifier: GPL-3.0-or-later
// A subject that misbehaves as the first coordinate of A says, and answers about shapes with what
// it was told of them.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fathom_subject.hpp>
#include <iostream>
#include <limits>

namespace {

using fathom_subject::Body, fathom_subject::Reply, fathom_subject::Vector;

[[maybe_unused]] const int loaded = std::printf("a greeting of a library\n");

struct Wordless : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return nullptr; }
};

Reply about_shapes(const Body& a, const Body& b) {
  Reply reply;
  reply.overlap = true;
  if (b.shape == a.shape) {
    reply.hull[0].assign(a.rotation.begin(), a.rotation.end());
    const auto turned = b.quaternion ? fathom_subject::details::rotation_of(*b.quaternion) : b.rotation;
    reply.hull[1].assign(turned.begin(), turned.end());
    return reply;
  }
  reply.depth = a.number.at("radius") + a.margin;
  const auto column = static_cast<std::size_t>(a.axis - 'x');
  reply.direction = Vector{a.rotation[0][column], a.rotation[1][column], a.rotation[2][column]};
  reply.witness = {a.translation, b.shape.empty() ? b.vertices.back() : b.triple.at("half")};
  return reply;
}

Reply solve(const Body& a, const Body& b) {
  if (!a.shape.empty()) return about_shapes(a, b);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double what = a.vertices[0][0];
  Reply reply;
  reply.overlap = true;
  if (!b.pieces.empty()) {
    reply.depth = static_cast<double>(b.pieces.size());
    reply.witness = {a.vertices[0], b.pieces.back().back()};
    return reply;
  }
  if (what == 1) {
    reply.depth = std::nan("");
    reply.direction = Vector{infinity, -infinity, -0.5};
    return reply;
  }
  if (what == 2) {
    constexpr char line[] = "and one from below\n";
    std::cout << "a stray line" << std::endl;
    if (write(STDOUT_FILENO, line, sizeof line - 1) < 0) throw std::runtime_error("standard output is closed");
  }
  if (what == 3) throw std::runtime_error("no \"way\" out");
  if (what == 4) throw fathom_subject::Unsupported("too flat");
  if (what == 6) {
    reply.depth = 0.25;
    reply.hull[0] = a.vertices;
    return reply;
  }
  if (what == 7) {
    reply.depth = 0.25;
    reply.contacts = {{a.vertices[0]}, {a.vertices[1], 0.25}};
    return reply;
  }
  if (what == 8) {
    reply.overlap = false;
    reply.distance = infinity;
    return reply;
  }
  if (what == 9) throw std::runtime_error("half a pair: \xed\xa0\x80");
  if (what == 10) throw std::runtime_error(std::string(17 << 20, 'x'));
  if (what == 11) throw Wordless();
  if (what == 13) {
    reply.microseconds = 12.5;
    return reply;
  }
  if (what == 15) {
    reply.derivative = a.twist.value().v[0] + b.twist.value().w[2];
    return reply;
  }
  if (what == 14) {
    reply.witness = {a.vertices[1], b.vertices[1]};
    return reply;
  }
  if (what == 5) reply.overlap = false;
  else reply.depth = 1.0 / 3 + static_cast<double>(a.faces.size());
  return reply;
}

}  // namespace

int main() {
  fathom_subject::Subject subject{"trial", "7"};
  subject.precision = "binary32";
  subject.answers = "binary64";
  subject.touching = "overlap";
  subject.depth = "negative";
  subject.moves = "b";
  subject.unit = false;
  subject.faces = true;
  subject.twist = true;
  subject.shapes = {"capsule", "box", "margin"};
  subject.promises = {"depth"};
  subject.settings = {{"limit", "3"}};
  subject.claims = "separating";
  subject.rounding = {{"vertices", 0.1}, {"box", 0.25}};
  subject.manifold = {{"most", 4}, {"margin", 0.125}};
  if (std::getenv("FATHOM_KIT_PLANE")) subject.dimension = 2;
  if (std::getenv("FATHOM_KIT_ANY_MANIFOLD")) subject.manifold.emplace();
  if (const char* const axis = std::getenv("FATHOM_KIT_AXIS")) subject.axis = axis[0];
  return fathom_subject::run(subject, solve);
}
