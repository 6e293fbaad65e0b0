// SPDX-License-Identifier: BSD-3-Clause
// Forces of the reference configuration, from stresses at particles and on edges.
#include "anvil/terms/nominal_momentum.hpp"

#include <memory>

#include "anvil/materials/material_update.hpp"
#include "anvil/materials/strain_state.hpp"
#include "unit/terms/term_cloud.hpp"
#include "unit/total_lagrangian/frozen_block.hpp"

namespace anvil {
namespace {

constexpr double shear_modulus = 40e9;  // Pa

Strength elastic_law() {
  Parameters parameters;
  parameters.set("shear_modulus", shear_modulus);
  return make_strength({"elastic", parameters});
}

/// A block in motion with pressures, and deviators at its particles or on its edges.
template <int D>
struct StressedBlock : FrozenBlock<D> {
  explicit StressedBlock(bool with_edges) {
    if (with_edges)
      edges = std::make_unique<EdgePoints<D>>(this->fields, std::vector<ParticleRange>{this->all()},
                                              FrozenBlock<D>::spacing);
    strength = make_strength_update<D>(elastic_law(), with_edges ? edges->fields() : this->fields);
    momentum = std::make_unique<NominalMomentum<D>>(this->fields, this->deformation, edges.get());
    this->move_at_random(1e-7, 200.0);
    if (edges) follow_edges();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (double& pressure : this->fields.scalar(field::pressure)) pressure = 1e9 * unit(random);
  }

  /// The next step of the edges starts here.
  void follow_edges() {
    const ParticleRange range = edges->edges_from(this->all());
    std::vector<double> gradients(static_cast<std::size_t>(range.count()) * D * D);
    EXPECT_EQ(edges->deform(range, this->deformation, 0.0, gradients.data()), -1);
  }

  /// One more step at the present velocities: deviators become those of its strain. Returns the work of the stresses,
  /// at constant pressures and by the mean of the deviators of before and after.
  double strain(double time_step) {
    double work = pressure_energy();
    std::vector<double> gradients = this->move(time_step);
    work -= pressure_energy();
    ParticleRange range = this->all();
    if (edges) {
      range = edges->edges_from(this->all());
      gradients.resize(static_cast<std::size_t>(range.count()) * D * D);
      EXPECT_EQ(edges->deform(range, this->deformation, time_step, gradients.data()), -1);
    }
    work += 0.5 * deviator_power(gradients) * time_step;
    strength->update(range, gradients.data(), nullptr, time_step);
    work += 0.5 * deviator_power(gradients) * time_step;
    if (edges) edges->pull_back(range);
    return work;
  }

  /// Sum of V s : L over the points that carry deviators, W.
  double deviator_power(const std::vector<double>& gradients) {
    using StrainState = typename StrainStateOf<D>::Type;
    FieldStore& points = edges ? edges->fields() : this->fields;
    const double* deviator = points.template vector<StrainState::components>(field::deviatoric_stress).raw();
    double power = 0.0;
    for (std::size_t k = 0; k < points.particle_count(); ++k) {
      const Tensor full = StrainState::deviator(deviator + k * StrainState::components);
      const Square<D> stress = full.template topLeftCorner<D, D>();
      power += points.scalar(field::mass)[k] / points.scalar(field::density)[k] *
               stress.cwiseProduct(ConstSquareMap<D>(&gradients[k * D * D])).sum();
    }
    return power;
  }

  /// Of constant pressures, p V.
  double pressure_energy() {
    double energy = 0.0;
    for (std::size_t i = 0; i < this->count; ++i)
      energy += this->fields.scalar(field::pressure)[i] * this->fields.scalar(field::mass)[i] /
                this->fields.scalar(field::density)[i];
    return energy;
  }

  std::vector<Vec<D>> accelerations() {
    momentum->pack(this->all(), this->records);
    std::vector<Vec<D>> acceleration(this->count, Vec<D>::Zero());
    std::vector<double> loss(this->count, 0.0);
    momentum->accumulate(this->tile(), this->records, acceleration[0].data(), loss.data());
    if (edges) edges->accumulate(this->tile(), this->records, acceleration[0].data(), loss.data());
    return acceleration;
  }

  std::unique_ptr<EdgePoints<D>> edges;
  std::unique_ptr<StrengthUpdate<D>> strength;
  std::unique_ptr<NominalMomentum<D>> momentum;
};

template <class T>
class NominalMomentumIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(NominalMomentumIn, Dimensions);

TYPED_TEST(NominalMomentumIn, KeepsMomentumAndAngularMomentum) {
  constexpr int D = TypeParam::value;
  for (const bool with_edges : {false, true}) {
    StressedBlock<D> block(with_edges);
    (void)block.strain(1e-7);
    const auto accelerations = block.accelerations();
    ScalarSum<Vec<D>> linear;
    ScalarSum<Vec<3>> angular;
    for (std::size_t i = 0; i < block.count; ++i) {
      const double mass = block.fields.scalar(field::mass)[i];
      linear.add(mass * accelerations[i]);
      Vec<3> arm = Vec<3>::Zero(), vector = Vec<3>::Zero();
      for (int a = 0; a < D; ++a) {
        arm[a] = block.position()[i][a];
        vector[a] = accelerations[i][a];
      }
      angular.add(mass * arm.cross(vector));
    }
    EXPECT_GT(linear.magnitude, 0.0);
    EXPECT_NEAR(linear.value.norm(), 0.0, 1e-12 * linear.magnitude) << "edges " << with_edges;
    // The deformation gradient has advanced by sums over velocities: it is that of the positions to round-off.
    EXPECT_NEAR(angular.value.norm(), 0.0, 1e-11 * angular.magnitude) << "edges " << with_edges;
  }
}

// What the forces do to the motion is minus what the stresses do in the material: over a short step at constant
// velocity, with forces by the mean of before and after, to second order in the strain of the step.
TYPED_TEST(NominalMomentumIn, TakesFromTheMotionWhatStrainsTheMaterial) {
  constexpr int D = TypeParam::value;
  for (const bool with_edges : {false, true}) {
    StressedBlock<D> block(with_edges);
    (void)block.strain(1e-7);
    constexpr double time_step = 1e-10;
    const auto first = block.accelerations();
    const double stress_work = block.strain(time_step);
    const auto second = block.accelerations();
    double work = 0.0, magnitude = 0.0;
    for (std::size_t i = 0; i < block.count; ++i) {
      const double part =
          0.5 * time_step * block.fields.scalar(field::mass)[i] * block.velocity()[i].dot(first[i] + second[i]);
      work += part;
      magnitude += std::abs(part);
    }
    // Volumes are those of the end of the step, by half of its strain of up to 4e-5 away from the middle.
    EXPECT_NEAR(work, -stress_work, 2e-5 * magnitude) << "edges " << with_edges;
    EXPECT_GT(std::abs(work), 1e-2 * magnitude) << "edges " << with_edges;
  }
}

// A lattice in its own rhythm, neighbours against each other: gradients at particles see nothing of it inside, edges
// do.
TYPED_TEST(NominalMomentumIn, EdgesResistWhatGradientsDoNotSee) {
  constexpr int D = TypeParam::value;
  for (const bool with_edges : {false, true}) {
    StressedBlock<D> fresh(with_edges);
    for (std::size_t i = 0; i < fresh.count; ++i) {
      double sign = 1.0;
      for (int a = 0; a < D; ++a)
        if (std::lround(fresh.start[i][a] / FrozenBlock<D>::spacing) % 2 == 1) sign = -sign;
      fresh.velocity()[i] = sign * Vec<D>::Unit(0);
    }
    const auto gradients = fresh.move(1e-7);
    // The particle in the middle of the block.
    const std::size_t middle = fresh.count / 2;
    EXPECT_NEAR(ConstSquareMap<D>(&gradients[middle * D * D]).norm(), 0.0, 1e-9);
    if (!with_edges) continue;
    const ParticleRange range = fresh.edges->edges_from(fresh.all());
    std::vector<double> along(static_cast<std::size_t>(range.count()) * D * D);
    EXPECT_EQ(fresh.edges->deform(range, fresh.deformation, 1e-7, along.data()), -1);
    double largest = 0.0;
    for (const double rate : along) largest = std::max(largest, std::abs(rate));
    EXPECT_GT(largest, 1.0 / FrozenBlock<D>::spacing);  // 2 m/s over a spacing
  }
}

TEST(EdgePoints, ShareTheVolumeOfTheBlock) {
  FrozenBlock<3> block;
  const EdgePoints<3> edges(block.fields, {block.all()}, FrozenBlock<3>::spacing);
  double mass = 0.0;
  for (const double part : edges.fields().scalar(field::mass)) mass += part;
  const double side = (FrozenBlock<3>::per_axis - 1) * FrozenBlock<3>::spacing;
  EXPECT_NEAR(mass, FrozenBlock<3>::density * side * side * side, 1e-12 * mass);
  EXPECT_EQ(edges.fields().particle_count(), 3U * 5 * 5 * 4);
}

// A quadratic field of the middles of edges is read exactly two spacings inside; the mean alone is off.
TEST(EdgePoints, ShowScalarsAtParticlesToSecondOrder) {
  using Block = FrozenBlock<2>;
  Block block;
  EdgePoints<2> edges(block.fields, {block.all()}, Block::spacing);
  edges.fields().require(field::plastic_strain);
  const std::span<double> strain = edges.fields().scalar(field::plastic_strain);
  const auto quadratic = [](const Vec<2>& at) {
    const Vec<2> x = at / Block::spacing;
    return x[0] - 2.0 * x[1] + 0.1 * x[0] * x[0] + 0.05 * x[1] * x[1];
  };
  for (std::int32_t i = 0; i < block.all().end; ++i) {
    // Edges from a particle go to those behind it: along x and along y, as far as the block goes.
    std::size_t e = edges.edges_from({i, i + 1}).first();
    const Vec<2>& start = block.start[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 2; ++axis)
      if (start[axis] < (Block::per_axis - 1.5) * Block::spacing)
        strain[e++] = quadratic(start + 0.5 * Block::spacing * Vec<2>::Unit(axis));
  }
  const std::size_t centre = block.count / 2;
  const double exact = quadratic(block.start[centre]);
  EXPECT_NEAR(edges.scalar_at_particles(field::plastic_strain)[centre], exact, 1e-12);
  EXPECT_GT(std::abs(edges.mean_at_particles(field::plastic_strain)[centre] - exact), 1e-3);
}

TEST(EdgePoints, SayWhereOneHasTurnedInsideOut) {
  FrozenBlock<3> block;
  EdgePoints<3> edges(block.fields, {block.all()}, FrozenBlock<3>::spacing);
  std::vector<double> gradients(static_cast<std::size_t>(edges.edges_from(block.all()).count()) * 9);
  // The gradients at particles stay those of the start: only the edge itself knows that its ends have changed places.
  const auto view = block.fields.vector<3>(field::position);
  const Vec<3> first = view[0];
  view[0] = view[1];
  view[1] = first;
  EXPECT_EQ(edges.deform(edges.edges_from(block.all()), block.deformation, 1e-7, gradients.data()), 0);
}

TEST(EdgePoints, DoNotJoinBodies) {
  FrozenBlock<2> block;
  const std::int32_t half = block.all().end / 2;
  const EdgePoints<2> joined(block.fields, {block.all()}, FrozenBlock<2>::spacing);
  const EdgePoints<2> apart(block.fields, {{0, half}, {half, block.all().end}}, FrozenBlock<2>::spacing);
  EXPECT_LT(apart.fields().particle_count(), joined.fields().particle_count());
}

}  // namespace
}  // namespace anvil
