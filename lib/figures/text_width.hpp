// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace anvil {

/// Width of a UTF-8 text in DejaVu Sans of the given size, to a few percent: enough to leave room for it.
double text_width(std::string_view text, double size);

}  // namespace anvil
