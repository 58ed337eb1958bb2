// SPDX-License-Identifier: GPL-3.0-or-later
// The library in one include, for projects that use it as an installed package.
#pragma once

#include "reference/approximate/directional.hpp"
#include "reference/approximate/metric.hpp"
#include "reference/approximate/separation.hpp"
#include "reference/certificate/certificate.hpp"
#include "fathom/depth.hpp"
