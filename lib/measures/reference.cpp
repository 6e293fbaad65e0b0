// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/reference.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <charconv>
#include <sstream>
#include <string_view>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

template <class T>
T required_value(const toml::table& table, const std::string& key, const fs::path& file) {
  const auto value = table[key].value<T>();
  if (!value)
    throw InputError(
        fmt::format("{}:{}: '{}' is missing or of another type", file.string(), table.source().begin.line, key));
  return *value;
}

/// The tables of an [[array]], none when there is no such array.
std::vector<const toml::table*> tables_of(const toml::table& document, const std::string& key) {
  std::vector<const toml::table*> tables;
  if (const toml::array* array = document[key].as_array())
    for (const auto& element : *array)
      if (const toml::table* table = element.as_table()) tables.push_back(table);
  return tables;
}

std::vector<std::string> split_line(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

double unit_factor(const std::string& column) {
  if (column.ends_with("_mm")) return 1e-3;
  if (column.ends_with("_us")) return 1e-6;
  return 1.0;
}

double cell_value(const std::vector<std::string>& cells, std::size_t column, const fs::path& file, int line) {
  double number = 0.0;
  if (column < cells.size()) {
    const std::string& cell = cells[column];
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error == std::errc() && end == cell.data() + cell.size()) return number;
  }
  throw InputError(fmt::format("{}:{}: column {} holds no number", file.string(), line, column + 1));
}

std::size_t ordinate_column(const std::vector<std::string>& names, const fs::path& file) {
  for (std::size_t column = 1; column < names.size(); ++column)
    if (names[column].find("_ref") != std::string::npos) return column;
  throw InputError(fmt::format("'{}' has no column with _ref in its name", file.string()));
}

}  // namespace

Curve read_profile(const fs::path& file) {
  std::istringstream text(read_text(file));
  std::vector<std::string> names;
  std::size_t ordinate = 0;
  Curve curve;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const auto cells = split_line(line);
    if (names.empty()) {
      names = cells;
      ordinate = ordinate_column(names, file);
      continue;
    }
    curve.x.push_back(cell_value(cells, 0, file, number) * unit_factor(names[0]));
    curve.y.push_back(cell_value(cells, ordinate, file, number) * unit_factor(names[ordinate]));
  }
  if (curve.x.empty()) throw InputError(fmt::format("'{}' holds no rows", file.string()));
  return curve;
}

Reference read_reference(const fs::path& file) {
  toml::table document;
  try {
    document = toml::parse(read_text(file), file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
  Reference reference;
  reference.title = document["title"].value_or(file.stem().string());
  reference.time = document["time"].value<double>();
  for (const toml::table* table : tables_of(document, "quantity"))
    reference.quantities.push_back(
        {required_value<std::string>(*table, "name", file), required_value<std::string>(*table, "unit", file),
         required_value<double>(*table, "value", file), required_value<double>(*table, "uncertainty", file)});
  for (const toml::table* table : tables_of(document, "profile"))
    reference.profiles.push_back(
        {required_value<std::string>(*table, "name", file),
         read_profile(file.parent_path() / required_value<std::string>(*table, "file", file))});
  return reference;
}

}  // namespace anvil
