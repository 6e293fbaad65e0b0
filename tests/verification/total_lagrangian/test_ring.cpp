// SPDX-License-Identifier: BSD-3-Clause
// A ring on a square lattice that runs together: an eighth between planes at 0 and 45 degrees is the whole.
#include <cmath>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

std::unique_ptr<Simulation> ring(const std::string& sector, const std::string& planes) {
  return make_simulation(read_scene_text(R"(
title = "Ring"
domain.dimension = 2
discretisation = { method = "total_lagrangian", kernel = "cubic_spline", spacing = 1e-3, smoothing_ratio = 0.8 }
shock.method = "bulk_viscosity"
stabiliser.method = "edge_stress_points"
time = { end = 1e-3, cfl = 0.5 }
[[body]]
name = "ring"
shape = { type = "ring", inner_radius = 8e-3, outer_radius = 12e-3, )" +
                                             sector + R"( }
lattice = "face_lattice"
material = "copper"
radial_velocity = -100.0
[material.copper]
density = 8930.0
eos = { type = "linear", bulk_modulus = 130e9 }
strength = { type = "j2", shear_modulus = 43e9, yield_stress = 400e6, hardening_modulus = 100e6, isotropic_fraction = 1.0 }
[output]
interval = 1e-4
)" + planes,
                                         "ring"));
}

TEST(Ring, AnEighthBetweenPlanesIsTheWhole) {
  const auto whole = ring("sector = \"full\"", "");
  const auto eighth = ring("sector = \"wedge\", opening = 0.78539816339744831",
                           "[[boundary]]\nname = \"below\"\ntype = \"symmetry_plane\"\nnormal = [0, 1]\n"
                           "[[boundary]]\nname = \"diagonal\"\ntype = \"symmetry_plane\"\nnormal = [1, -1]\n");
  EXPECT_NEAR(8.0 * audited(*eighth, "mass"), audited(*whole, "mass"), 1e-12 * audited(*whole, "mass"));
  const double energy = audited(*whole, "kinetic_energy");
  for (const auto& one : {whole.get(), eighth.get()}) run_to(*one, 10e-6);
  EXPECT_EQ(whole->step(), eighth->step());
  const Frame all = whole->frame(), part = eighth->frame();
  const auto starts = array_of(all, "initial_position"), start = array_of(part, "initial_position");
  double largest = 0.0;
  for (std::size_t i = 0; i < part.particle_count(); ++i) {
    double least = 1.0;
    for (std::size_t j = 0; j < all.particle_count(); ++j) {
      if (std::hypot(starts[3 * j] - start[3 * i], starts[3 * j + 1] - start[3 * i + 1]) > 1e-9) continue;
      least = std::hypot(all.positions[3 * j] - part.positions[3 * i],
                         all.positions[3 * j + 1] - part.positions[3 * i + 1]);
    }
    largest = std::max(largest, least);
  }
  EXPECT_LT(largest, 1e-11 * 12e-3);
  EXPECT_GT(audited(*whole, "plastic_work"), 0.05 * energy);
  EXPECT_NEAR(8.0 * audited(*eighth, "plastic_work"), audited(*whole, "plastic_work"), 1e-10 * energy);
  for (const auto& one : {whole.get(), eighth.get()})
    EXPECT_LT(std::abs(audited(*one, "energy_error")), 0.005 * energy);
}

}  // namespace
}  // namespace anvil
