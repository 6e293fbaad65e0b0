// SPDX-License-Identifier: BSD-3-Clause
// write_mushroom FOLDER ACROSS FRAMES [FORMAT PRECISION COMPRESSION]
// writes a series of a deforming rod and, beside each frame, FOLDER/<index>.csv with the numbers that went into it: one
// column per component, all digits. For tests that read the series with programs other than Anvil.
#include <fmt/os.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "anvil/core/error.hpp"
#include "render/mushroom.hpp"
#include "vtk_io/particle_series.hpp"

namespace {

void write_numbers(anvil::Frame frame, const std::filesystem::path& csv) {
  frame.arrays.push_back({"Points", "m", 3, false, frame.positions});
  auto file = fmt::output_file(csv.string());
  for (const auto& array : frame.arrays)
    for (int c = 0; c < array.components; ++c) file.print("{}.{},", array.name, c);
  file.print("TimeValue\n");
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    for (const auto& array : frame.arrays)
      for (int c = 0; c < array.components; ++c)
        file.print("{:.17g},",
                   array.values[i * static_cast<std::size_t>(array.components) + static_cast<std::size_t>(c)]);
    file.print("{:.17g}\n", frame.time);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 && argc != 7) {
    std::fprintf(stderr, "usage: write_mushroom FOLDER ACROSS FRAMES [FORMAT PRECISION COMPRESSION]\n");
    return 1;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const int across = std::stoi(argv[2]);
    const int frames = std::stoi(argv[3]);
    anvil::SeriesFormat format;
    if (argc == 7) format = {argv[4], argv[5], argv[6]};
    anvil::ParticleSeriesWriter writer(folder, "mushroom", format);
    for (int i = 0; i < frames; ++i) {
      const anvil::Frame frame = anvil::test::make_mushroom(across, frames == 1 ? 1.0 : i / (frames - 1.0), i);
      writer.write(frame);
      write_numbers(frame, folder / (std::to_string(i) + ".csv"));
    }
  } catch (const anvil::Error& error) {
    std::fprintf(stderr, "write_mushroom: %s\n", error.what());
    return static_cast<int>(error.exit_code());
  }
  return 0;
}
