// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/sample.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "command_line.hpp"
#include "frames.hpp"
#include "option_values.hpp"

#if ANVIL_WITH_VTK
#include "vtk_io/sample_file.hpp"
#endif

namespace anvil {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

Usage make_usage() {
  Usage usage{"anvil sample RESULT (--line A:B | --plane PLANE) [-o FILE] [options]",
              "Values between the particles, by sums over the kernel, on a line or a plane. RESULT is the folder of a\n"
              "result, its .pvd, or a single frame, of anvil or of another program. FILE ends in .csv, .vtp or .vti.",
              "RESULT"};
  auto add = usage.options.add_options();
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  const auto texts = [](const char* name) { return po::value<std::vector<std::string>>()->value_name(name); };
  add("output,o", texts("FILE"), "file to write; can be repeated (default: <result>_sample.csv)");
  add("line", text("A:B"), "from x,y,z to x,y,z (m)");
  add("plane", text("PLANE"), "as z=0.01, or x,y,z:nx,ny,nz, a point and the normal; where it meets the bodies");
  add("points", po::value<int>()->default_value(201)->value_name("N"), "points of a line");
  add("step", po::value<double>()->value_name("D"), "distance of points in a plane, m (default: half a spacing)");
  add("field", texts("F"), "an array, a component, von_mises or an expression; can be repeated (default: all arrays)");
  add("order", po::value<int>()->default_value(0)->value_name("N"),
      "0: weighted mean, exact for constant fields; 1: exact for linear fields as well");
  add("smoothing-length", po::value<double>()->value_name("H"), "m (default: that of the particles)");
  add("least-filling", po::value<double>()->default_value(0.5)->value_name("S"),
      "where space is less full of particles than this, there is no value");
  add_frame_options(usage);
  return usage;
}

InterpolationOptions interpolation_from(const po::variables_map& values) {
  InterpolationOptions options;
  options.order = values["order"].as<int>();
  if (options.order != 0 && options.order != 1)
    throw InputError(fmt::format("--order must be 0 or 1, found {}", options.order));
  options.least_filling = values["least-filling"].as<double>();
  if (values.count("smoothing-length") != 0) options.smoothing_length = values["smoothing-length"].as<double>();
  if (options.smoothing_length < 0.0)
    throw InputError(fmt::format("--smoothing-length must be above 0, found {}", options.smoothing_length));
  return options;
}

SampleGrid grid_from(const po::variables_map& values, const Frame& frame) {
  const bool on_line = values.count("line") != 0;
  if (on_line == (values.count("plane") != 0))
    throw InputError("say where to sample: either --line A:B or --plane PLANE");
  if (on_line) {
    const auto [begin, end] = line_of("line", values["line"].as<std::string>());
    return make_sample_line(begin, end, values["points"].as<int>());
  }
  const double spacing = usual_spacing(frame.positions, frame.dimension);
  const double step = values.count("step") != 0 ? values["step"].as<double>() : 0.5 * spacing;
  return make_sample_plane(plane_of("plane", values["plane"].as<std::string>()),
                           box_around(frame.positions, frame.dimension, spacing), step);
}

void write_sample(const Frame& sampled, const SampleGrid& grid, const fs::path& file) {
  if (file.extension() == ".csv") {
    write_text_atomically(file, sample_csv(sampled, grid));
    return;
  }
#if ANVIL_WITH_VTK
  write_sample_file(sampled, grid, file);
#else
  throw InputError(fmt::format("'{}' needs a build with VTK; this one writes .csv", file.string()));
#endif
}

}  // namespace

int execute_sample(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const fs::path result = required(*values, usage, "RESULT");
  const Frame frame = read_entry(chosen_frame(list_frames(result), *values), array_names_from(*values));
  const SampleGrid grid = grid_from(*values, frame);
  const Frame sampled = sample_frame(frame, grid, repeated(*values, "field"), interpolation_from(*values));
  auto files = repeated(*values, "output");
  if (files.empty()) files = {bare_name(result).string() + "_sample.csv"};
  for (const auto& file : files) {
    write_sample(sampled, grid, file);
    fmt::print("{}\n", file);
  }
  return 0;
}

}  // namespace anvil
