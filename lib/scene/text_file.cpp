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
  constexpr std::size_t piece = std::size_t{1} << 16;
  std::string text;
  while (stream &&
         text.size() <= largest) {  // piece by piece: clearing room for the largest would take longer than a run
    const std::size_t size = text.size();
    text.resize(size + piece);
    stream.read(text.data() + size, static_cast<std::streamsize>(piece));
    text.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(name + ": the file cannot be read");
  if (text.size() > largest) throw InputError(name + ": the file is larger than 16 MiB, which no scene is");
  if (text.find('\0') != std::string::npos) throw InputError(name + ": this is a binary file, not a scene");
  return text;
}

}  // namespace anvil
