// SPDX-License-Identifier: BSD-3-Clause
#include "render/mushroom.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace anvil::test {
namespace {

constexpr double width = 6.4e-3;
constexpr double length = 32e-3;
constexpr double final_length = 21.28e-3;
constexpr double foot_half_width = 8.24e-3;
constexpr double foot_plastic_strain = 3.5;
constexpr double impact_speed = 227.0;
constexpr double density = 8930.0;
constexpr double end_time = 80e-6;

using Point = std::array<double, 3>;

/// Lateral stretch at the initial height z: large at the foot, 1 at the rear end, the same volume everywhere.
double final_stretch(double z) {
  const double foot = 2.0 * foot_half_width / width - 1.0;
  return 1.0 + foot * (0.8 * std::exp(-z / 2.2e-3) + 0.2 * std::exp(-z / 9e-3));
}

/// Height of the layer that starts at z: the layers below, each compressed so that its volume stays.
double final_height(double z) {
  constexpr int intervals = 200;
  const auto integral = [](double to) {
    double sum = 0.0;
    for (int i = 0; i < intervals; ++i) sum += 1.0 / std::pow(final_stretch((i + 0.5) * to / intervals), 2);
    return sum * to / intervals;
  };
  return final_length * integral(z) / integral(length);
}

Point deformed(const Point& initial, double progress) {
  const double stretch = 1.0 + progress * (final_stretch(initial[2]) - 1.0);
  // Corners of the square spread less than the middles of its sides.
  const double x = 2.0 * initial[0] / width;
  const double y = 2.0 * initial[1] / width;
  const double rounding = 1.0 - 0.18 * (1.0 - 1.0 / stretch) * x * x * y * y;
  return {initial[0] * stretch * rounding, initial[1] * stretch * rounding,
          initial[2] + progress * (final_height(initial[2]) - initial[2])};
}

struct Particle {
  Point initial, position;
  double velocity, plastic_strain, axial_stress;
};

Particle make_particle(const Point& initial, double progress) {
  const double height = initial[2] / length;
  const double stretch = final_stretch(initial[2]);
  const double strain = 2.0 * std::log(stretch) / (2.0 * std::log(final_stretch(0.0))) * foot_plastic_strain;
  return {initial, deformed(initial, progress), -impact_speed * height * (1.0 - progress), progress * strain,
          -400e6 * (1.0 - height)};
}

std::vector<Particle> make_particles(int across, double progress) {
  const double spacing = width / across;
  std::vector<Particle> particles;
  for (int k = 0; k < 5 * across; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i)
        particles.push_back(make_particle(
            {(i + 0.5) * spacing - width / 2, (j + 0.5) * spacing - width / 2, (k + 0.5) * spacing}, progress));
  return particles;
}

template <class Values>
FrameArray make_array(const std::string& name, const std::string& unit, bool integer,
                      const std::vector<Particle>& particles, Values values_of) {
  FrameArray array{name, unit, 1, integer, {}};
  for (const Particle& particle : particles) {
    const auto values = values_of(particle);
    array.components = static_cast<int>(values.size());
    array.values.insert(array.values.end(), values.begin(), values.end());
  }
  return array;
}

}  // namespace

Frame make_mushroom(int across, double progress, int index) {
  const auto particles = make_particles(across, progress);
  Frame frame;
  frame.scene = "mushroom";
  frame.time = progress * end_time;
  frame.step = 100 * index;
  frame.index = index;
  frame.provenance = {{"title", "Square copper rod on a rigid wall, 227 m/s"}};
  for (const Particle& particle : particles)
    frame.positions.insert(frame.positions.end(), particle.position.begin(), particle.position.end());

  using Scalar = std::array<double, 1>;
  double id = 0.0;
  frame.arrays = {
      make_array("particle_id", "", true, particles, [&](const Particle&) { return Scalar{id++}; }),
      make_array("body", "", true, particles, [](const Particle&) { return Scalar{0.0}; }),
      make_array("initial_position", "m", false, particles, [](const Particle& p) { return p.initial; }),
      make_array("velocity", "m/s", false, particles,
                 [](const Particle& p) {
                   return Point{0.0, 0.0, p.velocity};
                 }),
      make_array("density", "kg/m3", false, particles, [](const Particle&) { return Scalar{density}; }),
      make_array("pressure", "Pa", false, particles, [](const Particle& p) { return Scalar{-p.axial_stress / 3.0}; }),
      make_array("stress", "Pa", false, particles,
                 [](const Particle& p) { return std::array<double, 6>{0.0, 0.0, p.axial_stress, 0.0, 0.0, 0.0}; }),
      make_array("plastic_strain", "", false, particles, [](const Particle& p) { return Scalar{p.plastic_strain}; }),
      make_array("smoothing_length", "m", false, particles, [&](const Particle&) { return Scalar{width / across}; })};
  return frame;
}

}  // namespace anvil::test
