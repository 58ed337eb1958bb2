// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/files/shape_names.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::judging {

std::optional<Body> body_seen(const Body& body, const NumberFormat& format) {
  if (body.shape) return body;
  if (!body.pieces) {
    std::optional<GivenPoints> points = seen(body.points, format);
    return points ? std::optional(Body{*std::move(points)}) : std::nullopt;
  }
  Pieces pieces;
  for (const std::vector<Point>& piece : *body.pieces) {
    const std::optional<GivenPoints> points = seen(GivenPoints(piece), format);
    if (!points) return std::nullopt;
    pieces.push_back(points->exact());
  }
  Body result;
  result.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return result;
}

AnyTruth truth_of(const Body& a, const Body& b, const Options& options) {
  if (a.pieces || b.pieces) return truth_about(pieces_of(a), pieces_of(b), UnionOptions{.monitor = options.monitor});
  if (a.shape || b.shape) return truth_about(files::shape_of(a), files::shape_of(b), SignedDepthOptions{.cores = options});
  return truth_about(a.points, b.points, options);
}

Judgement judged(const AnyTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, Monitor* monitor) {
  return std::visit(
      [&](const auto& known) {
        if constexpr (std::is_same_v<std::decay_t<decltype(known)>, UnionTruth>)
          return judge(known, reply, conventions, format, tolerance, monitor);
        else return judge(known, reply, conventions, format, tolerance);
      },
      truth);
}

}  // namespace fathom::judging
