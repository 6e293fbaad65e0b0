// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/text_file.hpp"

#include <fstream>

#include "anvil/core/error.hpp"

namespace anvil {

std::string read_text_file(const std::filesystem::path& file) {
  std::error_code failure;
  const std::string name = file.string();
  if (!std::filesystem::exists(file, failure)) throw InputError(name + ": there is no such file");
  if (std::filesystem::is_directory(file, failure)) throw InputError(name + ": this is a folder, not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(name + ": the file cannot be opened; check its permissions");

  constexpr std::size_t largest = std::size_t{16} << 20;  // devices never end, and no scene is this long
  std::string text(largest + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(name + ": the file cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > largest) throw InputError(name + ": the file is larger than 16 MiB, which no scene is");
  if (text.find('\0') != std::string::npos) throw InputError(name + ": this is a binary file, not a scene");
  return text;
}

}  // namespace anvil
