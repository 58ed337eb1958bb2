// SPDX-License-Identifier: Apache-2.0
#include "echo.hpp"

#include <sstream>
#include <utility>

#include "proved.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

std::string text(const RationalPoint& p) { return " " + text(p.x) + " " + text(p.y) + " " + text(p.z); }

void points(std::ostream& out, const char* name, const Body& body, std::size_t first, std::size_t last) {
  out << "c " << name << ' ' << last - first << '\n';
  for (std::size_t k = first; k < last; ++k) out << 'c' << text(body.points.items[k]) << '\n';
}

void shape(std::ostream& out, const char* name, const Body& body) {
  out << "c shape_" << name << ' ' << body.terms.size() << '\n';
  for (const Term& term : body.terms) {
    out << "c term " << term.size() << '\n';
    for (const Atom& atom : term) {
      out << "c " << (atom.size() == 1 ? "point" : atom.size() == 3 ? "disc" : "ball");
      for (const RationalPoint& vector : atom) out << text(vector);
      out << '\n';
    }
  }
}

void core(std::ostream& out, const char* name, const Body& body) {
  switch (body.core) {
    case Body::Core::points: return points(out, name, body, 0, body.points.items.size());
    case Body::Core::shape: return shape(out, name, body);
    case Body::Core::half_space:
      out << "c halfspace_" << name << text(body.normal) << ' ' << text(body.offset) << '\n';
      return;
    case Body::Core::none: return;
    case Body::Core::solid:
      points(out, (std::string("solid_") + name).c_str(), body, 0, body.points.items.size());
      out << "c mesh " << body.solid.mesh.items.size() << '\n';
      for (const auto& [i, j, k] : body.solid.mesh.items) out << "c " << i << ' ' << j << ' ' << k << '\n';
      return;
    case Body::Core::pieces:
      out << "c pieces_" << name << ' ' << body.pieces.size() << '\n';
      for (std::size_t k = 0; k < body.pieces.size(); ++k)
        points(out, name, body, begin_of(body.pieces, k), body.pieces[k].end);
      return;
  }
}

/// The point that these weights yield; weights of points that are not there add nothing.
std::string place(const Body& body, const std::vector<Weight>& weights, std::size_t first, std::size_t last) {
  mpq_class x, y, z;
  for (std::size_t k = first; k < last; ++k) {
    if (weights[k].index >= body.points.items.size()) continue;
    const RationalPoint& p = body.points.items[weights[k].index];
    const mpq_class weight = value(weights[k].weight);
    x += weight * value(p.x);
    y += weight * value(p.y);
    z += weight * value(p.z);
  }
  return " " + x.get_str() + " " + y.get_str() + " " + z.get_str();
}

/// The corners as points of both bodies, of which a half-space has none.
void patches(std::ostream& out, const Certificate& c) {
  const PatchParts& parts = c.of_patches;
  for (std::size_t k = 0, corner = 0; k < parts.corner_lists.size(); ++k) {
    const std::size_t last = parts.corner_lists[k].end;
    out << "c patch " << last - corner << '\n';
    for (; corner < last; ++corner) {
      const auto [end_a, end_b] = parts.corners.items[corner];
      const std::size_t begin = parts.begin_of(corner);
      out << 'c';
      if (begin < end_a) out << " a" << place(c.a, parts.weights, begin, end_a);
      if (end_a < end_b) out << " b" << place(c.b, parts.weights, end_a, end_b);
      out << '\n';
    }
  }
  for (const PatchParts::Rate& rate : parts.rates.items)
    out << "c rate" << text(rate.v) << text(rate.w) << ' ' << rate.sign.value() << ' ' << text(rate.root) << '\n';
}

}  // namespace

std::string echo(const Certificate& c) {
  std::ostringstream out;
  if (!c.id.empty()) out << "c id " << c.id << '\n';
  for (const auto& [name, body] : {std::pair{"a", &c.a}, std::pair{"b", &c.b}}) {
    core(out, name, *body);
    if (body->radius.num.sign() != 0) out << "c radius_" << name << ' ' << text(body->radius) << '\n';
  }
  out << "c claim ";
  switch (c.claim) {
    case Claim::depth: out << "depth " << text(c.low) << '\n'; break;
    case Claim::bounds: out << "bounds " << text(c.low) << ' ' << text(c.high) << '\n'; break;
    case Claim::solid: out << "solid\n"; break;
    case Claim::touching: out << "touching\n"; break;
    case Claim::disjoint: out << "disjoint\n"; break;
    case Claim::apart: out << "apart " << text(c.low) << '\n'; break;
    case Claim::signed_bounds: out << "signed_bounds " << text(c.low) << ' ' << text(c.high) << '\n'; break;
  }
  patches(out, c);
  return out.str();
}

}  // namespace fathom_check
