// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/expanding/expander.hpp"

namespace fathom {

Workspace::Workspace() : parts(std::make_unique<Parts>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

}  // namespace fathom
