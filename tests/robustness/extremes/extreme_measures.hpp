// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "anvil/measures/result.hpp"
#include "robustness/extremes/extreme_case.hpp"

namespace anvil {

/// A number of a result that a case is held against:
///   max E, min E, mean E     of an expression of fields (measures/frame_fields.hpp) over the particles at the end
///   end C, most C            the last value of a column of the history; the one furthest from zero
///   steps                    of the run
///   spin_kept                angular momentum at the end about the origin over that of the start, about z
///   widest_gap               between columns of particles along x, over the mean one: 1 in uniform stretch
///   energy_balance ...       a measure of lib/measures/measures.hpp
///   stress_l1 ...            a quantity of lib/measures/wave_comparison.hpp
double measure_extreme(const std::string& name, const Result& result, const ExtremeCase& extreme);

}  // namespace anvil
