// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/render.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/measures/whole.hpp"
#include "anvil/output/atomic_file.hpp"
#include "command_line.hpp"
#include "frames.hpp"
#include "movie.hpp"
#include "option_values.hpp"
#include "progress.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

std::string color_map_help() {
  std::string help = "colours:";
  for (const auto& map : color_map_names()) help += fmt::format(" {} ({}),", map.name, map.summary);
  help.pop_back();
  return help;
}

Usage make_usage() {
  Usage usage{"anvil render RESULT [-o FILE] [options]",
              "Draws a frame of a result off-screen, or all of them with --series or into a film. RESULT is the folder "
              "of\na result, its .pvd, or a single frame (.vtp, .vtu, .vtk, .h5), of anvil or of another program.\n"
              "FILE ends in .png or .mp4.",
              "RESULT"};
  auto add = usage.options.add_options();
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  add("output,o", text("FILE"), "file to write (default: <result>.png); .mp4 makes a film of all frames");
  add("view", text("VIEW"), "rod (3D, the default there), particles (the default in 2D), section");
  add("field", text("NAME"),
      "what gives the colours: an array, velocity.z, stress.xy, von_mises, body, or an expression (default: "
      "plastic_strain)");
  static const std::string colors = color_map_help();
  add("colors", text("MAP"), colors.c_str());
  add("range", text("LOW:HIGH"), "ends of the colour bar, in SI units (default: from all frames that are drawn)");
  add("series", po::bool_switch(), "a picture of every frame: <FILE>_NNNNNN.png");
  add("every", po::value<int>()->default_value(1)->value_name("N"), "only every Nth frame of the series");
  add("fps", po::value<double>()->default_value(12.0)->value_name("F"), "frames per second of a film");
  add("surface", po::bool_switch(), "a smooth surface instead of particles (view rod)");
  add("no-cut", po::bool_switch(), "no second view with a quarter cut away (view rod)");
  add("no-outline", po::bool_switch(), "no outline of the bodies as they were");
  add("no-mirror", po::bool_switch(), "no images beyond the symmetry planes of the scene");
  add("mirror", po::value<std::vector<std::string>>()->value_name("PLANE"),
      "a plane beyond which the image is drawn, as x=0; can be repeated");
  add("section", text("PLANE"), "plane of the view section, as z=0.01, or x,y,z:nx,ny,nz");
  add("radius", po::value<double>()->value_name("R"), "radius of a particle in spacings");
  add("direction", text("X,Y,Z"), "from the bodies to the viewer (default: 0.5,-1,0.4)");
  add("title", text("TEXT"), "first line of the picture");
  add("size", text("WIDTHxHEIGHT"), "pixels (default: 1600x1200)");
  add("quiet", po::bool_switch(), "no progress");
  add_frame_options(usage);
  return usage;
}

std::optional<View> view_from(const po::variables_map& values) {
  if (values.count("view") == 0) return values.count("section") != 0 ? std::optional(View::section) : std::nullopt;
  const auto& name = values["view"].as<std::string>();
  if (name == "rod") return View::rod;
  if (name == "particles") return View::particles;
  if (name == "section") return View::section;
  throw InputError(fmt::format("there is no view '{}': expected rod, particles or section", name));
}

RenderOptions options_from(const po::variables_map& values) {
  RenderOptions options;
  const auto text = [&](const char* name) { return values.count(name) != 0 ? values[name].as<std::string>() : ""; };
  options.view = view_from(values);
  options.field = text("field");
  options.color_map = text("colors");
  options.title = text("title");
  if (values.count("size") != 0) {
    const auto size = numbers_of("size", text("size"), 'x', 2);
    options.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
  }
  if (values.count("range") != 0) {
    const auto range = numbers_of("range", text("range"), ':', 2);
    options.range = FieldRange{range[0], range[1]};
  }
  if (values.count("section") != 0) options.section = plane_of("section", text("section"));
  if (values.count("direction") != 0) options.view_direction = point_of("direction", text("direction"));
  if (values.count("radius") != 0) options.glyph_radius = values["radius"].as<double>();
  options.surface = values["surface"].as<bool>();
  options.cut = !values["no-cut"].as<bool>();
  options.outline = !values["no-outline"].as<bool>();
  return options;
}

Plane plane_from(const Parameters& boundary) {
  const auto padded = [](std::vector<double> vector) {
    vector.resize(3, 0.0);
    return std::array<double, 3>{vector[0], vector[1], vector[2]};
  };
  return {padded(boundary.numbers("point")), padded(boundary.numbers("normal"))};
}

/// What the scene of a result says about a picture of it.
struct Surroundings {
  std::vector<Plane> walls, mirrors;
  std::vector<std::string> body_names;
  std::optional<int> first_wall;
  bool on_faces = false;
};

Surroundings surroundings_of(const fs::path& result) {
  Surroundings surroundings;
  const auto scene = recorded_scene(result);
  if (!scene) return surroundings;
  for (const auto& boundary : scene->boundaries) {
    if (boundary.entry.type == "rigid_wall") surroundings.walls.push_back(plane_from(boundary.entry.parameters));
    if (boundary.entry.type == "symmetry_plane") surroundings.mirrors.push_back(plane_from(boundary.entry.parameters));
  }
  for (const auto& body : scene->bodies) {
    surroundings.body_names.push_back(body.name);
    if (body.lattice == "face_lattice") surroundings.on_faces = true;
  }
  surroundings.first_wall = static_cast<int>(scene->bodies.size());
  return surroundings;
}

/// Reads frames as they are drawn: renamed and completed beyond the symmetry planes.
class DrawnFrames {
 public:
  DrawnFrames(const po::variables_map& values, const std::vector<Plane>& mirrors)
      : names_(array_names_from(values)), mirrors_(planes_to_the_whole(mirrors)) {
    if (values["no-mirror"].as<bool>()) mirrors_.clear();
    for (const auto& text : repeated(values, "mirror")) mirrors_.push_back(plane_of("mirror", text));
  }

  [[nodiscard]] Frame read(const SeriesEntry& entry) const {
    Frame frame = read_entry(entry, names_);
    for (const Plane& mirror : mirrors_) frame = with_mirror_image(frame, mirror);
    return frame;
  }

 private:
  ArrayNames names_;
  std::vector<Plane> mirrors_;
};

/// Every frame with the same colours and the same camera. All are read twice, one at a time: memory holds one.
void draw_series(const std::vector<SeriesEntry>& series, const DrawnFrames& frames, RenderOptions options,
                 const PictureSeries& pictures, bool quiet) {
  PieceProgress progress("frame", 2 * series.size(), quiet);
  std::size_t done = 0;
  SeriesExtent extent;
  for (const auto& entry : series) {
    include_frame(extent, frames.read(entry), options);
    progress.show(++done);
  }
  options.series = extent;
  for (std::size_t i = 0; i < series.size(); ++i) {
    render_frame(frames.read(series[i]), options, pictures.picture(i));
    progress.show(++done);
  }
}

std::vector<SeriesEntry> every(std::vector<SeriesEntry> series, int n) {
  if (n < 1) throw InputError(fmt::format("--every must be 1 or more, found {}", n));
  std::vector<SeriesEntry> some;
  for (std::size_t i = 0; i < series.size(); i += static_cast<std::size_t>(n)) some.push_back(series[i]);
  return some;
}

/// A film, or its pictures where there is no ffmpeg to join them.
fs::path draw_film(const std::vector<SeriesEntry>& series, const DrawnFrames& frames, const RenderOptions& options,
                   const fs::path& film, const po::variables_map& values) {
  const PictureSeries pictures{fs::path(film).replace_extension("").string() + "_frames", film.stem().string()};
  const bool joined = has_ffmpeg();
  ensure_folder(pictures.folder);
  draw_series(series, frames, options, pictures, values["quiet"].as<bool>());
  if (!joined) {
    spdlog::warn("ffmpeg is not installed: the film '{}' stays a series of pictures", film.string());
    return pictures.picture(0);
  }
  make_film(pictures, values["fps"].as<double>(), film);
  for (std::size_t i = 0; i < series.size(); ++i) remove_file(pictures.picture(i));
  std::error_code ignored;
  fs::remove(pictures.folder, ignored);  // stays when something else lies in it
  return film;
}

}  // namespace

int execute_render(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const fs::path result = required(*values, usage, "RESULT");
  RenderOptions options = options_from(*values);
  const auto series = list_frames(result);
  const Surroundings surroundings = surroundings_of(result);
  options.walls = surroundings.walls;
  options.body_names = surroundings.body_names;
  options.first_wall = surroundings.first_wall;
  options.on_faces = surroundings.on_faces;
  const DrawnFrames frames(*values, surroundings.mirrors);
  const fs::path target = values->count("output") != 0 ? fs::path((*values)["output"].as<std::string>())
                                                       : fs::path(bare_name(result).string() + ".png");
  if (target.extension() != ".png" && target.extension() != ".mp4")
    throw InputError(fmt::format("'{}' is neither .png nor .mp4", target.string()));
  const bool whole_series = (*values)["series"].as<bool>() || target.extension() == ".mp4";
  if (whole_series && values->count("frame") + values->count("time") != 0)
    throw InputError("--frame and --time choose one frame: they do not go with --series or a film");
  if (!whole_series) {
    render_frame(frames.read(chosen_frame(series, *values)), options, target);
    fmt::print("{}\n", target.string());
    return 0;
  }
  const auto drawn = every(series, (*values)["every"].as<int>());
  if (target.extension() == ".mp4") {
    fmt::print("{}\n", draw_film(drawn, frames, options, target, *values).string());
    return 0;
  }
  const PictureSeries pictures{target.parent_path(), target.stem().string()};
  draw_series(drawn, frames, options, pictures, (*values)["quiet"].as<bool>());
  fmt::print("{} to {}\n", pictures.picture(0).string(), pictures.picture(drawn.size() - 1).string());
  return 0;
}

}  // namespace anvil
