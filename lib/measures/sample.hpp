// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/measures/particle_interpolation.hpp"
#include "anvil/measures/sample_places.hpp"

namespace anvil {

/// Fields of a frame at the points of a grid, as a frame whose particles are the points: every array of the frame that
/// is no whole number, or what `fields` name (arrays, components or expressions, see field_of), and "filling", how
/// full space is there. Values outside the bodies are NaN. Throws InputError where a field is unknown or no point lies
/// in a body.
Frame sample_frame(const Frame& frame, const SampleGrid& grid, const std::vector<std::string>& fields,
                   const InterpolationOptions& options);

/// As CSV: a column per coordinate and component with its unit, on a line also the distance from its begin; "nan" where
/// there is no value.
std::string sample_csv(const Frame& sampled, const SampleGrid& grid);

}  // namespace anvil
