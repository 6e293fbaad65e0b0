// SPDX-License-Identifier: BSD-3-Clause
// Elastic waves: figures worked out by hand, and two independent methods against each other.
#include <gtest/gtest.h>

#include <cmath>

#include "anvil/exact/front_tracking.hpp"
#include "anvil/exact/layered_plate.hpp"
#include "unit/exact/plates.hpp"

namespace anvil {
namespace {

constexpr double beside = 0.02 * mm;  // fronts are given to a hundredth of a millimetre

/// Stress (GPa) on both sides of a front at `position` (mm).
void expect_front(const LayeredPlate& plate, double time, double position, double left, double right) {
  const double half_of_last_digit = 0.5e-4;
  EXPECT_NEAR(plate.at(position * mm - beside, time).stress / gpa, left, half_of_last_digit) << position;
  EXPECT_NEAR(plate.at(position * mm + beside, time).stress / gpa, right, half_of_last_digit) << position;
}

TEST(LayeredPlate, CrossesTwoLayers) {
  const LayeredPlate plate(two_layer_plate(), 16.0 * us);
  expect_front(plate, 6.0 * us, 6.075, 0.0, -0.5);
  expect_front(plate, 6.0 * us, 36.448, -0.5, 0.0);
  expect_front(plate, 12.0 * us, 27.10, 0.0, -0.2567);
  expect_front(plate, 12.0 * us, 42.52, -0.2567, -0.7567);
  expect_front(plate, 12.0 * us, 74.75, -0.7567, 0.0);
  expect_front(plate, 16.0 * us, 2.81, 0.0, -0.2567);
  expect_front(plate, 16.0 * us, 33.18, -0.2567, 0.0);
  expect_front(plate, 16.0 * us, 58.99, 0.0, 0.7567);
  expect_front(plate, 16.0 * us, 68.18, 0.7567, 0.0);
}

TEST(LayeredPlate, PulseReachesInterfaceAndFreeFaceInTime) {
  const PlateProblem problem = two_layer_plate();
  EXPECT_NEAR(problem.layers[0].material.elastic_wave_speed(), 6074.7, 0.05);
  EXPECT_NEAR(problem.layers[1].material.elastic_wave_speed(), 6565.6, 0.05);
  const LayeredPlate plate(problem, 16.0 * us);
  EXPECT_EQ(plate.at(50.0 * mm, 8.230 * us).stress, 0.0);
  EXPECT_NEAR(plate.at(50.0 * mm, 8.232 * us).stress, -1.5135 * 0.5 * gpa, 5e-5 * gpa);
  EXPECT_EQ(plate.at(80.0 * mm, 12.79 * us).velocity, 0.0);
  EXPECT_GT(plate.at(80.0 * mm, 12.81 * us).velocity, 0.0);
}

/// The rod of Sun 2017: 800 MPa for 12 us.
PlateProblem rod() {
  PlateProblem problem;
  problem.layers = {{0.2, WaveMaterial::uniaxial_stress(7800.0, 226.9 * gpa, {})}};
  problem.left_face.pressure = PressureHistory::half_sine(0.8 * gpa, 12.0 * us);
  return problem;
}

TEST(LayeredPlate, CarriesAHalfSineAlongARod) {
  EXPECT_NEAR(rod().layers[0].material.elastic_wave_speed(), 5393.5, 0.05);
  const LayeredPlate plate(rod(), 15.0 * us);
  EXPECT_NEAR(plate.at(48.54 * mm, 15.0 * us).stress, -0.8 * gpa, 1e-6 * gpa);
  EXPECT_EQ(plate.at(80.91 * mm, 15.0 * us).stress, 0.0);
  EXPECT_LT(plate.at(80.89 * mm, 15.0 * us).stress, 0.0);
  EXPECT_LT(plate.at(16.19 * mm, 15.0 * us).stress, 0.0);
  EXPECT_EQ(plate.at(16.17 * mm, 15.0 * us).stress, 0.0);
}

TEST(LayeredPlate, AWallDoublesTheStress) {
  PlateProblem problem = two_layer_plate();
  problem.right_face.rigid = true;
  const LayeredPlate plate(problem, 13.0 * us);
  EXPECT_NEAR(plate.at(79.9 * mm, 13.0 * us).stress, -2.0 * 0.75675 * gpa, 1e-4 * gpa);
  EXPECT_NEAR(plate.at(79.9 * mm, 13.0 * us).velocity, 0.0, 1e-9);
}

TEST(LayeredPlate, LayersThatReturnToRestHaveTheImpulse) {
  // A wall on the left and a moving plate: momentum reverses once the wave has been there and back.
  PlateProblem problem;
  problem.layers = {{10.0 * mm, elastic_steel(), -20.0}};
  problem.left_face.rigid = true;
  const double there_and_back = 20.0 * mm / elastic_steel().elastic_wave_speed();
  const LayeredPlate plate(problem, 2.0 * there_and_back);
  EXPECT_NEAR(plate.at(3.0 * mm, 1.01 * there_and_back).velocity, 20.0, 1e-9);
  EXPECT_NEAR(plate.at(3.0 * mm, 1.01 * there_and_back).stress, 0.0, 1e-3);
}

/// Three layers that move, between a wall and a face under a load made of ramps and jumps; steps only.
PlateProblem odd_plates() {
  const WaveMaterial lead = WaveMaterial::small_strain(11340.0, 46.0 * gpa, {.shear_modulus = 5.6 * gpa});
  PlateProblem problem;
  problem.left_position = -3.0 * mm;
  problem.layers = {{7.3 * mm, elastic_aluminium(), 12.0}, {3.1 * mm, lead}, {11.9 * mm, elastic_steel(), -4.0}};
  problem.left_face.pressure = PressureHistory::tabulated({0.0, 1.1e-6, 1.1e-6, 2.7e-6, 4.0e-6, 5.5e-6},
                                                          {0.3e9, 0.3e9, -0.1e9, -0.1e9, 0.0, 0.0});
  problem.right_face.rigid = true;
  return problem;
}

/// Largest difference of stress over the scale and of velocity over that of an elastic wave, away from the fronts.
double largest_difference(const PlateProblem& problem, double time, const TrackingAccuracy& accuracy) {
  const LayeredPlate exact(problem, time);
  FrontTracking fronts(problem, time, accuracy);
  fronts.advance_to(time);
  const double scale = problem.stress_scale();
  double largest = 0.0;
  for (const WaveZone& zone : fronts.profile().zones) {
    if (zone.width() < 1e-4 * mm) continue;
    const LayeredPlate::Point point = exact.at(0.5 * (zone.begin + zone.end), time);
    const WaveMaterial& material = problem.layers[zone.layer].material;
    const double impedance = material.density() * material.elastic_wave_speed();
    largest = std::max(largest, std::abs(zone.state.stress - point.stress) / scale);
    largest = std::max(largest, std::abs(zone.state.velocity - point.velocity) * impedance / scale);
  }
  return largest;
}

TEST(LayeredPlate, AgreesWithFrontTrackingInTwoLayers) {
  for (const double time : {6.0, 12.0, 16.0, 40.0})
    EXPECT_LT(largest_difference(two_layer_plate(), time * us, {}), 1e-6) << time;
}

TEST(LayeredPlate, AgreesWithFrontTrackingInOddPlates) {
  PlateProblem problem = odd_plates();
  problem.left_face.pressure =
      PressureHistory::tabulated({0.0, 1.1e-6, 1.1e-6, 2.7e-6}, {0.3e9, 0.3e9, -0.1e9, -0.1e9});
  // Waves down to 1e-9 of the scale are followed, some hundreds at a time.
  for (const double time : {0.5, 2.0, 7.0, 15.0}) EXPECT_LT(largest_difference(problem, time * us, {}), 1e-6) << time;
}

TEST(LayeredPlate, FrontTrackingFollowsARampByItsSteps) {
  // Half a step of the ramp is the largest difference between it and its steps; reflections may add one more.
  for (const double step : {0.02, 0.005})
    EXPECT_LT(largest_difference(odd_plates(), 7.0 * us, {.step = step, .smallest = 1e-6}), step);
}

TEST(LayeredPlate, RefusesImpossiblePlates) {
  PlateProblem problem;
  EXPECT_THROW(LayeredPlate(problem, 1.0), InputError);
  problem = two_layer_plate();
  problem.layers[0].thickness = 0.0;
  EXPECT_THROW(LayeredPlate(problem, 1.0), InputError);
}

}  // namespace
}  // namespace anvil
