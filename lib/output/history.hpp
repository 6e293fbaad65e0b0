// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "anvil/core/quantity.hpp"

namespace anvil {

/// Appends to history.csv one row at a time: a first line with names and units ("time [s],step,wall_impulse_z [N s]"),
/// then numbers that read back to the same bits. Every row is handed to the system when it is complete, so that a
/// killed run leaves whole rows, but for the last one at worst.
class HistoryWriter {
 public:
  /// Starts a new file.
  explicit HistoryWriter(std::filesystem::path path);
  /// Goes on with a file of which the first `rows_to_keep` rows are kept and the others cut off. Throws InputError when
  /// it holds fewer.
  HistoryWriter(std::filesystem::path path, std::int64_t rows_to_keep);

  /// Adds a row; the first one of a file defines its columns. Throws InputError when the columns are not those of the
  /// file, MissingResourceError when the row cannot be written.
  void append(const std::vector<Quantity>& row);
  /// Rows in the file, without the header.
  [[nodiscard]] std::int64_t rows() const { return rows_; }

 private:
  void write_line(const std::string& line);

  std::filesystem::path path_;
  std::ofstream stream_;
  std::string header_;
  std::int64_t rows_ = 0;
};

/// A column of a history file.
struct HistoryColumn {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

/// The whole of a history file. A torn last row (of a killed run) is left out.
class History {
 public:
  explicit History(std::vector<HistoryColumn> columns) : columns_(std::move(columns)) {}
  [[nodiscard]] const std::vector<HistoryColumn>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().values.size(); }
  /// The column of that name, or nullptr.
  [[nodiscard]] const HistoryColumn* find(const std::string& name) const;

 private:
  std::vector<HistoryColumn> columns_;
};

/// Throws InputError with path and line when the file cannot be read or is no history.
History read_history(const std::filesystem::path& path);

}  // namespace anvil
