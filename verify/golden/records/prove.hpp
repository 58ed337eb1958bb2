// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a record against its certificate, from their texts alone; trusts neither. The default is refusal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fathom::golden {

/// Returns nullopt if everything in the line is proved, else one sentence on what is not. `line` has no line feed, `certificate` holds
/// exactly one certificate. What is proved: the certificate, by the checker that shares nothing with the rest; that it is about the points
/// of the line, and that the source yields these points; that status, depth and directions are those of the certificate; every rounded
/// value, translation, contact, witness, gap, format and flag by computing it again. Fields that are missing, repeated or unknown are
/// refused. Throws nothing on bad input.  [proofs/golden.md]
std::optional<std::string> faults_of(std::string_view line, std::string_view certificate);

/// Returns the id in a record's line, as far as it can be read, for messages.
std::string id_in(std::string_view line);

}  // namespace fathom::golden
