// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "anvil/solver/run.hpp"

namespace anvil {

/// A bar with the time left when standard error is a terminal, a line every 10 % or 5 s otherwise, nothing when
/// `quiet`.
std::unique_ptr<Progress> make_progress(bool quiet);

/// "42 s", "3:07 min", "1:20 h".
std::string duration_text(double seconds);

}  // namespace anvil
