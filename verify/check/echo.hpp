// SPDX-License-Identifier: Apache-2.0
// What a certificate is about, to compare by eye.
#pragma once

#include <string>

#include "certificate.hpp"

namespace fathom_check {

/// The id, the bodies and the claim as they were read, in lines that begin with "c ".
std::string echo(const Certificate& certificate);

}  // namespace fathom_check
