// SPDX-License-Identifier: BSD-3-Clause
#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

const PairLoops<1>::KernelLoops& loops_of(const Kernel& kernel) { return pair_loops<1>().kernels[kernel.index()]; }

/// The loop that does all at once against the loops it stands for, with every kernel. Rows are empty and one to three
/// vectors long; on the even line most hold the two particles before and behind, if the kernel's support is two.
class LineLoops : public testing::TestWithParam<std::tuple<Kernel, double>> {
 protected:
  [[nodiscard]] static const Kernel& kernel() { return std::get<Kernel>(GetParam()); }
  Cloud<1> cloud_{kernel(), line_with_a_stray_particle(std::get<double>(GetParam()))};

 private:
  static std::vector<Vec<1>> line_with_a_stray_particle(double jitter) {
    auto points = jittered_lattice<1>(Cloud<1>::per_axis, Cloud<1>::spacing, jitter);
    points.push_back(Vec<1>(1e3 * Cloud<1>::spacing));
    return points;
  }
};

TEST_P(LineLoops, GiveTheGradientsOfTheSeparateLoops) {
  PairTile<1> tile = cloud_.tile();
  std::vector<double> corrected(cloud_.gradient[0].size()), at_once(corrected.size()), plain(corrected.size());
  std::vector<double> inverse(cloud_.count), inverse_at_once(cloud_.count);
  tile.gradient[0] = corrected.data();
  tile.correction = inverse.data();
  EXPECT_EQ(pair_loops<1>().correct_gradients(tile, cloud_.records), 1);
  tile.plain_gradient[0] = plain.data();
  tile.gradient[0] = at_once.data();
  tile.correction = inverse_at_once.data();
  EXPECT_EQ(loops_of(kernel()).corrected_gradients(tile, cloud_.records), 1);
  const auto pairs = static_cast<std::size_t>(cloud_.list.first()[cloud_.count]);
  for (std::size_t k = 0; k < pairs; ++k) {
    EXPECT_DOUBLE_EQ(plain[k], cloud_.gradient[0][k]);
    EXPECT_NEAR(at_once[k], corrected[k], 1e-13 * std::abs(corrected[k]));
  }
  for (std::size_t i = 0; i < cloud_.count; ++i) EXPECT_NEAR(inverse_at_once[i], inverse[i], 1e-13 * inverse[i]);
  tile.plain_gradient[0] = tile.gradient[0] = plain.data();  // one memory for both, as when nobody asks for the plain
  (void)loops_of(kernel()).corrected_gradients(tile, cloud_.records);
  for (std::size_t k = 0; k < pairs; ++k) EXPECT_EQ(plain[k], at_once[k]);
}

TEST_P(LineLoops, GiveTheVelocityGradientOfTheSeparateLoops) {
  const PairTile<1> tile = cloud_.tile();
  std::vector<double> at_once(cloud_.count), apart(cloud_.count);
  EXPECT_EQ(loops_of(kernel()).corrected_velocity_gradient(tile, cloud_.records, at_once.data()), 1);
  (void)pair_loops<1>().correct_gradients(tile, cloud_.records);
  pair_loops<1>().velocity_gradient(tile, cloud_.records, apart.data());
  double largest = 0.0;
  for (const double rate : apart) largest = std::max(largest, std::abs(rate));
  EXPECT_GT(largest, 0.0);
  for (std::size_t i = 0; i < cloud_.count; ++i) EXPECT_NEAR(at_once[i], apart[i], 1e-13 * largest) << "particle " << i;
}

const Kernel kernels[] = {CubicSpline(), Gaussian(), Quadratic(), WendlandC2(), WendlandC4(), QuinticSpline()};

INSTANTIATE_TEST_SUITE_P(AllKernels, LineLoops, testing::Combine(testing::ValuesIn(kernels), testing::Values(0.0, 0.2)),
                         [](const auto& named) {
                           const Kernel& kernel = std::get<Kernel>(named.param);
                           const std::string name(std::visit([](const auto& one) { return one.name; }, kernel));
                           return name + (std::get<double>(named.param) == 0.0 ? "_even" : "_uneven");
                         });

}  // namespace
}  // namespace anvil
