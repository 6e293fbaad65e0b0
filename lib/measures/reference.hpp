// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "anvil/measures/curve.hpp"

namespace anvil {

struct ReferenceQuantity {
  std::string name;
  std::string unit;
  double value = 0.0;
  double uncertainty = 0.0;
};

struct ReferenceProfile {
  std::string name;
  Curve curve;  // SI
};

/// What a scene should give, from data/reference: [[quantity]] with name, value, uncertainty and unit, and [[profile]]
/// with name and a CSV file beside it.
struct Reference {
  std::string title;
  std::optional<double> time;  // s, at which it holds
  std::vector<ReferenceQuantity> quantities;
  std::vector<ReferenceProfile> profiles;
};

/// Throws InputError with file, line and what was expected.
Reference read_reference(const std::filesystem::path& file);

/// A profile from a CSV file with # comments and a line of names. The first column is the abscissa, the first one with
/// `_ref` in its name the ordinate; names that end in _mm or _us are scaled to SI. Throws InputError.
Curve read_profile(const std::filesystem::path& file);

}  // namespace anvil
