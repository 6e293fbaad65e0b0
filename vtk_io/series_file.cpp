// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/series_file.hpp"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <array>
#include <charconv>
#include <cstring>
#include <sstream>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "vtk_io/vtk_messages.hpp"

namespace anvil {
namespace {

/// The shortest text that reads back as the same double.
std::string exact_text(double number) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), end.ptr};
}

SeriesEntry make_entry(vtkXMLDataElement& element, const std::filesystem::path& pvd) {
  const char* time = element.GetAttribute("timestep");
  const char* file = element.GetAttribute("file");
  SeriesEntry entry;
  const char* end = time == nullptr ? nullptr : time + std::strlen(time);
  if (time == nullptr || file == nullptr || std::from_chars(time, end, entry.time).ptr != end)
    throw InputError("'" + pvd.string() + "' lists a DataSet without a valid timestep and file");
  entry.file = pvd.parent_path() / file;
  return entry;
}

}  // namespace

std::vector<SeriesEntry> read_series_file(const std::filesystem::path& pvd) {
  if (!std::filesystem::is_regular_file(pvd)) throw InputError("there is no series file '" + pvd.string() + "'");
  const VtkMessages messages;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(pvd.c_str()));
  vtkXMLDataElement* collection = root == nullptr ? nullptr : root->FindNestedElementWithName("Collection");
  if (collection == nullptr)
    throw InputError("'" + pvd.string() + "' is not a complete ParaView series file (.pvd): it may be truncated");
  std::vector<SeriesEntry> entries;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
    entries.push_back(make_entry(*collection->GetNestedElement(i), pvd));
  return entries;
}

void write_series_file(const std::filesystem::path& pvd, const std::vector<SeriesEntry>& entries) {
  vtkNew<vtkXMLDataElement> root;
  root->SetName("VTKFile");
  root->SetAttribute("type", "Collection");
  root->SetAttribute("version", "1.0");
  root->SetAttribute("byte_order", "LittleEndian");
  vtkNew<vtkXMLDataElement> collection;
  collection->SetName("Collection");
  root->AddNestedElement(collection);
  for (const SeriesEntry& entry : entries) {
    vtkNew<vtkXMLDataElement> element;
    element->SetName("DataSet");
    element->SetAttribute("timestep", exact_text(entry.time).c_str());
    element->SetAttribute("file", entry.file.lexically_relative(pvd.parent_path()).generic_string().c_str());
    collection->AddNestedElement(element);
  }
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n";
  vtkIndent indent;
  vtkXMLUtilities::FlattenElement(root, text, &indent);
  write_text_atomically(pvd, text.str());
}

}  // namespace anvil
