// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "subcommands.hpp"

namespace anvil {

/// Hands the subcommand over to `anvil-figures`, which stands beside this program and takes its place: it returns only
/// by throwing MissingResourceError, when that program cannot be started.
int execute_figures_program(const std::string& subcommand, const Arguments& arguments);

}  // namespace anvil
