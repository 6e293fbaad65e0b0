// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>
#include <vtkXMLWriter.h>

#include <filesystem>
#include <string>

namespace anvil {

/// Writes what a writer has been given. `compression`: lz4, zlib or none. The file appears under its name only when it
/// is complete. Throws MissingResourceError with the path and the reason.
void write_xml_file(vtkXMLWriter& writer, const std::string& compression, const std::filesystem::path& file);

/// The same with a writer of the kind that `content` needs.
template <class Writer>
void write_xml(vtkDataObject& content, const std::string& compression, const std::filesystem::path& file) {
  vtkNew<Writer> writer;
  writer->SetInputDataObject(&content);
  write_xml_file(*writer, compression, file);
}

}  // namespace anvil
