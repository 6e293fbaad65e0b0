// SPDX-License-Identifier: BSD-3-Clause
#include "frames.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include "anvil/core/error.hpp"
#include "anvil/output/hdf5_series.hpp"

#if ANVIL_WITH_VTK
#include "vtk_io/particle_reader.hpp"
#include "vtk_io/particle_series.hpp"
#endif

namespace anvil {

std::unique_ptr<FrameWriter> make_frame_writer(const Scene& scene, const std::filesystem::path& folder,
                                               int first_index) {
  if (scene.output.format == "hdf5") return std::make_unique<Hdf5Series>(folder, scene.name, first_index);
#if ANVIL_WITH_VTK
  return std::make_unique<ParticleSeriesWriter>(folder, scene.name, series_format(scene.output), first_index);
#else
  spdlog::warn("this build has no VTK: frames are written as HDF5 instead of {}", scene.output.format);
  return std::make_unique<Hdf5Series>(folder, scene.name, first_index);
#endif
}

Frame read_any_frame(const std::filesystem::path& file) {
  if (file.extension() == ".h5") return read_hdf5_frame(file);
#if ANVIL_WITH_VTK
  return read_frame(file);
#else
  throw InputError(fmt::format("'{}' needs a build with VTK", file.string()));
#endif
}

}  // namespace anvil
