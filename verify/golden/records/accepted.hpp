// SPDX-License-Identifier: GPL-3.0-or-later
// What an accepted certificate holds. It is read by the checker's own parser.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/vector.hpp"
#include "verify/check/certificate.hpp"

namespace fathom::golden {

/// Why something is not proved, as one sentence.
struct NotProved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Calls `take` with the certificate, and throws NotProved unless the checker accepts it, `text` holds nothing else, and it has this id;
/// and passes on what `take` throws of that kind, if the certificate is accepted. Nothing that `take` finds may be used otherwise.
void take_accepted(std::string_view text, const std::string& id, const std::function<void(const fathom_check::Certificate&)>& take);

mpq_class value_of(const fathom_check::Rational& q);
Point value_of(const fathom_check::RationalPoint& p);
Vector value_of(const fathom_check::Vector& v);

bool same(const Point& p, const fathom_check::RationalPoint& q);
bool same(const std::vector<Point>& points, const std::vector<fathom_check::RationalPoint>& others);

}  // namespace fathom::golden
