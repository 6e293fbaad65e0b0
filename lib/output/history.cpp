// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <system_error>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

std::string column_title(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string header_of(const std::vector<Quantity>& row) {
  std::vector<std::string> titles;
  for (const auto& value : row) titles.push_back(column_title(value.name, value.unit));
  return fmt::format("{}", fmt::join(titles, ","));
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t comma = std::min(line.find(',', start), line.size());
    parts.push_back(line.substr(start, comma - start));
    start = comma + 1;
  }
  return parts;
}

HistoryColumn parse_title(std::string_view title) {
  const std::size_t bracket = title.find(" [");
  if (bracket == std::string_view::npos || title.back() != ']') return {std::string(title), "", {}};
  return {
      std::string(title.substr(0, bracket)), std::string(title.substr(bracket + 2, title.size() - bracket - 3)), {}};
}

double parse_number(std::string_view text, const fs::path& path, std::size_t line) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(fmt::format("{}:{}: '{}' is not a number; the file is damaged or not a history of anvil",
                                 path.string(), line, text));
  return number;
}

/// The lines that end in a newline.
std::vector<std::string_view> whole_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string_view::npos) break;
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

}  // namespace

HistoryWriter::HistoryWriter(fs::path path) : path_(std::move(path)) {
  errno = 0;
  stream_.open(path_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw_system_error("write", path_, errno);
}

HistoryWriter::HistoryWriter(fs::path path, std::int64_t rows_to_keep) : path_(std::move(path)) {
  const std::string text = read_text(path_);
  const auto lines = whole_lines(text);
  const auto lines_to_keep = static_cast<std::size_t>(rows_to_keep) + 1;
  if (lines.size() < lines_to_keep)
    throw InputError(fmt::format("'{}' holds {} rows where the checkpoint needs {}; restart from an earlier checkpoint",
                                 path_.string(), lines.empty() ? 0 : lines.size() - 1, rows_to_keep));
  const std::string_view last = lines[lines_to_keep - 1];
  const auto size = static_cast<std::uintmax_t>(last.data() + last.size() + 1 - text.data());
  std::error_code error;
  fs::resize_file(path_, size, error);
  if (error) throw_system_error("write", path_, error.value());
  header_ = lines.front();
  rows_ = rows_to_keep;
  errno = 0;
  stream_.open(path_, std::ios::binary | std::ios::app);
  if (!stream_) throw_system_error("write", path_, errno);
}

void HistoryWriter::append(const std::vector<Quantity>& row) {
  const std::string header = header_of(row);
  if (header_.empty()) {
    write_line(header);
    header_ = header;
  }
  if (header != header_)
    throw InputError(fmt::format("'{}' has the columns {}, this run has {}", path_.string(), header_, header));
  std::vector<double> numbers;
  for (const auto& value : row) numbers.push_back(value.value);
  write_line(fmt::format("{}", fmt::join(numbers, ",")));
  ++rows_;
}

void HistoryWriter::write_line(const std::string& line) {
  errno = 0;
  stream_ << line << '\n' << std::flush;
  if (!stream_) throw_system_error("write", path_, errno);
}

const HistoryColumn* History::find(const std::string& name) const {
  for (const auto& column : columns_)
    if (column.name == name) return &column;
  return nullptr;
}

History read_history(const fs::path& path) {
  const std::string text = read_text(path);
  const auto lines = whole_lines(text);
  if (lines.empty())
    throw InputError(fmt::format("'{}' is empty; a history begins with a line of names", path.string()));
  std::vector<HistoryColumn> columns;
  for (const auto title : split(lines.front())) columns.push_back(parse_title(title));
  for (std::size_t line = 1; line < lines.size(); ++line) {
    const auto parts = split(lines[line]);
    if (parts.size() != columns.size())
      throw InputError(fmt::format("{}:{}: {} numbers for {} columns; the file is damaged or not a history of anvil",
                                   path.string(), line + 1, parts.size(), columns.size()));
    for (std::size_t column = 0; column < columns.size(); ++column)
      columns[column].values.push_back(parse_number(parts[column], path, line + 1));
  }
  return History(std::move(columns));
}

}  // namespace anvil
