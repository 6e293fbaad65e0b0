// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace anvil {

/// What an axis says for a measure of a study: "Mean error of stress / peak stress", "Wall work [J]".
std::string measure_label(const std::string& measure);

/// What an axis says for a key of a scene: "Spacing [m]". A key of an entry, whose unit depends on its type, has none.
std::string key_label(const std::string& key);

}  // namespace anvil
