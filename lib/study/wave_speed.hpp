// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "anvil/study/measures.hpp"

namespace anvil {

// The speed of a wave that runs to the right, into material at rest and without stress. Its place is the first one,
// coming from the right end of the line, where the axial stress over the initial position (linear between two
// particles) has the level of the wave: half of the exact peak stress, or half of the elastic limit where the peak is
// beyond it; for the plastic wave halfway between the elastic limit and the peak. The speed is the distance of the
// places at this time of the study and at the one before over the time between them, and is given over the same of the
// exact solution. NaN at the first time, when the material does not yield, and when the front is not on the line.

double elastic_speed_ratio(const StudySample& sample, std::string_view name);
double plastic_speed_ratio(const StudySample& sample, std::string_view name);

/// Mean error of the stress over the elastic limit in the middle half of the stretch where the exact stress is the
/// elastic limit in compression. Positive where the compression is too high. NaN where there is no such
/// stretch of 20 spacings.
double precursor_error(const StudySample& sample, std::string_view name);

}  // namespace anvil
