// SPDX-License-Identifier: GPL-3.0-or-later
// The library in one include. Not included: fathom/cgal.hpp, which needs CGAL; fathom/check.hpp,
// the independent checker of certificates; and fathom/fathom.h, the library for C.
#pragma once

#include "fathom/answer.hpp"
#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/impact.hpp"
#include "fathom/judge.hpp"
#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "fathom/overlap.hpp"
#include "fathom/plane.hpp"
#include "fathom/prepared.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/solid.hpp"
#include "fathom/study.hpp"
#include "fathom/union.hpp"
