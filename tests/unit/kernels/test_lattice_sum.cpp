// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/kernels/lattice_sum.hpp"

namespace anvil {
namespace {

// Closed forms in one dimension (Sun 2017, section 3). The print has g^2 in front of the first cubic one; it is 1/g^2.
double cubic_spline_factor(double g) {
  if (g <= 1.0) return std::pow((2.0 - 1.0 / g) / g, 2);
  return 4.0 / (3.0 * g * g) * (3.0 / g - 9.0 / (4.0 * g * g) + 6.0 * std::pow(1.0 - 1.0 / g, 2));
}
double gaussian_factor(double g) {
  double sum = 0.0;
  for (int k = 1; k < 3.0 * g; ++k) sum += k * k * std::exp(-k * k / (g * g));
  return 4.0 * std::numbers::inv_sqrtpi / std::pow(g, 3) * sum;
}
double quadratic_factor(double g) { return 1.5 / (g * g) * (g <= 1.0 ? 1.0 - 1.0 / (2.0 * g) : 3.0 - 5.0 / (2.0 * g)); }

struct PrintedRow {
  std::string_view kernel;
  double (*formula)(double gamma);
  double first_gamma;          // rows follow at steps of 0.1
  std::vector<double> factor;  // as printed, three decimals
};
const std::vector<PrintedRow> printed = {
    {"cubic_spline", cubic_spline_factor, 0.6, {.309, .666, .879, .976, 1.000, 1.011, 1.022, 1.022, 1.010, .988}},
    {"gaussian", gaussian_factor, 0.4, {.068, .330, .650, .862, .958, .990, .996, 1.000, 1.000}},
    {"quadratic", quadratic_factor, 0.6, {.694, .875, .879, .823, .750, .902, .955, .956, .929, .889}}};

TEST(LatticeSum, AgreesWithTheClosedForms) {
  for (const PrintedRow& row : printed) {
    const Kernel kernel = make_kernel(row.kernel);
    for (std::size_t i = 0; i < row.factor.size(); ++i) {
      const double gamma = row.first_gamma + 0.1 * static_cast<double>(i);
      EXPECT_NEAR(lattice_wave_speed_factor(kernel, 1, gamma), row.formula(gamma), 1e-13) << row.kernel << gamma;
    }
  }
}

TEST(LatticeSum, AgreesWithThePrintedTables) {
  for (const PrintedRow& row : printed) {
    const Kernel kernel = make_kernel(row.kernel);
    for (std::size_t i = 0; i < row.factor.size(); ++i) {
      const double gamma = row.first_gamma + 0.1 * static_cast<double>(i);
      // Less than a unit of the last printed decimal: three of the 29 values are not quite rounded to nearest.
      EXPECT_NEAR(lattice_wave_speed_factor(kernel, 1, gamma), row.factor[i], 0.0007) << row.kernel << " " << gamma;
    }
  }
}

// At gamma = 1 the cubic spline reaches the neighbours at distances 1, sqrt(2) and sqrt(3), in number 2, 4 in the plane
// and 2, 8, 8 in space with one unit along x; -slope there is 3/4 (2 - q)^2.
TEST(LatticeSum, CountsTheNeighboursOfThePlaneAndOfSpace) {
  const auto shell = [](double squared) { return 0.75 * std::pow(2.0 - std::sqrt(squared), 2) / std::sqrt(squared); };
  const double plane = 10.0 / (7.0 * std::numbers::pi) * (2.0 * shell(1.0) + 4.0 * shell(2.0));
  const double space = std::numbers::inv_pi * (2.0 * shell(1.0) + 8.0 * shell(2.0) + 8.0 * shell(3.0));
  EXPECT_NEAR(lattice_wave_speed_factor(CubicSpline{}, 2, 1.0), plane, 1e-14);
  EXPECT_NEAR(lattice_wave_speed_factor(CubicSpline{}, 3, 1.0), space, 1e-14);
}

TEST(LatticeSum, TendsToOneWithManyNeighbours) {
  for (const std::string_view name : kernel_names()) {
    for (const int dimension : {1, 2, 3}) {
      // The sum is the trapezoidal rule for an integral that is one; the worst kernel for it is the quadratic, with an
      // error of about 1 / (2 gamma)^2. Cutting the Gaussian at 3 costs up to 6 e^-9 / sqrt(pi) (1 + 6) = 2.9e-3.
      EXPECT_NEAR(lattice_wave_speed_factor(make_kernel(name), dimension, 8.0), 1.0, 0.004) << name << dimension << "D";
    }
  }
}

TEST(LatticeSum, IsZeroWithoutNeighbours) {
  EXPECT_EQ(lattice_wave_speed_factor(CubicSpline{}, 3, 0.5), 0.0);
  EXPECT_EQ(lattice_wave_speed_factor(Gaussian{}, 1, 0.3), 0.0);
}

TEST(LatticeSum, RefusesWhatIsNoLattice) {
  EXPECT_THROW(lattice_wave_speed_factor(CubicSpline{}, 0, 1.0), InputError);
  EXPECT_THROW(lattice_wave_speed_factor(CubicSpline{}, 4, 1.0), InputError);
  EXPECT_THROW(lattice_wave_speed_factor(CubicSpline{}, 1, 0.0), InputError);
  EXPECT_THROW(lattice_wave_speed_factor(CubicSpline{}, 1, std::nan("")), InputError);
}

}  // namespace
}  // namespace anvil
