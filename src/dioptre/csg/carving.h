// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/csg/convex_core.h"
#include "dioptre/csg/evaluation.h"

namespace dioptre::csg {

/// The first visible crossing in the range of a carved tree, which most solids are: a convex core,
/// cut by at most one other leaf, less convex bites. The place where the ray enters the core moves
/// on through what covers it. Asks only for the bites at that place, and needs no counters and no
/// order of events. The bits are those that a sweep would give; kUnclear where faces meet or are
/// invisible, as then a sweep must tell.
NearestEnd carve(const Compiled& tree, Scratch& scratch, const Ray& ray, Interval range,
                 Crossing& out);

}  // namespace dioptre::csg
