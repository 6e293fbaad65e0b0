// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

#include "anvil/study/measures.hpp"

namespace anvil {

/// What `anvil compare` measures, as a measure of a study: a quantity by its name ("length"), and "deviation." before
/// the name of a quantity or of a profile ("deviation.half_width_profile_l2"): its absolute deviation from the
/// published or converged reference of the scene. Nothing for other names.
std::optional<StudyMeasure> find_compared_measure(std::string_view name);

/// Whether a measure of that name reads the history of the run.
bool reads_history(std::string_view name);

}  // namespace anvil
