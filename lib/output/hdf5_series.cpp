// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/hdf5_series.hpp"

#include <fmt/core.h>

#include <utility>

#include "anvil/output/atomic_file.hpp"
#include "anvil/output/hdf5_file.hpp"
#include "anvil/output/result_folder.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;
constexpr const char* format = "anvil frame 1";

void write_array(Hdf5File& file, const FrameArray& array) {
  const std::string name = "arrays/" + array.name;
  if (array.integer) {
    file.write(name, Hdf5Table<std::int64_t>{array.components, array.unit, {array.values.begin(), array.values.end()}});
  } else {
    file.write(name, Hdf5Table<double>{array.components, array.unit, array.values});
  }
}

FrameArray read_array(const Hdf5File& file, const std::string& name) {
  const std::string path = "arrays/" + name;
  if (!file.holds_integers(path)) {
    auto table = file.read_doubles(path);
    return {name, std::move(table.unit), table.components, false, std::move(table.values)};
  }
  const auto table = file.read_integers(path);
  return {name, table.unit, table.components, true, {table.values.begin(), table.values.end()}};
}

}  // namespace

Hdf5Series::Hdf5Series(const fs::path& folder, std::string scene, int first_index)
    : frames_(folder / "frames"), scene_(std::move(scene)) {
  ensure_folder(frames_);
  for (const auto& [number, file] : numbered_frames(frames_))
    if (number >= first_index && file.extension() == ".h5") remove_file(file);
}

void Hdf5Series::write(const Frame& frame) {
  write_atomically(frames_ / fmt::format("{}_{:06}.h5", scene_, frame.index), [&](const fs::path& temporary) {
    Hdf5File file = Hdf5File::create(temporary, format);
    file.write("scene", frame.scene);
    file.write_number("time", frame.time);
    file.write_number("step", frame.step);
    file.write_number("index", std::int64_t{frame.index});
    file.write_number("dimension", std::int64_t{frame.dimension});
    file.write("positions", Hdf5Table<double>{3, "m", frame.positions});
    for (const auto& array : frame.arrays) write_array(file, array);
    for (const auto& [name, text] : frame.provenance) file.write("provenance/" + name, text);
    file.close();
  });
}

double read_hdf5_time(const fs::path& path) { return Hdf5File::open(path, format).read_double("time"); }

Frame read_hdf5_frame(const fs::path& path) {
  const Hdf5File file = Hdf5File::open(path, format);
  Frame frame;
  frame.scene = file.read_text_entry("scene");
  frame.time = file.read_double("time");
  frame.step = file.read_integer("step");
  frame.index = static_cast<int>(file.read_integer("index"));
  frame.dimension = static_cast<int>(file.read_integer("dimension"));
  frame.positions = file.read_doubles("positions").values;
  for (const auto& name : file.names("arrays")) frame.arrays.push_back(read_array(file, name));
  for (const auto& name : file.names("provenance"))
    frame.provenance.emplace_back(name, file.read_text_entry("provenance/" + name));
  return frame;
}

}  // namespace anvil
