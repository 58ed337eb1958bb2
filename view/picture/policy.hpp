// SPDX-License-Identifier: GPL-3.0-or-later
// What a page may do: run the scripts and use the styles that it was made with. It asks no network and no other file for anything.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fathom::picture {

/// Returns the Content-Security-Policy of a page that holds exactly these texts in <script> and <style> elements, and pictures as data at
/// most. Blocks of data, <script type="application/json">, are no scripts to it.
std::string security_policy(std::span<const std::string_view> scripts, std::span<const std::string_view> styles);

/// The same as the <meta> element that stands before all others of the head but the charset.
std::string policy_element(std::span<const std::string_view> scripts, std::span<const std::string_view> styles);

}  // namespace fathom::picture
