// SPDX-License-Identifier: GPL-3.0-or-later
// One question for bodies of any kinds, and its answer in the same words: a cube, a ball, and a
// block with a slot. And an answer with its proof: a checker that shares no code with the library
// reads the certificate.
#include <fathom/answer.hpp>
#include <fathom/certificate.hpp>
#include <fathom/check.hpp>
#include <fathom/files.hpp>
#include <fathom/patch.hpp>
#include <iostream>
#include <string>
#include <vector>

void tell(const std::string& bodies) {
  const fathom::Case asked = fathom::parse_case(bodies, "memory").value();
  const fathom::Answer answer = fathom::exact_answer(asked.a, asked.b);
  std::cout << answer.status_name() << (answer.complete() ? "" : ", as far as is known") << ", between "
            << answer.low_binary64() << " and " << answer.high_binary64();
  if (bool(answer.exact()) && compare(answer.low(), answer.high()) == 0)
    std::cout << ", exactly " << answer.exact()->rational << " + root of " << answer.exact()->root;
  if (answer.nearest_binary64()) std::cout << ", nearest " << *answer.nearest_binary64();
  const fathom::BodyFacts facts = facts_of(asked.a, asked.b, answer);
  std::cout << "; " << answer.ways_out() << " ways out" << (facts.flat_a || facts.flat_b ? ", one is flat" : "")
            << '\n';

  if (answer.ways_out() > 0)
    std::cout << "  the first moves A along x by " << answer.way_out(0).translation[0].rational << '\n';
  if (const auto direction = answer.direction())
    std::cout << "  direction " << direction->x << ' ' << direction->y << ' ' << direction->z;
  else std::cout << "  " << direction.why_not;
  if (const auto translation = answer.translation())
    std::cout << ", translation in binary64 " << round_binary64((*translation)[0]);
  std::cout << (answer.contact() ? ", " + std::string(name(answer.contact()->kind)) : "") << '\n';
  if (const auto witness = answer.witness())
    std::cout << "  a point of A at x = " << round_binary64(witness->a[0]) << '\n';
  else std::cout << "  " << witness.why_not << '\n';
  if (const auto bounds = answer.union_bounds()) std::cout << "  the hulls' depth squared is " << bounds->hulls << '\n';
  if (const fathom::Depth* const core = answer.core())
    std::cout << "  " << core->optima_count() << " nearest facets of the cores\n";
  std::cout << "  " << fathom::certificate_text(asked.a, asked.b, answer, "shown").substr(0, 20) << '\n';
}

void prove() {
  const std::vector<fathom::Point> a{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const std::vector<fathom::Point> b{{1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}};
  const fathom::Depth depth = fathom::penetration_depth(a, b);
  fathom::Certificate certificate = fathom::make_certificate(a, b, depth);
  certificate.id = "tetrahedra";
  const std::string text = fathom::certificate_text(certificate);  // for fathom-check, check.py and the proved checker
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  std::cout << fathom_check::verdict_line(verdict, "") << "\n";

  // That the depth lies between two bounds can be proved without knowing it.
  const auto bounds = fathom::make_bounds_certificate(a, b, mpq_class(1, 4), 1);
  std::cout << fathom_check::verdict_line(fathom_check::verify(fathom::certificate_text(bounds)), "bounds") << "\n";

  // Where the bodies touch, and how fast the depth changes as A sinks, can be proved with it.
  const fathom::Body body_a{a}, body_b{b};
  const fathom::Answer answer{depth};
  const fathom::ContactGeometry touching = contact_geometry(body_a, body_b, answer);
  const std::vector<fathom::Twist> sinking{{{0, 0, -1}, {}}};
  if (touching.tells_smoothness()) {  // not of unions, nor of curved bodies
    const std::string proof = certificate_text(body_a, body_b, answer, touching, sinking, "patches");
    std::cout << fathom_check::verdict_line(fathom_check::verify(proof), "") << "\n";
  }

  // A text that was changed is refused.
  std::cout << fathom_check::verify(text + "end\n").accepted() << "\n";
}

int main() {
  tell(
      R"({"a": {"shape": "box", "half": [1, 1, 1]}, "b": {"shape": "box", "half": [1, 1, 1], "pose": "xyz=1.5,0,0"}})");
  tell(R"({"a": {"shape": "sphere", "radius": 1}, "b": {"shape": "box", "half": [1, 1, 1], "pose": "xyz=3,0,0"}})");
  tell(
      R"({"a": {"shape": "box", "half": [1, 1, 1]}, "b": {"pieces": [{"shape": "box", "half": [1, 1, 1], "pose": "xyz=1,0,0"}]}})");
  prove();
}

//> penetrating, between 0.5 and 0.5, exactly 0 + root of 1/4, nearest 0.5; 1 ways out
//>   the first moves A along x by -1/2
//>   direction -1 0 0, translation in binary64 -0.5, facet-facet
//>   a point of A at x = 1
//>   1 nearest facets of the cores
//>   fathom-certificate 1
//> disjoint, between -1 and -1, exactly 1 + root of -4, nearest -1; 0 ways out
//>   direction -1 0 0, translation in binary64 1, vertex-facet
//>   a point of A at x = 1
//>   0 nearest facets of the cores
//>   fathom-certificate 2
//> penetrating, between 1 and 1, exactly 0 + root of 1, nearest 1; 1 ways out
//>   the first moves A along x by -1
//>   direction -1 0 0, translation in binary64 -1
//>   unions have a pair of witness points only if they are disjoint
//>   the hulls' depth squared is 1
//>   fathom-certificate 3
//> s VERIFIED penetrating depth_squared=1/3 optima=1 tetrahedra
//> s VERIFIED penetrating depth_squared_in=[1/4,1] bounds
//> s VERIFIED penetrating signed_depth=sqrt(1/3)+0 optima=1 patches=6 rates=1 patches
//> 0
