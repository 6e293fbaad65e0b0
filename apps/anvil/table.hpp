// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace anvil {

using TableRow = std::vector<std::string>;

/// Prints rows with aligned columns to standard output, two spaces between them. Columns that hold numbers are aligned
/// to the right: `alignment` has one letter per column, l or r.
void print_table(const std::vector<TableRow>& rows, const std::string& alignment);

}  // namespace anvil
