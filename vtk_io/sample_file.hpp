// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "anvil/measures/sample_places.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// Writes values on the points of a grid, as the arrays of `sampled` hold them: .vtp as a line or as quads between the
/// points, .vti as an image that lies in space as the grid does. Throws InputError for another ending,
/// MissingResourceError when the file cannot be written.
void write_sample_file(const Frame& sampled, const SampleGrid& grid, const std::filesystem::path& file);

}  // namespace anvil
