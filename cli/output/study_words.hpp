// SPDX-License-Identifier: GPL-3.0-or-later
// The words of studies, which tables for people and pages share.
#pragma once

#include <string>
#include <string_view>

#include "fathom/study.hpp"

namespace fathom::cli {

/// "8 vertices, 12 edges, 6 facets"; "1 disc, radius 1/2".
std::string size_text(const BodySize& size);
std::string size_text(const ShapeSize& size);

/// "penetrating; depth^2 1/16; 1 optimum"; "penetrating; signed depth 1/2".
std::string status_text(const Depth& depth);
std::string status_text(const SignedDepth& depth);

/// "penetrating"; "undecided" if the bounds leave it open.
std::string_view status_name(const SignedDepth& depth);

/// "axis (0, 0, 1) at (0, 0, 0)".
std::string feature_text(const ShapeFeature& feature);
/// "A axis ..., B axis ...".
std::string involved_text(const ShapeInvolved& involved);

}  // namespace fathom::cli
