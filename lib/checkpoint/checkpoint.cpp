// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/checkpoint/checkpoint.hpp"

#include <utility>

#include "anvil/output/atomic_file.hpp"
#include "anvil/output/hdf5_file.hpp"

namespace anvil {
namespace {

constexpr const char* format = "anvil checkpoint 1";

StateArray read_state_array(const Hdf5File& file, const std::string& name) {
  if (file.holds_integers(name)) {
    auto table = file.read_integers(name);
    return {table.components, std::move(table.values)};
  }
  auto table = file.read_doubles(name);
  return {table.components, std::move(table.values)};
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    Hdf5File file = Hdf5File::create(temporary, format);
    file.write("scene_name", checkpoint.scene_name);
    file.write("scene_text", checkpoint.scene_text);
    file.write("version", checkpoint.version);
    file.write("commit", checkpoint.commit);
    file.write_number("time", checkpoint.time);
    file.write_number("step", checkpoint.step);
    file.write_number("next_frame", std::int64_t{checkpoint.next_frame});
    file.write_number("history_rows", checkpoint.history_rows);
    for (const auto& [name, array] : checkpoint.state) {
      const auto write = [&, &name = name, &array = array](const auto& values) {
        using Number = typename std::decay_t<decltype(values)>::value_type;
        file.write("state/" + name, Hdf5Table<Number>{array.components, "", values});
      };
      std::visit(write, array.values);
    }
    file.close();
  });
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path, format);
  Checkpoint checkpoint;
  checkpoint.scene_name = file.read_text_entry("scene_name");
  checkpoint.scene_text = file.read_text_entry("scene_text");
  checkpoint.version = file.read_text_entry("version");
  checkpoint.commit = file.read_text_entry("commit");
  checkpoint.time = file.read_double("time");
  checkpoint.step = file.read_integer("step");
  checkpoint.next_frame = static_cast<int>(file.read_integer("next_frame"));
  checkpoint.history_rows = file.read_integer("history_rows");
  for (const auto& name : file.names("state")) checkpoint.state[name] = read_state_array(file, "state/" + name);
  return checkpoint;
}

bool is_checkpoint(const std::filesystem::path& path) { return Hdf5File::is_format(path, format); }

}  // namespace anvil
