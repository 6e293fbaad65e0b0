// SPDX-License-Identifier: BSD-3-Clause
// Laminar viscosity and diffusion of density against scalar sums.
#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

constexpr double viscosity = 0.3;  // Pa s, of even particles; odd ones have twice as much

double viscosity_of(std::size_t i) { return i % 2 == 0 ? viscosity : 2.0 * viscosity; }

template <class T>
class FluidTermsIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(FluidTermsIn, Dimensions);

TYPED_TEST(FluidTermsIn, LaminarViscosityIsItsSum) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  for (std::size_t i = 0; i < cloud.count; ++i) cloud.records.medium[i][3] = viscosity_of(i);
  const PairTile<D> tile = cloud.tile();
  std::vector<double> found(cloud.count * D, 0.0), heat(cloud.count, 0.0);
  pair_loops<D>().laminar_viscosity(tile, cloud.records, found.data(), heat.data());
  Vec<D> momentum = Vec<D>::Zero();
  double power = 0.0, heating = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    Vec<D> wanted = Vec<D>::Zero();
    double magnitude = 0.0;
    for (std::size_t j = 0; j < cloud.count; ++j) {
      if (i == j) continue;
      const ScalarPair<D> pair = cloud.pair(i, j);
      const Vec<D> term = cloud.scalar(field::mass, j) * (viscosity_of(i) + viscosity_of(j)) /
                          (cloud.scalar(field::density, i) * cloud.scalar(field::density, j)) *
                          pair.x.dot(pair.gradient) / (pair.x.squaredNorm() + 0.01 * pair.h * pair.h) * pair.v;
      wanted += term;
      magnitude += term.norm();
    }
    const Eigen::Map<const Vec<D>> sum(found.data() + i * D);
    EXPECT_LE((sum - wanted).norm(), 1e-13 * magnitude) << i;  // rounding of some 60 terms
    momentum += cloud.scalar(field::mass, i) * sum;
    power += cloud.scalar(field::mass, i) * sum.dot(cloud.velocity()[i]);
    heating += cloud.scalar(field::mass, i) * heat[i];
    scale += cloud.scalar(field::mass, i) * sum.norm();
  }
  EXPECT_LT(momentum.norm(), 1e-13 * scale);
  EXPECT_GT(heating, 0.0) << "viscosity slows down";
  EXPECT_NEAR(-power, heating, 1e-12 * heating);
}

TYPED_TEST(FluidTermsIn, DensityDiffusionIsItsSumAndKeepsTheWhole) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const PairTile<D> tile = cloud.tile();
  const Vec<D> gravity = Vec<D>::Constant(-9.81);
  std::vector<double> found(cloud.count);
  pair_loops<D>().density_diffusion(tile, cloud.records, 0.1, gravity.data(), found.data());
  for (std::size_t i = 0; i < cloud.count; ++i) {
    double wanted = 0.0, largest = 0.0;
    for (std::size_t j = 0; j < cloud.count; ++j) {
      if (i == j) continue;
      const ScalarPair<D> pair = cloud.pair(i, j);
      const double speed = 0.5 * (cloud.sound_speed[i] + cloud.sound_speed[j]),
                   density = cloud.scalar(field::density, i);
      const double at_rest = -density * gravity.dot(pair.x) / (cloud.sound_speed[i] * cloud.sound_speed[i]);
      const double term = 0.2 * cloud.volume(j) * pair.h * speed *
                          (cloud.scalar(field::density, j) - density - at_rest) * -pair.x.dot(pair.gradient) /
                          (pair.x.squaredNorm() + 0.01 * pair.h * pair.h);
      wanted += term;
      largest = std::max(largest, std::abs(term));
    }
    EXPECT_NEAR(found[i], wanted, 1e-12 * largest) << i;
  }
}

TYPED_TEST(FluidTermsIn, DensityDiffusionFlattens) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto density = cloud.fields.scalar(field::density);
  for (auto& value : density) value = 8000.0;
  density[cloud.count / 2] = 8100.0;
  cloud.pack();
  const PairTile<D> tile = cloud.tile();
  const Vec<D> gravity = Vec<D>::Zero();
  std::vector<double> rate(cloud.count);
  pair_loops<D>().density_diffusion(tile, cloud.records, 0.1, gravity.data(), rate.data());
  EXPECT_LT(rate[cloud.count / 2], 0.0);
  for (std::size_t i = 0; i < cloud.count; ++i) {
    if (i == cloud.count / 2) continue;
    EXPECT_GE(rate[i], 0.0);
  }
}

}  // namespace
}  // namespace anvil
