// SPDX-License-Identifier: GPL-3.0-or-later
// Manifests as JSON values, for the pages that hold several.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "verify/golden/shards/manifest.hpp"

namespace fathom::golden {

nlohmann::ordered_json manifest_json(const Manifest& manifest);

/// Throws std::exception if a field is missing or of another kind; ignores unknown fields.
Manifest manifest_of(const nlohmann::ordered_json& json);

}  // namespace fathom::golden
