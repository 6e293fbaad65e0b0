// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

#include "subcommands.hpp"

namespace anvil {

/// The options of a subcommand, and how its help describes it.
struct Usage {
  std::string synopsis;    // "anvil run SCENE [options]"
  std::string paragraph;   // what it does, below the synopsis
  std::string positional;  // name of the one argument without a dash, "" when it takes none
  boost::program_options::options_description options{"Options"};
};

/// Reads the arguments of a subcommand. Adds --help to its options; when that is asked for, prints the help and returns
/// nothing. Throws InputError, with the nearest option for a mistyped one.
std::optional<boost::program_options::variables_map> parse(Usage& usage, const Arguments& arguments);

/// The value of an option or argument that cannot be left out; throws InputError with the synopsis.
std::string required(const boost::program_options::variables_map& values, const Usage& usage, const std::string& name);

/// The values of an option that can be repeated, none when it is not given.
std::vector<std::string> repeated(const boost::program_options::variables_map& values, const std::string& name);

/// Adds --set, for all subcommands that read a scene.
void add_scene_options(Usage& usage);

}  // namespace anvil
