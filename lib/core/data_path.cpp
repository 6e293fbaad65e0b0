// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/core/data_path.hpp"

#include <cstdlib>
#include <set>

#include "anvil/core/error.hpp"

namespace anvil {

namespace fs = std::filesystem;

namespace {

fs::path program_folder() {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  return failure ? fs::path() : program.parent_path();
}

std::string joined(const std::vector<fs::path>& folders) {
  std::string text;
  for (const auto& folder : folders) text += (text.empty() ? "" : ", ") + folder.string();
  return text;
}

}  // namespace

std::vector<fs::path> bundled_roots() {
  std::vector<fs::path> roots;
  std::error_code failure;  // an unreadable folder counts as missing
  if (const char* chosen = std::getenv("ANVIL_DATA"); chosen != nullptr && fs::is_directory(chosen, failure))
    roots.emplace_back(chosen);
  const fs::path beside_program = (program_folder() / "../share/anvil").lexically_normal();
  if (fs::is_directory(beside_program, failure)) roots.push_back(beside_program);
  return roots;
}

fs::path find_bundled(const std::string& folder, const std::string& name) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..")
    throw InputError("'" + name + "' is not a name in the bundled folder '" + folder + "'");
  const auto roots = bundled_roots();
  if (roots.empty())
    throw MissingResourceError(
        "the files that come with Anvil were not found; set the environment variable ANVIL_DATA to the folder that "
        "holds "
        "scenes, materials and reference");
  std::error_code failure;
  for (const auto& root : roots)
    if (const fs::path path = root / folder / relative; fs::is_regular_file(path, failure)) return path;
  throw InputError("there is no file '" + name + "' in '" + folder + "' of " + joined(roots));
}

std::vector<std::string> list_bundled(const std::string& folder, const std::string& extension) {
  std::set<std::string> names;
  for (const auto& root : bundled_roots()) {
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(root / folder, failure))
      if (entry.is_regular_file(failure) && entry.path().extension() == extension)
        names.insert(entry.path().filename().string());
  }
  return {names.begin(), names.end()};
}

}  // namespace anvil
