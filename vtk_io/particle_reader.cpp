// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/particle_reader.hpp"

#include <vtkErrorCode.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <fstream>
#include <new>
#include <string>

#include "anvil/core/error.hpp"
#include "vtk_io/frame_points.hpp"
#include "vtk_io/vtk_messages.hpp"

namespace anvil {
namespace {

template <class Reader>
Frame read_with(const std::filesystem::path& file) {
  const VtkMessages messages;
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  try {
    reader->Update();
  } catch (const std::bad_alloc&) {  // a damaged header asks for any amount of memory
    throw InputError("the particle file '" + file.string() + "' is damaged, or larger than the memory");
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError || messages.has_errors())
    throw InputError("the particle file '" + file.string() + "' is damaged: run the scene again to write it anew");
  vtkPointSet* points = vtkPointSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (points == nullptr) throw InputError("'" + file.string() + "' holds no points");
  return make_frame(*points, file.string());
}

Frame read_points(const std::filesystem::path& file) {
  const auto kind = file.extension();
  if (kind == ".vtk") return read_with<vtkGenericDataObjectReader>(file);
  if (kind != ".vtp" && kind != ".vtu")
    throw InputError("'" + file.string() + "' is no particle file: expected a name ending in .vtp, .vtu or .vtk");
  // VTK reads a file that lacks its end without complaint when the missing part lies behind the last array it wants.
  if (!is_complete_vtk_file(file))
    throw InputError("the particle file '" + file.string() + "' is truncated or not a VTK XML file");
  return kind == ".vtp" ? read_with<vtkXMLPolyDataReader>(file) : read_with<vtkXMLUnstructuredGridReader>(file);
}

std::filesystem::path series_file_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".pvd") found.push_back(entry.path());
  if (found.empty()) throw InputError("the folder '" + folder.string() + "' holds no series file (.pvd)");
  if (found.size() > 1)
    throw InputError("the folder '" + folder.string() +
                     "' holds several series files: name one of them, for example '" +
                     std::min(found[0], found[1]).string() + "'");
  return found.front();
}

}  // namespace

bool is_complete_vtk_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(stream.tellg());
  if (!stream) return false;
  std::string ending(static_cast<std::size_t>(std::min<std::streamoff>(size, 64)), ' ');
  stream.seekg(size - static_cast<std::streamoff>(ending.size()));
  stream.read(ending.data(), static_cast<std::streamsize>(ending.size()));
  return ending.find("</VTKFile>") != std::string::npos;
}

Frame read_frame(const std::filesystem::path& file, const ArrayNames& names) {
  if (!std::filesystem::is_regular_file(file)) throw InputError("there is no particle file '" + file.string() + "'");
  Frame frame = read_points(file);
  rename_arrays(frame, names);
  return frame;
}

std::vector<SeriesEntry> read_series(const std::filesystem::path& result) {
  if (!std::filesystem::exists(result)) throw InputError("there is no result '" + result.string() + "'");
  const std::filesystem::path file = std::filesystem::is_directory(result) ? series_file_in(result) : result;
  if (file.extension() != ".pvd") return {{read_frame(file).time, file}};
  auto series = read_series_file(file);
  if (series.empty()) throw InputError("the series file '" + file.string() + "' lists no frames");
  return series;
}

}  // namespace anvil
