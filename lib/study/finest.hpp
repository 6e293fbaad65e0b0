// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/study/runner.hpp"

namespace anvil {

/// For grids that ask for it (`against = "finest"`), puts in place of each measure its deviation from the run with the
/// most particle-steps among those that differ in the last axis alone: |value / value there - 1|, at the same time.
/// What that run itself measured becomes NaN, and so does everything where no run came to the time. Such an error
/// misses what the finest run is off by: at an observed order p and half the spacing, a share of 1/(2^p - 1) of its
/// own.
void compare_with_finest(const StudyDescription& study, std::vector<StudyRun>& runs);

}  // namespace anvil
