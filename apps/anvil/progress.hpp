// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "anvil/solver/run.hpp"

namespace anvil {

/// A bar with the time left when standard error is a terminal, a line every 10 % or 5 s otherwise, nothing when
/// `quiet`.
std::unique_ptr<Progress> make_progress(bool quiet);

}  // namespace anvil
