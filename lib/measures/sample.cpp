// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "anvil/core/error.hpp"
#include "anvil/measures/frame_fields.hpp"

namespace anvil {
namespace {

constexpr std::array<const char*, 3> vector_parts = {".x", ".y", ".z"};
constexpr std::array<const char*, 6> tensor_parts = {".xx", ".yy", ".zz", ".xy", ".yz", ".xz"};

/// The arrays to sample, with the values of the particles.
std::vector<FrameArray> chosen_arrays(const Frame& frame, const std::vector<std::string>& fields) {
  std::vector<FrameArray> arrays;
  if (fields.empty()) {
    for (const FrameArray& array : frame.arrays)
      if (!array.integer) arrays.push_back(array);
    return arrays;
  }
  for (const auto& name : fields) {
    const FrameArray* whole = frame.find(name);
    if (whole != nullptr) {
      arrays.push_back(*whole);
      arrays.back().integer = false;
      continue;
    }
    Evaluated field = field_of(frame, name);
    arrays.push_back({name, field.unit, 1, false, std::move(field.values)});
  }
  return arrays;
}

/// One list of numbers per component: what interpolation takes.
std::vector<std::vector<double>> components_of(const std::vector<FrameArray>& arrays) {
  std::vector<std::vector<double>> components;
  for (const FrameArray& array : arrays) {
    const auto stride = static_cast<std::size_t>(array.components);
    for (std::size_t c = 0; c < stride; ++c) {
      auto& values = components.emplace_back();
      for (std::size_t i = c; i < array.values.size(); i += stride) values.push_back(array.values[i]);
    }
  }
  return components;
}

std::string part_name(const FrameArray& array, int c) {
  const auto i = static_cast<std::size_t>(c);
  if (array.components == 1) return array.name;
  if (array.components == 3) return array.name + vector_parts.at(i);
  return array.components == 6 ? array.name + tensor_parts.at(i) : fmt::format("{}.{}", array.name, c);
}

}  // namespace

Frame sample_frame(const Frame& frame, const SampleGrid& grid, const std::vector<std::string>& fields,
                   const InterpolationOptions& options) {
  Frame sampled = frame;
  sampled.positions = points_of(grid);
  sampled.arrays = chosen_arrays(frame, fields);
  const ParticleInterpolation interpolation(frame, options);
  auto found = interpolation.at(sampled.positions, components_of(sampled.arrays));
  const auto is_inside = [&](double filling) { return filling > 0.0 && filling >= options.least_filling; };
  if (std::none_of(found.filling.begin(), found.filling.end(), is_inside))
    throw InputError("none of the points lies in a body: particles are not near enough");
  std::size_t next = 0;
  for (FrameArray& array : sampled.arrays) {
    const auto stride = static_cast<std::size_t>(array.components);
    array.values.resize(stride * grid.count());
    for (std::size_t c = 0; c < stride; ++c, ++next)
      for (std::size_t i = 0; i < grid.count(); ++i) array.values[i * stride + c] = found.values[next][i];
  }
  sampled.arrays.push_back({"filling", "", 1, false, std::move(found.filling)});
  return sampled;
}

std::string sample_csv(const Frame& sampled, const SampleGrid& grid) {
  std::string text = fmt::format("# {}, t = {} s\n", sampled.scene.empty() ? "sample" : sampled.scene, sampled.time);
  text += grid.is_line() ? "distance [m],x [m],y [m],z [m]" : "x [m],y [m],z [m]";
  for (const FrameArray& array : sampled.arrays)
    for (int c = 0; c < array.components; ++c)
      text += "," + part_name(array, c) + (array.unit.empty() ? "" : " [" + array.unit + "]");
  text += '\n';
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < sampled.particle_count(); ++i) {
    if (grid.is_line()) fmt::format_to(out, "{},", static_cast<double>(i) * grid.step[0]);
    const double* x = &sampled.positions[3 * i];
    fmt::format_to(out, "{},{},{}", x[0], x[1], x[2]);
    for (const FrameArray& array : sampled.arrays) {
      const auto stride = static_cast<std::size_t>(array.components);
      for (std::size_t c = 0; c < stride; ++c) fmt::format_to(out, ",{}", array.values[i * stride + c]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace anvil
