// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/hdf5_file.hpp"

#include <fmt/core.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;
static_assert(sizeof(hid_t) == sizeof(std::int64_t));

constexpr hsize_t chunk_rows = 1 << 15;
constexpr const char* format_entry = "format";
constexpr const char* unit_attribute = "unit";

/// Owns one of HDF5's identifiers. A negative one means that the call that made it failed.
class OwnedId {
 public:
  OwnedId(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  OwnedId(OwnedId&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  OwnedId(const OwnedId&) = delete;
  OwnedId& operator=(const OwnedId&) = delete;
  ~OwnedId() {
    if (valid()) close_(id_);
  }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  [[nodiscard]] hid_t id() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// HDF5 prints a stack of its own on every error; ours says it in a sentence. And it tries once more at the end of the
/// program to write files that the disk refused, which crashes; ours are closed by then, so it has nothing to do there.
void tame_hdf5() {
  [[maybe_unused]] static const herr_t before_its_first_use = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

[[noreturn]] void throw_cannot_write(const fs::path& path) {
  throw MissingResourceError(fmt::format(
      "cannot write '{}': the HDF5 library refused; is the disk full or the folder read-only?", path.string()));
}

[[noreturn]] void throw_damaged(const fs::path& path, const std::string& name) {
  throw InputError(fmt::format("'{}' is damaged: its entry '{}' is missing or cannot be read", path.string(), name));
}

/// Checksums need chunks; an empty table has none.
OwnedId creation_properties(hsize_t rows, hsize_t components) {
  OwnedId properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.id(), false);
  if (rows > 0 && components > 0) {
    const std::array<hsize_t, 2> chunk = {std::min(rows, chunk_rows), components};
    H5Pset_chunk(properties.id(), 2, chunk.data());
    H5Pset_fletcher32(properties.id());
  }
  return properties;
}

OwnedId string_type(std::size_t size) {
  OwnedId type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), size);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

void write_unit(hid_t table, const std::string& unit, const fs::path& path) {
  if (unit.empty()) return;
  const OwnedId type = string_type(unit.size() + 1);
  const OwnedId space(H5Screate(H5S_SCALAR), H5Sclose);
  const OwnedId attribute(H5Acreate2(table, unit_attribute, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute.id(), type.id(), unit.c_str()) < 0) throw_cannot_write(path);
}

std::string read_unit(hid_t table) {
  if (H5Aexists(table, unit_attribute) <= 0) return "";
  const OwnedId attribute(H5Aopen(table, unit_attribute, H5P_DEFAULT), H5Aclose);
  const OwnedId type(H5Aget_type(attribute.id()), H5Tclose);
  std::string unit(H5Tget_size(type.id()), '\0');
  H5Aread(attribute.id(), type.id(), unit.data());
  return unit.c_str();  // cuts at the terminating zero
}

/// Makes the entry `name` and the groups it lies in, and fills it.
void write_entry(hid_t file, const fs::path& path, const std::string& name, hid_t type, hsize_t rows,
                 hsize_t components, const void* values, const std::string& unit) {
  const std::array<hsize_t, 2> extents = {rows, components};
  const OwnedId space(H5Screate_simple(2, extents.data(), nullptr), H5Sclose);
  const OwnedId links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  const OwnedId properties = creation_properties(rows, components);
  const OwnedId entry(H5Dcreate2(file, name.c_str(), type, space.id(), links.id(), properties.id(), H5P_DEFAULT),
                      H5Dclose);
  if (!entry.valid()) throw_cannot_write(path);
  if (rows > 0 && H5Dwrite(entry.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) throw_cannot_write(path);
  write_unit(entry.id(), unit, path);
}

template <class T>
hsize_t row_count(const Hdf5Table<T>& table) {
  return table.values.size() / static_cast<std::size_t>(table.components);
}

template <class T>
Hdf5Table<T> read_table(hid_t file, const fs::path& path, const std::string& name, H5T_class_t kind, hid_t type) {
  const OwnedId entry(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!entry.valid()) throw_damaged(path, name);
  const OwnedId stored(H5Dget_type(entry.id()), H5Tclose);
  const OwnedId space(H5Dget_space(entry.id()), H5Sclose);
  if (H5Tget_class(stored.id()) != kind || H5Sget_simple_extent_ndims(space.id()) != 2) throw_damaged(path, name);
  std::array<hsize_t, 2> extents{};
  H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
  Hdf5Table<T> table{static_cast<int>(extents[1]), read_unit(entry.id()), std::vector<T>(extents[0] * extents[1])};
  if (!table.values.empty() && H5Dread(entry.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()) < 0)
    throw_damaged(path, name);
  return table;
}

}  // namespace

Hdf5File Hdf5File::create(const fs::path& path, const std::string& format) {
  tame_hdf5();
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (id < 0) throw_cannot_write(path);
  Hdf5File file(path, id);
  file.write(format_entry, format);
  return file;
}

Hdf5File Hdf5File::open(const fs::path& path, const std::string& format) {
  tame_hdf5();
  if (std::error_code ignored; !fs::exists(path, ignored))
    throw InputError(fmt::format("there is no file '{}'", path.string()));
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) throw InputError(fmt::format("'{}' is not an HDF5 file, or not a whole one", path.string()));
  Hdf5File file(path, id);
  const bool named = H5Lexists(id, format_entry, H5P_DEFAULT) > 0;
  const std::string found = named ? file.read_text_entry(format_entry) : "";
  if (found != format)
    throw InputError(fmt::format("'{}' holds {}, where '{}' is needed", path.string(),
                                 named ? "'" + found + "'" : "something that is not anvil's", format));
  return file;
}

bool Hdf5File::is_format(const fs::path& path, const std::string& format) {
  try {
    open(path, format);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept : path_(std::move(other.path_)), id_(std::exchange(other.id_, -1)) {}

Hdf5File::~Hdf5File() {
  if (id_ >= 0) H5Fclose(id_);
}

void Hdf5File::close() {
  if (H5Fclose(std::exchange(id_, -1)) < 0) throw_cannot_write(path_);
}

void Hdf5File::write(const std::string& name, const Hdf5Table<double>& table) {
  write_entry(id_, path_, name, H5T_NATIVE_DOUBLE, row_count(table), static_cast<hsize_t>(table.components),
              table.values.data(), table.unit);
}

void Hdf5File::write(const std::string& name, const Hdf5Table<std::int64_t>& table) {
  write_entry(id_, path_, name, H5T_NATIVE_INT64, row_count(table), static_cast<hsize_t>(table.components),
              table.values.data(), table.unit);
}

void Hdf5File::write(const std::string& name, const std::string& text) {
  const OwnedId type = string_type(text.size() + 1);
  write_entry(id_, path_, name, type.id(), 1, 1, text.c_str(), "");
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
  std::vector<std::string> names;
  if (H5Lexists(id_, group.c_str(), H5P_DEFAULT) <= 0) return names;
  const OwnedId opened(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose);
  const auto collect = [](hid_t top, const char* name, const H5L_info_t*, void* list) -> herr_t {
    const OwnedId entry(H5Oopen(top, name, H5P_DEFAULT), H5Oclose);
    if (H5Iget_type(entry.id()) == H5I_DATASET) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return entry.valid() ? 0 : -1;
  };
  if (!opened.valid() || H5Lvisit(opened.id(), H5_INDEX_NAME, H5_ITER_INC, collect, &names) < 0)
    throw_damaged(path_, group);
  return names;
}

bool Hdf5File::holds_integers(const std::string& name) const {
  const OwnedId entry(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!entry.valid()) throw_damaged(path_, name);
  const OwnedId type(H5Dget_type(entry.id()), H5Tclose);
  return H5Tget_class(type.id()) == H5T_INTEGER;
}

Hdf5Table<double> Hdf5File::read_doubles(const std::string& name) const {
  return read_table<double>(id_, path_, name, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

Hdf5Table<std::int64_t> Hdf5File::read_integers(const std::string& name) const {
  return read_table<std::int64_t>(id_, path_, name, H5T_INTEGER, H5T_NATIVE_INT64);
}

std::string Hdf5File::read_text_entry(const std::string& name) const {
  const OwnedId entry(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!entry.valid()) throw_damaged(path_, name);
  const OwnedId type(H5Dget_type(entry.id()), H5Tclose);
  const OwnedId space(H5Dget_space(entry.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0 ||
      H5Sget_simple_extent_npoints(space.id()) != 1)
    throw_damaged(path_, name);
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Dread(entry.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) throw_damaged(path_, name);
  return text.c_str();  // cuts at the terminating zero
}

double Hdf5File::read_double(const std::string& name) const {
  const auto table = read_doubles(name);
  if (table.values.size() != 1) throw_damaged(path_, name);
  return table.values.front();
}

std::int64_t Hdf5File::read_integer(const std::string& name) const {
  const auto table = read_integers(name);
  if (table.values.size() != 1) throw_damaged(path_, name);
  return table.values.front();
}

}  // namespace anvil
