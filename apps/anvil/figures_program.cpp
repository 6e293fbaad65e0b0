// SPDX-License-Identifier: BSD-3-Clause
#include "figures_program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "anvil/core/error.hpp"

namespace anvil {

int execute_figures_program(const std::string& subcommand, const Arguments& arguments) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "anvil-figures";
  std::vector<std::string> words = {program.string(), subcommand};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw MissingResourceError(
      fmt::format("'{}' draws, but it cannot be started: {}. It belongs beside anvil: build or install both",
                  program.string(), std::generic_category().message(errno)));
}

}  // namespace anvil
