// SPDX-License-Identifier: BSD-3-Clause
// Elastic flyers on elastic targets: contact between two deformable total Lagrangian bodies, against plane waves.
#include <fmt/format.h>

#include <cmath>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

// Copper: c^2 = (K + 4 G / 3) / rho.
constexpr double density = 8930.0, bulk_modulus = 130e9, shear_modulus = 43.333333333333333e9;  // kg/m3, Pa
constexpr double speed = 20.0;                                                                  // m/s, of the flyer
const double wave_speed = std::sqrt((bulk_modulus + 4.0 / 3.0 * shear_modulus) / density);

/// A scene of two boxes, given by their corners, of which the flyer comes down the last axis; `more` is put behind it.
Scene impact(int dimension, double spacing, const std::string& target, const std::string& flyer,
             const std::string& more = "") {
  const std::string velocity = dimension == 3 ? "[0, 0, -20]" : (dimension == 2 ? "[0, -20]" : "[-20]");
  const std::string shape = dimension == 1 ? "interval" : "box";
  return read_scene_text(fmt::format(R"(
title = "Flyer on target"
domain.dimension = {}
discretisation = {{ method = "total_lagrangian", kernel = "cubic_spline", spacing = {}, smoothing_ratio = 0.8 }}
shock.method = "bulk_viscosity"
stabiliser.method = "edge_stress_points"
time = {{ end = 1e-3, cfl = 0.6 }}
[[body]]
name = "target"
shape = {{ type = "{}", {} }}
lattice = "face_lattice"
material = "elastic_copper"
[[body]]
name = "flyer"
shape = {{ type = "{}", {} }}
lattice = "face_lattice"
material = "elastic_copper"
velocity = {}
[material.elastic_copper]
density = 8930.0
eos = {{ type = "linear", bulk_modulus = 130e9 }}
strength = {{ type = "elastic", shear_modulus = 43.333333333333333e9 }}
[output]
interval = 1e-4
{}
)",
                                     dimension, spacing, shape, target, shape, flyer, velocity, more),
                         "impact");
}

/// Mass, and momentum and mean velocity along the last axis, of one body.
struct Motion {
  double mass = 0.0, momentum = 0.0;
  [[nodiscard]] double velocity() const { return momentum / mass; }
};

Motion motion_of(const Simulation& simulation, int body, std::size_t axis) {
  const Frame frame = simulation.frame();
  const auto bodies = array_of(frame, "body"), masses = array_of(frame, "mass");
  const auto velocities = array_of(frame, "velocity");
  Motion motion;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    if (bodies[i] != body) continue;
    motion.mass += masses[i];
    motion.momentum += masses[i] * velocities[3 * i + axis];
  }
  return motion;
}

constexpr int target = 0, flyer = 1;

void expect_balances(const Simulation& simulation, double start_momentum, double start_energy) {
  EXPECT_LT(audited(simulation, "momentum_error"), 1e-10 * start_momentum);
  EXPECT_LT(std::abs(audited(simulation, "energy_error")), 0.005 * start_energy);
}

/// A strip of 4 mm against one of 4 mm between planes of symmetry: waves are plane to the end.
std::unique_ptr<Simulation> strip(int dimension, double spacing = 0.1e-3) {
  const std::string fields = "fields = [\"mass\"]\n";
  if (dimension == 1) return make_simulation(impact(1, spacing, "min = -4e-3, max = 0", "min = 0, max = 4e-3", fields));
  std::string planes = fields;
  for (const auto& [point, normal] : {std::pair("0", "1"), std::pair("0.4e-3", "-1")})
    planes += fmt::format(
        "[[boundary]]\nname = \"x{}\"\ntype = \"symmetry_plane\"\npoint = [{}, 0{}]\nnormal = [{}, 0{}]\n",
        normal[0] == '-' ? "_high" : "_low", point, dimension == 3 ? ", 0" : "", normal, dimension == 3 ? ", 0" : "");
  if (dimension == 2)
    return make_simulation(
        impact(2, spacing, "min = [0, -4e-3], max = [0.4e-3, 0]", "min = [0, 0], max = [0.4e-3, 4e-3]", planes));
  for (const auto& [point, normal] : {std::pair("0", "1"), std::pair("0.4e-3", "-1")})
    planes += fmt::format(
        "[[boundary]]\nname = \"y{}\"\ntype = \"symmetry_plane\"\npoint = [0, {}, 0]\nnormal = [0, {}, 0]\n",
        normal[0] == '-' ? "_high" : "_low", point, normal);
  return make_simulation(impact(3, spacing, "min = [0, 0, -4e-3], max = [0.4e-3, 0.4e-3, 0]",
                                "min = [0, 0, 0], max = [0.4e-3, 0.4e-3, 4e-3]", planes));
}

class PlaneImpactIn : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimension, PlaneImpactIn, testing::Values(1, 2, 3));

// Of equal bodies: the interface moves at v/2 under rho c v/2 until the waves are back from the far faces, after 2 L/c;
// then they part, the flyer at rest and the target at v.
TEST_P(PlaneImpactIn, OfEqualBodiesIsThatOfPlaneWaves) {
  const int dimension = GetParam();
  const auto axis = static_cast<std::size_t>(dimension - 1);
  const auto simulation = strip(dimension);
  const double area = std::pow(0.4e-3, dimension - 1), length = 4e-3, crossing = length / wave_speed;
  const double start_momentum = density * length * area * speed, start_energy = 0.5 * start_momentum * speed;
  EXPECT_NEAR(audited(*simulation, "kinetic_energy"), start_energy, 1e-12 * start_energy);

  run_to(*simulation, 0.5 * crossing);
  const double early = motion_of(*simulation, target, axis).momentum;
  const double early_push = audited(*simulation, "contact_impulse");
  run_to(*simulation, 1.5 * crossing);
  const double late = motion_of(*simulation, target, axis).momentum;
  const double late_push = audited(*simulation, "contact_impulse");
  const double pressure = density * wave_speed * 0.5 * speed;
  // Compressed by v/(2 c) = 0.2 %, the linear law between pressure and 1/J is stiffer by about as much.
  EXPECT_NEAR((early - late) / (area * crossing), pressure, 0.005 * pressure);
  EXPECT_NEAR(late_push - early_push, early - late, 1e-9 * start_momentum);

  run_to(*simulation, 4.0 * crossing);
  const double spread = 0.025 * speed;  // fronts of some spacings out of 40 open the contact too early: see below
  EXPECT_NEAR(motion_of(*simulation, target, axis).velocity(), -speed, spread);
  EXPECT_NEAR(motion_of(*simulation, flyer, axis).velocity(), 0.0, spread);
  // Nothing else has moved the target.
  EXPECT_NEAR(audited(*simulation, "contact_impulse"), -motion_of(*simulation, target, axis).momentum,
              1e-9 * start_momentum);
  EXPECT_GE(audited(*simulation, "contact_loss"), 0.0);
  expect_balances(*simulation, start_momentum, start_energy);
}

// Dispersion spreads a front over the cube root of the spacings it has passed: what is missing falls with dx^(2/3).
TEST(PlaneImpact, HandsOverMoreOfTheVelocityTheFinerItIs) {
  double missing[2];
  for (const int halvings : {0, 1}) {
    const auto simulation = strip(1, 0.1e-3 / (1 << halvings));
    run_to(*simulation, 4.0 * 4e-3 / wave_speed);
    missing[halvings] = motion_of(*simulation, target, 0).velocity() + speed;
  }
  EXPECT_GT(missing[0], 0.0);
  EXPECT_LT(missing[1], 0.75 * missing[0]);
}

// Particles of the flyer meet the insides of facets, its edges release and its corners press: nothing is plane but the
// middle, and there only until the releases arrive.
void expect_free_flyer_to_keep_its_balances(Simulation& simulation, int dimension, double start_momentum) {
  const auto axis = static_cast<std::size_t>(dimension - 1);
  const double start_energy = 0.5 * start_momentum * speed;
  double deepest = 0.0;
  while (simulation.time() < 4e-6) {
    simulation.advance(4e-6);
    deepest = std::max(deepest, audited(simulation, "contact_penetration"));
  }
  const Motion hit = motion_of(simulation, target, axis), hitting = motion_of(simulation, flyer, axis);
  EXPECT_NEAR(hit.momentum + hitting.momentum, -start_momentum, 1e-10 * start_momentum);
  EXPECT_LT(hit.velocity(), hitting.velocity());  // they have parted
  EXPECT_GE(audited(simulation, "contact_impulse"), -hit.momentum * (1.0 - 1e-9));
  EXPECT_LT(deepest, 0.01 * 0.25e-3);  // of a spacing
  expect_balances(simulation, start_momentum, start_energy);
}

TEST(FreeFlyer, BalancesInTwoDimensions) {
  const auto simulation = make_simulation(impact(2, 0.25e-3, "min = [0, -2e-3], max = [8e-3, 0]",
                                                 "min = [2.1e-3, 0], max = [5.1e-3, 2e-3]", "fields = [\"mass\"]"));
  expect_free_flyer_to_keep_its_balances(*simulation, 2, density * 3e-3 * 2e-3 * speed);
}

TEST(FreeFlyer, BalancesInThreeDimensions) {
  const auto simulation =
      make_simulation(impact(3, 0.25e-3, "min = [0, 0, -2e-3], max = [5e-3, 5e-3, 0]",
                             "min = [1.1e-3, 1.2e-3, 0], max = [3.1e-3, 3.7e-3, 1.5e-3]", "fields = [\"mass\"]"));
  expect_free_flyer_to_keep_its_balances(*simulation, 3, density * 2e-3 * 2.5e-3 * 1.5e-3 * speed);
}

}  // namespace
}  // namespace anvil
