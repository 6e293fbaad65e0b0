// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/output/frame.hpp"

namespace anvil::test {

/// A square copper rod (6.4 x 6.4 x 32 mm) as it looks at `progress` (0 to 1) of its way from the first contact to its
/// final shape on the wall z = 0: length 21.28 mm, foot half-width 8.24 mm, plastic strain 3.5 at the foot. A smooth
/// analytic map with every array of a rod's result, for tests of what reads and draws results: no solver is involved.
/// The rod has `across` x `across` x 5 `across` particles.
Frame make_mushroom(int across, double progress = 1.0, int index = 0);

}  // namespace anvil::test
