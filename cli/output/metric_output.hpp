// SPDX-License-Identifier: GPL-3.0-or-later
// Depths in a polyhedral norm or gauge for people, and for programs (JSON, schemas/metric.schema.json).
#pragma once

#include <cstddef>
#include <string>

#include "cli/args/request.hpp"
#include "reference/approximate/metric.hpp"

namespace fathom::cli {

/// Several lines, or one; without the last newline.
std::string metric_block(const MetricResult& result, const UnitBall& ball, const Request& request);
std::string metric_line(const std::string& id, const MetricResult& result, const UnitBall& ball, const Request& request);

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string metric_json(const std::string& id, const MetricResult& result, const UnitBall& ball);
/// Returns the line for a case of a stream that has no result.
std::string metric_json_error(const std::string& id, std::size_t line, const std::string& error);

}  // namespace fathom::cli
