// SPDX-License-Identifier: BSD-3-Clause
// benchmark_series FOLDER [PARTICLES]: writes one frame of a deformed rod in every format and reads it back; prints
// time, processor time and size, and leaves FOLDER/lz4_float32 behind for anvil render and ParaView.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
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

struct Cost {
  double wall, cpu;  // s
};

template <class Work>
Cost cost_of(Work&& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const std::clock_t cpu = std::clock();
  work();
  return {std::chrono::duration<double>(Clock::now() - begin).count(),
          static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC};
}

/// The least of five, which is what an idle machine takes.
template <class Work>
Cost least_cost(Work&& work) {
  Cost least = cost_of(work);
  for (int i = 0; i < 4; ++i) {
    const Cost cost = cost_of(work);
    least = {std::min(least.wall, cost.wall), std::min(least.cpu, cost.cpu)};
  }
  return least;
}

void measure(const anvil::Frame& frame, const fs::path& folder, const anvil::SeriesFormat& format) {
  const fs::path target = folder / (format.compression + "_" + format.precision);
  fs::create_directories(target);
  const Cost write = least_cost([&] { anvil::ParticleSeriesWriter(target, "mushroom", format).write(frame); });
  const fs::path file = anvil::read_series(target).front().file;
  const Cost read = least_cost([&] { anvil::read_frame(file); });
  fmt::print("{:>8} {:>5} {:>10} {:8.3f} {:8.3f} {:8.3f} {:8.3f} {:8.1f}\n", format.format, format.compression,
             format.precision, write.wall, write.cpu, read.wall, read.cpu,
             static_cast<double>(fs::file_size(file)) / 1e6);
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
    fmt::print("{} particles, {} arrays\n  format  pack  precision write s    CPU s   read s    CPU s       MB\n",
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
