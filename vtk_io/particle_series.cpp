// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/particle_series.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <utility>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/result_folder.hpp"
#include "vtk_io/frame_points.hpp"
#include "vtk_io/particle_reader.hpp"
#include "vtk_io/xml_file.hpp"

namespace anvil {
namespace {

void check_choice(const std::string& key, const std::string& value, const std::vector<std::string>& choices) {
  for (const auto& choice : choices)
    if (value == choice) return;
  throw InputError(fmt::format("output.{} = \"{}\" is unknown: expected {}", key, value, fmt::join(choices, ", ")));
}

}  // namespace

SeriesFormat series_format(const OutputControl& output) {
  return {output.format, output.precision, output.compression};
}

ParticleSeriesWriter::ParticleSeriesWriter(std::filesystem::path folder, std::string scene, SeriesFormat format,
                                           int first_index)
    : folder_(std::move(folder)), scene_(std::move(scene)), format_(std::move(format)) {
  check_choice("format", format_.format, {"vtp", "vtu"});
  check_choice("precision", format_.precision, {"float32", "float64"});
  check_choice("compression", format_.compression, {"lz4", "zlib", "none"});
  ensure_folder(folder_ / "frames");
  keep_frames_before(first_index);
}

void ParticleSeriesWriter::write(const Frame& frame) {
  // A frame of the same or a later time would be in the series twice.
  std::erase_if(entries_,
                [&](const auto& entry) { return entry.first >= frame.index || entry.second.time >= frame.time; });
  const std::filesystem::path file = frame_path(frame.index);
  write_particles(frame, file);
  entries_[frame.index] = {frame.time, file};
  write_series();
}

std::filesystem::path ParticleSeriesWriter::series_path() const { return folder_ / (scene_ + ".pvd"); }

std::filesystem::path ParticleSeriesWriter::frame_path(int index) const {
  return folder_ / "frames" / fmt::format("{}_{:06d}.{}", scene_, index, format_.format);
}

void ParticleSeriesWriter::write_particles(const Frame& frame, const std::filesystem::path& file) const {
  const bool double_precision = format_.precision == "float64";
  if (format_.format == "vtp")
    write_xml<vtkXMLPolyDataWriter>(*make_poly_data(frame, double_precision), format_.compression, file);
  else
    write_xml<vtkXMLUnstructuredGridWriter>(*make_unstructured_grid(frame, double_precision), format_.compression,
                                            file);
}

/// The frames on disk decide, not the .pvd: a run can be killed between a frame and its entry.
void ParticleSeriesWriter::keep_frames_before(int first_index) {
  std::vector<std::filesystem::path> stale;
  for (const auto& item : std::filesystem::directory_iterator(folder_ / "frames")) {
    const std::filesystem::path& file = item.path();
    const int index = static_cast<int>(frame_number(file).value_or(-1));
    if (index < 0 || file.stem() != fmt::format("{}_{:06d}", scene_, index)) continue;
    if (file.extension() != ".vtp" && file.extension() != ".vtu") continue;
    if (index < first_index)
      entries_[index] = {read_frame(file).time, file};
    else
      stale.push_back(file);
  }
  if (entries_.empty())
    std::filesystem::remove(series_path());
  else
    write_series();
  for (const auto& file : stale) std::filesystem::remove(file);
}

void ParticleSeriesWriter::write_series() const {
  std::vector<SeriesEntry> entries;
  for (const auto& [index, entry] : entries_) entries.push_back(entry);
  write_series_file(series_path(), entries);
}

}  // namespace anvil
