// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "anvil/study/measures.hpp"

namespace anvil {

/// contact_pressure_oscillation and contact_deviator_oscillation, Pa: largest less smallest difference from the exact
/// solution among the ten particles on either side of the first contact of two bodies. NaN without a contact.
double contact_oscillation(const StudySample& sample, std::string_view name);

}  // namespace anvil
