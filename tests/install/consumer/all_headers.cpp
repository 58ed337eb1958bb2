// SPDX-License-Identifier: GPL-3.0-or-later
// All of the installed headers in one source, fathom/cgal.hpp apart.
#include <fathom/fathom.h>

#include <fathom/check.hpp>
#include <fathom/fathom.hpp>

#if defined(CGAL_VERSION) || defined(CGAL_VERSION_NR) || defined(BOOST_VERSION)
#error "CGAL leaks through the installed headers"
#endif

int main() {}
