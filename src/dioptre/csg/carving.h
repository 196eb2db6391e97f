// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/csg/convex_core.h"
#include "dioptre/csg/evaluation.h"

namespace dioptre::csg {

/// The first visible crossing in the range of a carved tree, a convex core less convex bites, which
/// most differences are: the place where the ray enters the core moves on through the bites that
/// cover it. Asks only for the bites at that place, and needs no counters and no order of events.
/// The bits are those that a sweep would give; kUnclear where faces meet or are invisible, as then
/// a sweep must tell.
NearestEnd carve(const Compiled& tree, Scratch& scratch, const Ray& ray, Interval range,
                 Crossing& out);

}  // namespace dioptre::csg
