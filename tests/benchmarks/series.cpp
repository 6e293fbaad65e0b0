// SPDX-License-Identifier: BSD-3-Clause
// benchmark_series FOLDER [PARTICLES]: writes one frame of a deformed rod in every format and reads it back; prints
// processor time and size, and leaves FOLDER/lz4_float32 behind for anvil render and ParaView.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>

#include "anvil/core/error.hpp"
#include "render/mushroom.hpp"
#include "vtk_io/particle_reader.hpp"
#include "vtk_io/particle_series.hpp"

namespace {

namespace fs = std::filesystem;

template <class Work>
double seconds_of(Work&& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// The least of three: the first one also pays for the disk's cache.
template <class Work>
double least_seconds(Work&& work) {
  double least = seconds_of(work);
  for (int i = 0; i < 2; ++i) least = std::min(least, seconds_of(work));
  return least;
}

void measure(const anvil::Frame& frame, const fs::path& folder, const anvil::SeriesFormat& format) {
  const fs::path target = folder / (format.compression + "_" + format.precision);
  fs::create_directories(target);
  const double write = least_seconds([&] { anvil::ParticleSeriesWriter(target, "mushroom", format).write(frame); });
  const fs::path file = anvil::read_series(target).front().file;
  const double read = least_seconds([&] { anvil::read_frame(file); });
  fmt::print("{:>8} {:>5} {:>10} {:8.3f} {:8.3f} {:8.1f}\n", format.format, format.compression, format.precision, write,
             read, static_cast<double>(fs::file_size(file)) / 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: benchmark_series FOLDER [PARTICLES]\n");
    return 1;
  }
  try {
    const double wanted = argc == 3 ? std::strtod(argv[2], nullptr) : 1e6;
    const anvil::Frame frame = anvil::test::make_mushroom(static_cast<int>(std::lround(std::cbrt(wanted / 5.0))));
    fmt::print("{} particles, {} arrays\n  format  pack  precision  write s   read s       MB\n",
               frame.particle_count(), frame.arrays.size());
    for (const std::string compression : {"lz4", "none", "zlib"})
      for (const std::string precision : {"float32", "float64"})
        measure(frame, argv[1], {"vtp", precision, compression});
  } catch (const anvil::Error& error) {
    fmt::print(stderr, "benchmark_series: {}\n", error.what());
    return static_cast<int>(error.exit_code());
  }
  return 0;
}
