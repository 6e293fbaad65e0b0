// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/particle_reader.hpp"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <charconv>
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
  return make_frame(*reader->GetOutput(), file.string());
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

Frame read_frame(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError("there is no particle file '" + file.string() + "'");
  if (file.extension() != ".vtp" && file.extension() != ".vtu")
    throw InputError("'" + file.string() + "' is no particle file: expected a name ending in .vtp or .vtu");
  // VTK reads a file that lacks its end without complaint when the missing part lies behind the last array it wants.
  if (!is_complete_vtk_file(file))
    throw InputError("the particle file '" + file.string() + "' is truncated or not a VTK XML file");
  return file.extension() == ".vtp" ? read_with<vtkXMLPolyDataReader>(file)
                                    : read_with<vtkXMLUnstructuredGridReader>(file);
}

std::vector<SeriesEntry> read_series(const std::filesystem::path& result) {
  if (!std::filesystem::exists(result)) throw InputError("there is no result '" + result.string() + "'");
  const std::filesystem::path file = std::filesystem::is_directory(result) ? series_file_in(result) : result;
  if (file.extension() != ".pvd") return {{read_frame(file).time, file}};
  auto series = read_series_file(file);
  if (series.empty()) throw InputError("the series file '" + file.string() + "' lists no frames");
  return series;
}

int frame_index_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const auto underscore = stem.rfind('_');
  if (underscore == std::string::npos) return -1;
  int index = -1;
  const char* end = stem.data() + stem.size();
  const auto read = std::from_chars(stem.data() + underscore + 1, end, index);
  return read.ec == std::errc() && read.ptr == end ? index : -1;
}

}  // namespace anvil
