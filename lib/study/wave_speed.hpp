// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "anvil/study/measures.hpp"

namespace anvil {

// The speed of a wave that runs to the right, into material at rest and without stress: coming from the right end of
// the line, the first place (initial position, between two particles by linear interpolation) where the axial stress
// has the level of the wave, at this time of the study and at the one before; distance over time. The level is half of
// the exact peak stress, or half of the elastic limit where the peak is beyond it, and for the plastic wave halfway
// between the elastic limit and the peak. NaN at the first time, when the material does not yield, and when the front
// is not on the line.

/// Speed of the elastic wave over that of the material at small strain.
double elastic_speed_ratio(const StudySample& sample, std::string_view name);
/// Speed of the plastic wave over that of the material at small strain.
double plastic_speed_ratio(const StudySample& sample, std::string_view name);

/// Relative error of the mean stress in the middle half of the stretch where the exact stress is the elastic limit in
/// compression. NaN where there is no such stretch of 20 spacings.
double precursor_error(const StudySample& sample, std::string_view name);

}  // namespace anvil
