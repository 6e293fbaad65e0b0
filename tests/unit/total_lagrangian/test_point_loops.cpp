// SPDX-License-Identifier: BSD-3-Clause
// Points in lanes: whatever number of them is left for the last lanes, and beside the formulas for one point.
#include <gtest/gtest.h>

#include "anvil/materials/material_update.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/materials/stress_update.hpp"
#include "unit/materials/specimens.hpp"
#include "unit/terms/term_cloud.hpp"
#include "unit/total_lagrangian/frozen_block.hpp"

namespace anvil {
namespace {

template <class T>
class PointLoopsIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(PointLoopsIn, Dimensions);

std::vector<double> random_numbers(std::size_t count, double size) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<double> numbers(count);
  for (double& number : numbers) number = uniform(random);
  return numbers;
}

/// A block in motion whose edges have stresses, its loops called for `pieces` particles at a time.
template <int D>
struct WorkedBlock : FrozenBlock<D> {
  explicit WorkedBlock(std::int32_t pieces) : edges(this->fields, {this->all()}, FrozenBlock<D>::spacing) {
    this->move_at_random(1e-7, 200.0);
    const ParticleRange range = edges.edges_from(this->all());
    constexpr std::size_t components = StrainStateOf<D>::Type::components;
    const auto stresses = random_numbers(static_cast<std::size_t>(range.count()) * components, 1e8);
    std::copy(stresses.begin(), stresses.end(),
              edges.fields().template vector<components>(field::deviatoric_stress).raw());
    gradients.resize(static_cast<std::size_t>(range.count()) * D * D);
    for (std::int32_t first = 0; first < this->all().end; first += pieces) {
      const ParticleRange particles{first, std::min(first + pieces, this->all().end)};
      const ParticleRange some = edges.edges_from(particles);
      EXPECT_EQ(edges.deform(some, this->deformation, 1e-7, gradients.data() + some.first() * D * D), -1);
      edges.pull_back(some);
    }
    for (std::int32_t first = 0; first < this->all().end; first += pieces)
      edges.sum_forces({first, std::min(first + pieces, this->all().end)});
  }

  [[nodiscard]] std::vector<double> sums() const {
    return {edges.force_sums(), edges.force_sums() + this->count * (D * D + D)};
  }

  EdgePoints<D> edges;
  std::vector<double> gradients;
};

TYPED_TEST(PointLoopsIn, GiveTheSameBitsForEdgesHoweverManyAreLeftOver) {
  constexpr int D = TypeParam::value;
  WorkedBlock<D> whole(1000);
  const auto density = whole.edges.fields().scalar(field::density);
  for (const std::int32_t pieces : {1, 2, 3, 5}) {
    WorkedBlock<D> parts(pieces);
    EXPECT_EQ(parts.gradients, whole.gradients) << pieces;
    EXPECT_EQ(parts.sums(), whole.sums()) << pieces;
    const auto part_density = parts.edges.fields().scalar(field::density);
    EXPECT_TRUE(std::equal(density.begin(), density.end(), part_density.begin())) << pieces;
  }
}

TYPED_TEST(PointLoopsIn, DeformEdgesAsTheirBody) {
  constexpr int D = TypeParam::value;
  FrozenBlock<D> block;
  EdgePoints<D> edges(block.fields, {block.all()}, FrozenBlock<D>::spacing);
  Square<D> rate;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) rate(a, b) = 1e5 * (0.3 + a - 0.7 * b);
  for (std::size_t i = 0; i < block.count; ++i) block.velocity()[i] = rate * block.start[i];
  constexpr double time_step = 1e-6;
  const std::vector<double> of_particles = block.move(time_step);
  const ParticleRange range = edges.edges_from(block.all());
  std::vector<double> of_edges(static_cast<std::size_t>(range.count()) * D * D);
  ASSERT_EQ(edges.deform(range, block.deformation, time_step, of_edges.data()), -1);
  const Square<D> middle = Square<D>::Identity() + 0.5 * time_step * rate, exact = rate * middle.inverse();
  const double stretched = (middle + 0.5 * time_step * rate).determinant();
  for (std::size_t e = 0; e < range.last(); ++e) {
    EXPECT_NEAR((ConstSquareMap<D>(&of_edges[e * D * D]) - exact).norm(), 0.0, 1e-11 * rate.norm());
    EXPECT_NEAR(edges.fields().scalar(field::density)[e], FrozenBlock<D>::density / stretched, 1e-8);
  }
  for (std::size_t i = 0; i < block.count; ++i)
    EXPECT_NEAR((ConstSquareMap<D>(&of_particles[i * D * D]) - exact).norm(), 0.0, 1e-11 * rate.norm());
}

/// Points with random stresses and back stresses, one more than are worked on.
template <int D>
struct Specimen {
  static constexpr int components = StrainStateOf<D>::Type::components;

  Specimen(const Strength& law, std::size_t count) : fields(count + 1) {
    strength = make_strength_update<D>(law, fields);
    for (double& mass : fields.scalar(field::mass)) mass = 2.0;
    for (double& density : fields.scalar(field::density)) density = 8000.0;
    for (const FieldKey* key : {&field::deviatoric_stress, &field::back_stress}) {
      const std::vector<double> numbers = random_numbers((count + 1) * components, 3e8);
      std::copy(numbers.begin(), numbers.end(), fields.template vector<components>(*key).raw());
    }
  }
  Tensor tensor(const FieldKey& key, std::size_t point) {
    return StrainStateOf<D>::Type::deviator(fields.template vector<components>(key).raw() + point * components);
  }

  FieldStore fields;
  std::unique_ptr<StrengthUpdate<D>> strength;
};

template <int D>
void expect_steps_of_single_points(std::size_t count) {
  const J2 law(testing_support::specimen(J2::kind(), true));
  Specimen<D> before(law, count), after(law, count);
  const std::vector<double> gradients = random_numbers(count * D * D, 2e5);
  constexpr double time_step = 1e-7;
  const double work =
      after.strength->update({0, static_cast<std::int32_t>(count)}, gradients.data(), nullptr, time_step);
  double expected_work = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    StrengthHistory history;
    history.back_stress = before.tensor(field::back_stress, k);
    Tensor deviator = before.tensor(field::deviatoric_stress, k);
    const PlasticStep step =
        update_deviator(law, deviator, history, lift_gradient<D>(&gradients[k * D * D]), time_step);
    expected_work += step.plastic_work * 2.0 / 8000.0;
    EXPECT_NEAR((after.tensor(field::deviatoric_stress, k) - deviator).norm(), 0.0, 1e-13 * 1e9);
    EXPECT_NEAR((after.tensor(field::back_stress, k) - history.back_stress).norm(), 0.0, 1e-13 * 1e9);
    EXPECT_NEAR(after.fields.scalar(field::plastic_strain)[k], history.plastic_strain, 1e-13);
  }
  EXPECT_GT(expected_work, 0.0);
  EXPECT_NEAR(work, expected_work, 1e-11 * expected_work);
  for (const FieldKey* key : {&field::deviatoric_stress, &field::back_stress})
    EXPECT_EQ(after.tensor(*key, count), before.tensor(*key, count));
}

TEST(StrengthInLanes, TakesTheStepsOfSinglePoints) {
  for (std::size_t count = 1; count < 10; ++count) {
    expect_steps_of_single_points<2>(count);
    expect_steps_of_single_points<3>(count);
  }
}

}  // namespace
}  // namespace anvil
