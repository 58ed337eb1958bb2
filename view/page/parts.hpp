// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the page that are made of its data: each is HTML, and texts of others are escaped in it. Numbers of the
// answer are copied as they stand in its JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "view/stages/stages.hpp"

namespace fathom::page {

using Data = nlohmann::ordered_json;

/// A length as a decimal, or words for what binary64 does not hold; empty if it is known by bounds only.
std::string decimal_length(const Data& length);
/// Its exact number and roundings, on demand.
std::string exact_length(const Data& length);

/// "A overlaps B by 0.25", without markup.
std::string answer_sentence(const Data& depth);
/// Below the answer: ties, the kind of contact.
std::string subtitle(const Data& depth);
/// Decimals first, exact numbers on demand.
std::string facts(const Data& depth);

/// The first facets of P by distance, with how much longer each way out is than the shortest.
std::string ranked(const stages::Stages& stages);
/// The canonical pairs with the most crossings; those of one crossing are counted.
std::string pairs(const stages::Stages& stages);
/// How the cutting of one canonical pair went.
std::string cutting(const stages::Stages& stages);
/// Coincidences by name, and what decided the zeros.
std::string coincided(const stages::Stages& stages);
/// Each stage's count beside the bound of the paper.
std::string costs(const stages::Stages& stages);

/// What a section shows, in a sentence or two.
std::string lead_why(const stages::Stages& stages);
std::string lead_where(const stages::Stages& stages);
std::string lead_coincided(const stages::Stages& stages);
std::string lead_cost(const stages::Stages& stages);

}  // namespace fathom::page
