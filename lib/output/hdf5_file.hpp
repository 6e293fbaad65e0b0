// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace anvil {

/// A table of numbers as it stands in an HDF5 file: rows x components, row by row.
template <class T>
struct Hdf5Table {
  int components = 1;
  std::string unit;
  std::vector<T> values;
};

/// An HDF5 file of named tables and texts; names are paths such as "arrays/density". Numbers keep their bits and are
/// guarded by checksums. The same content makes the same file, byte by byte: no times are stored.
class Hdf5File {
 public:
  /// Starts a file; `format` names what it holds and its version, for example "anvil frame 1".
  static Hdf5File create(const std::filesystem::path& path, const std::string& format);
  /// Opens a file for reading; throws InputError unless it is a whole HDF5 file of that format.
  static Hdf5File open(const std::filesystem::path& path, const std::string& format);

  /// Whether a file is one that open() takes; false when it is missing or damaged.
  static bool is_format(const std::filesystem::path& path, const std::string& format);

  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File();

  /// Throw MissingResourceError when the file cannot take them.
  void write(const std::string& name, const Hdf5Table<double>& table);
  void write(const std::string& name, const Hdf5Table<std::int64_t>& table);
  void write(const std::string& name, const std::string& text);
  void write_number(const std::string& name, double value) { write(name, Hdf5Table<double>{1, "", {value}}); }
  void write_number(const std::string& name, std::int64_t value) {
    write(name, Hdf5Table<std::int64_t>{1, "", {value}});
  }
  /// Flushes and closes; errors of the disk that show only now throw MissingResourceError.
  void close();

  /// Names of all entries below a group, relative to it and sorted; none when there is no such group.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const;
  [[nodiscard]] bool holds_integers(const std::string& name) const;
  /// Throw InputError with path and name when the entry is missing, damaged or of another type.
  [[nodiscard]] Hdf5Table<double> read_doubles(const std::string& name) const;
  [[nodiscard]] Hdf5Table<std::int64_t> read_integers(const std::string& name) const;
  [[nodiscard]] std::string read_text_entry(const std::string& name) const;
  [[nodiscard]] double read_double(const std::string& name) const;
  [[nodiscard]] std::int64_t read_integer(const std::string& name) const;

 private:
  Hdf5File(std::filesystem::path path, std::int64_t id) : path_(std::move(path)), id_(id) {}

  std::filesystem::path path_;
  std::int64_t id_;  // HDF5's hid_t, kept out of this header
};

}  // namespace anvil
