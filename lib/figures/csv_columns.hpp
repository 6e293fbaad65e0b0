// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anvil {

/// A column of a CSV file, in SI units.
struct CsvColumn {
  std::string name;
  std::string si_unit;  // "" when the file names none
  std::vector<double> values;
};

/// A CSV file with a line of names and # comments before it. Units stand in the name, as in "stress_xx [Pa]" or
/// "height_mm"; what is not in SI units is scaled. Throws InputError with file and line.
std::vector<CsvColumn> read_csv_columns(const std::filesystem::path& file);

/// Throws InputError with the nearest name.
const CsvColumn& column_of(const std::vector<CsvColumn>& columns, const std::string& name, const std::string& file);

}  // namespace anvil
