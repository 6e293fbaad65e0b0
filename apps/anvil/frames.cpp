// SPDX-License-Identifier: BSD-3-Clause
#include "frames.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include "anvil/core/error.hpp"
#include "anvil/figures/figure_builder.hpp"
#include "anvil/output/hdf5_series.hpp"
#include "anvil/output/result_folder.hpp"
#include "anvil/scene/reader.hpp"

#if ANVIL_WITH_VTK
#include "vtk_io/particle_reader.hpp"
#include "vtk_io/particle_series.hpp"
#endif

namespace anvil {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

const SeriesEntry& entry_at(const std::vector<SeriesEntry>& series, double time) {
  std::vector<double> times;
  for (const auto& entry : series) times.push_back(entry.time);
  return series[frame_at(times, time, series.front().file.string())];
}

std::vector<SeriesEntry> hdf5_frames_in(const fs::path& folder) {
  std::vector<SeriesEntry> series;
  for (const auto& [number, file] : numbered_frames(ResultFolder{folder}.frames()))
    if (file.extension() == ".h5") series.push_back({read_hdf5_time(file), file});
  return series;
}

}  // namespace

std::unique_ptr<FrameWriter> make_frame_writer(const Scene& scene, const fs::path& folder, int first_index) {
  if (scene.output.format == "hdf5") return std::make_unique<Hdf5Series>(folder, scene.name, first_index);
#if ANVIL_WITH_VTK
  return std::make_unique<ParticleSeriesWriter>(folder, scene.name, series_format(scene.output), first_index);
#else
  spdlog::warn("this build has no VTK: frames are written as HDF5 instead of {}", scene.output.format);
  return std::make_unique<Hdf5Series>(folder, scene.name, first_index);
#endif
}

Frame read_any_frame(const fs::path& file, const ArrayNames& names) {
  if (file.extension() == ".h5") {
    Frame frame = read_hdf5_frame(file);
    rename_arrays(frame, names);
    return frame;
  }
#if ANVIL_WITH_VTK
  return read_frame(file, names);
#else
  throw InputError(fmt::format("'{}' needs a build with VTK", file.string()));
#endif
}

std::vector<SeriesEntry> list_frames(const fs::path& result) {
  if (std::error_code ignored; !fs::exists(result, ignored))
    throw InputError(fmt::format("there is no result '{}'", result.string()));
  if (result.extension() == ".h5") return {{read_hdf5_time(result), result}};
  if (fs::is_directory(result))
    if (auto series = hdf5_frames_in(result); !series.empty()) return series;
#if ANVIL_WITH_VTK
  return read_series(result);
#else
  throw InputError(fmt::format("'{}' holds no HDF5 frames, and other formats need a build with VTK", result.string()));
#endif
}

Frame read_entry(const SeriesEntry& entry, const ArrayNames& names) {
  Frame frame = read_any_frame(entry.file, names);
  frame.time = entry.time;
  return frame;
}

std::optional<Scene> recorded_scene(const fs::path& result) {
  const fs::path folder = fs::is_directory(result) ? result : result.parent_path();
  for (const fs::path& place : {folder, folder / ".."}) {
    const ResultFolder run{place};
    if (std::error_code ignored; !fs::exists(run.provenance(), ignored)) continue;
    const Provenance provenance = read_provenance(run.provenance());
    try {
      return read_scene_text(provenance.scene_text, provenance.scene_name);
    } catch (const Error& error) {  // of another version, or its reference is not here: the frames are still good
      spdlog::warn("the scene of '{}' cannot be read, so its walls and its title are missing: {}", result.string(),
                   error.what());
      return std::nullopt;
    }
  }
  return std::nullopt;
}

fs::path bare_name(const fs::path& result) {
  const fs::path bare = result.has_filename() ? result : result.parent_path();
  return fs::is_directory(bare) ? bare : fs::path(bare).replace_extension();
}

void add_frame_options(Usage& usage) {
  auto add = usage.options.add_options();
  add("frame", po::value<int>()->value_name("N"), "number of the frame (default: the last one)");
  add("time", po::value<double>()->value_name("T"), "the frame at this time in s");
  add("array", po::value<std::vector<std::string>>()->value_name("ANVIL=FILE"),
      "the array of another program's file that stands for one of Anvil's, as velocity=Vel; can be repeated");
}

ArrayNames array_names_from(const po::variables_map& values) { return parse_array_names(repeated(values, "array")); }

SeriesEntry chosen_frame(const std::vector<SeriesEntry>& series, const po::variables_map& values) {
  if (values.count("time") != 0 && values.count("frame") != 0)
    throw InputError("--time and --frame both name the frame: give one of them");
  if (values.count("time") != 0) return entry_at(series, values["time"].as<double>());
  if (values.count("frame") == 0) return series.back();
  const auto wanted = static_cast<std::int64_t>(values["frame"].as<int>());
  std::vector<std::int64_t> numbers;
  for (std::size_t i = 0; i < series.size(); ++i) {
    numbers.push_back(frame_number(series[i].file).value_or(static_cast<std::int64_t>(i)));
    if (numbers.back() == wanted) return series[i];
  }
  throw InputError(fmt::format("there is no frame {}: there are {} to {}", wanted, numbers.front(), numbers.back()));
}

}  // namespace anvil
