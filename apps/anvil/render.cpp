// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/render.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/output/result_folder.hpp"
#include "anvil/scene/reader.hpp"
#include "command_line.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

Usage make_usage() {
  Usage usage{
      "anvil render RESULT -o PNG [options]",
      "Draws a frame of a result off-screen. RESULT is the folder of a result, its .pvd, or a single .vtp or .vtu.",
      "RESULT"};
  auto add = usage.options.add_options();
  add("output,o", po::value<std::string>()->value_name("PNG"), "file to write (default: <result>.png)");
  add("field", po::value<std::string>()->value_name("NAME"),
      "what colours the particles: an array, a component such as velocity.z, or von_mises (default: plastic_strain)");
  add("frame", po::value<int>()->value_name("N"), "number of the frame (default: the last one)");
  add("range", po::value<std::string>()->value_name("LOW:HIGH"), "ends of the colour bar, in the unit of the field");
  add("surface", po::bool_switch(), "a smooth surface instead of particles");
  add("no-cut", po::bool_switch(), "no second view with a quarter cut away");
  add("no-outline", po::bool_switch(), "no outline of the bodies as they were");
  add("title", po::value<std::string>()->value_name("TEXT"), "first line of the picture");
  add("size", po::value<std::string>()->value_name("WIDTHxHEIGHT"), "pixels (default: 1600x1200)");
  return usage;
}

WallPlane wall_plane(const Parameters& wall) {
  const auto padded = [](std::vector<double> vector) {
    vector.resize(3, 0.0);
    return std::array<double, 3>{vector[0], vector[1], vector[2]};
  };
  return {padded(wall.numbers("point")), padded(wall.numbers("normal"))};
}

/// The walls of the scene, when the frames lie in the folder of their run.
std::vector<WallPlane> walls_of(const fs::path& result) {
  const ResultFolder folder{fs::is_directory(result) ? result : result.parent_path()};
  if (!fs::exists(folder.provenance())) return {};
  const Provenance run = read_provenance(folder.provenance());
  std::vector<WallPlane> walls;
  for (const auto& boundary : read_scene_text(run.scene_text, run.scene_name).boundaries)
    if (boundary.entry.type == "rigid_wall") walls.push_back(wall_plane(boundary.entry.parameters));
  return walls;
}

/// The two numbers of an option such as --size 800x600.
template <class Number>
std::array<Number, 2> pair_of(const po::variables_map& values, const std::string& option, char separator) {
  const auto& text = values[option].as<std::string>();
  std::array<Number, 2> pair{};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair[0]);
  const bool separated = first.ec == std::errc() && first.ptr != end && *first.ptr == separator;
  const auto second = separated ? std::from_chars(first.ptr + 1, end, pair[1]) : first;
  if (!separated || second.ec != std::errc() || second.ptr != end)
    throw InputError(fmt::format("--{} takes two numbers with '{}' between them, found '{}'", option, separator, text));
  return pair;
}

RenderOptions options_from(const po::variables_map& values) {
  RenderOptions options;
  if (values.count("field") != 0) options.field = values["field"].as<std::string>();
  if (values.count("frame") != 0) options.frame = values["frame"].as<int>();
  if (values.count("title") != 0) options.title = values["title"].as<std::string>();
  if (values.count("size") != 0) options.size = pair_of<int>(values, "size", 'x');
  if (values.count("range") != 0) {
    const auto [low, high] = pair_of<double>(values, "range", ':');
    options.range = FieldRange{low, high};
  }
  options.surface = values["surface"].as<bool>();
  options.cut = !values["no-cut"].as<bool>();
  options.outline = !values["no-outline"].as<bool>();
  return options;
}

/// rod.png beside the folder, the series or the frame that is drawn.
fs::path default_picture(const fs::path& result) {
  const fs::path bare = result.has_filename() ? result : result.parent_path();
  return fs::path(bare).replace_extension(".png");
}

}  // namespace

int execute_render(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const fs::path result = required(*values, usage, "RESULT");
  RenderOptions options = options_from(*values);
  options.walls = walls_of(result);
  const fs::path picture =
      values->count("output") != 0 ? fs::path((*values)["output"].as<std::string>()) : default_picture(result);
  render_result(result, options, picture);
  fmt::print("{}\n", picture.string());
  return 0;
}

}  // namespace anvil
