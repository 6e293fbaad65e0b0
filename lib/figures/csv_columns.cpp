// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/csv_columns.hpp"

#include <fmt/core.h>

#include <boost/algorithm/string.hpp>
#include <charconv>
#include <sstream>

#include "anvil/core/error.hpp"
#include "anvil/figures/unit.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  boost::split(cells, line, [](char c) { return c == ','; });
  for (auto& cell : cells) boost::trim(cell);
  return cells;
}

struct ScaledColumn {
  CsvColumn column;
  double factor = 1.0;
};

ScaledColumn column_from(const std::string& heading) {
  if (const auto bracket = heading.find('['); bracket != std::string::npos && heading.ends_with(']')) {
    const Unit unit = find_unit(heading.substr(bracket + 1, heading.size() - bracket - 2));
    return {{boost::trim_copy(heading.substr(0, bracket)), unit.si, {}}, unit.factor};
  }
  if (heading.ends_with("_mm")) return {{heading, "m", {}}, 1e-3};
  if (heading.ends_with("_us")) return {{heading, "s", {}}, 1e-6};
  return {{heading, "", {}}, 1.0};
}

}  // namespace

std::vector<CsvColumn> read_csv_columns(const std::filesystem::path& file) {
  std::istringstream text(read_text(file));
  std::vector<ScaledColumn> columns;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    boost::trim(line);
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (columns.empty()) {
      for (const auto& cell : cells) columns.push_back(column_from(cell));
      continue;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      double value = 0.0;
      const std::string cell = i < cells.size() ? cells[i] : "";
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (error != std::errc() || end != cell.data() + cell.size())
        throw InputError(fmt::format("{}:{}: column {} holds no number", file.string(), number, i + 1));
      columns[i].column.values.push_back(value * columns[i].factor);
    }
  }
  std::vector<CsvColumn> result;
  for (auto& column : columns) result.push_back(std::move(column.column));
  return result;
}

const CsvColumn& column_of(const std::vector<CsvColumn>& columns, const std::string& name, const std::string& file) {
  std::vector<std::string_view> names;
  for (const auto& column : columns) {
    if (column.name == name) return column;
    names.push_back(column.name);
  }
  throw InputError(fmt::format("'{}' has no column '{}'{}", file, name, suggestion(name, names)));
}

}  // namespace anvil
