// SPDX-License-Identifier: GPL-3.0-or-later
// An answer with its proof: a checker that shares no code with the library reads the certificate.
#include <fathom/certificate.hpp>
#include <fathom/check.hpp>
#include <fathom/patch.hpp>
#include <iostream>
#include <vector>

int main() {
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

//> s VERIFIED penetrating depth_squared=1/3 optima=1 tetrahedra
//> s VERIFIED penetrating depth_squared_in=[1/4,1] bounds
//> s VERIFIED penetrating signed_depth=sqrt(1/3)+0 optima=1 patches=6 rates=1 patches
//> 0
