// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include <fmt/core.h>

#include <sstream>

#include "anvil/core/error.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

namespace po = boost::program_options;

std::vector<std::string> option_names(const Usage& usage) {
  std::vector<std::string> names;
  for (const auto& option : usage.options.options()) names.push_back("--" + option->long_name());
  return names;
}

void print_help(const Usage& usage) {
  std::ostringstream options;
  options << usage.options;
  fmt::print("Usage: {}\n\n{}\n\n{}", usage.synopsis, usage.paragraph, options.str());
}

}  // namespace

std::optional<po::variables_map> parse(Usage& usage, const Arguments& arguments) {
  usage.options.add_options()("help,h", "show this help");
  po::options_description all;
  all.add(usage.options);
  po::positional_options_description positional;
  if (!usage.positional.empty()) {
    all.add_options()(usage.positional.c_str(), po::value<std::string>());
    positional.add(usage.positional.c_str(), 1);
  }
  po::variables_map values;
  try {
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(all).positional(positional).style(style).run(), values);
    po::notify(values);
  } catch (const po::unknown_option& error) {
    const auto names = option_names(usage);
    throw InputError(fmt::format("unknown option '{}'{}", error.get_option_name(),
                                 suggestion(error.get_option_name(), views_of(names))));
  } catch (const po::too_many_positional_options_error&) {
    throw InputError(fmt::format("too many arguments; usage: {}", usage.synopsis));
  } catch (const po::error& error) {
    throw InputError(error.what());
  }
  if (values.count("help") == 0) return values;
  print_help(usage);
  return std::nullopt;
}

std::string required(const po::variables_map& values, const Usage& usage, const std::string& name) {
  if (values.count(name) == 0) throw InputError(fmt::format("{} is missing; usage: {}", name, usage.synopsis));
  return values[name].as<std::string>();
}

std::vector<std::string> repeated(const po::variables_map& values, const std::string& name) {
  return values.count(name) == 0 ? std::vector<std::string>{} : values[name].as<std::vector<std::string>>();
}

void add_scene_options(Usage& usage) {
  usage.options.add_options()("set", po::value<std::vector<std::string>>()->value_name("KEY=VALUE"),
                              "override a key of the scene, for example time.end=40e-6 or "
                              "body.rod.velocity=[0,0,-300]; can be repeated");
}

}  // namespace anvil
