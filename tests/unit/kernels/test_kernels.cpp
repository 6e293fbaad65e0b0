// SPDX-License-Identifier: BSD-3-Clause
// Properties of every kernel of the table.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/kernels/kernel.hpp"
#include "unit/models_page.hpp"

namespace anvil {
namespace {

/// What a kernel's integral may lack of one; only a kernel that keeps the norm of its uncut form has any.
template <class K>
double missing_integral(int /*dimension*/) {
  return 0.0;
}
template <>
double missing_integral<Gaussian>(int dimension) {
  const double edge = std::exp(-9.0);
  if (dimension == 1) return std::erfc(3.0);
  return dimension == 2 ? edge : std::erfc(3.0) + 6.0 * edge / std::sqrt(std::numbers::pi);
}

/// The integral of W over the line, plane or space for h = 1.
template <class K>
double integral(int dimension) {
  const double sphere = dimension == 1 ? 2.0 : dimension == 2 ? 2.0 * std::numbers::pi : 4.0 * std::numbers::pi;
  const auto shell = [&](double q) { return sphere * std::pow(q, dimension - 1) * K::value(q); };
  double sum = 0.0;
  // Knots of the splines lie at whole q, so each piece is a polynomial.
  for (int piece = 0; piece < static_cast<int>(K::support); ++piece) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(shell, piece, piece + 1);
  }
  return K::normalisation(dimension) * sum;
}

/// A vector of two lanes that offers no more than the pair loops' vectors do: a branch on q would not compile.
struct Lanes {
  Lanes(double both) : lanes{both, both} {}
  Lanes(double first, double second) : lanes{first, second} {}
  std::array<double, 2> lanes;
};
using Mask = std::array<bool, 2>;
template <class F>
Lanes each(F function, Lanes a, Lanes b) {
  return {function(a.lanes[0], b.lanes[0]), function(a.lanes[1], b.lanes[1])};
}
Lanes operator+(Lanes a, Lanes b) { return each(std::plus<>{}, a, b); }
Lanes operator-(Lanes a, Lanes b) { return each(std::minus<>{}, a, b); }
Lanes operator*(Lanes a, Lanes b) { return each(std::multiplies<>{}, a, b); }
Lanes operator/(Lanes a, Lanes b) { return each(std::divides<>{}, a, b); }
Mask operator<(Lanes a, Lanes b) { return {a.lanes[0] < b.lanes[0], a.lanes[1] < b.lanes[1]}; }
Lanes max(Lanes a, Lanes b) {
  return each([](double x, double y) { return std::fmax(x, y); }, a, b);
}
[[maybe_unused]] Lanes min(Lanes a, Lanes b) {
  return each([](double x, double y) { return std::fmin(x, y); }, a, b);
}
[[maybe_unused]] Lanes exp(Lanes a) { return {std::exp(a.lanes[0]), std::exp(a.lanes[1])}; }
[[maybe_unused]] Lanes select(Mask mask, Lanes a, Lanes b) {
  return {mask[0] ? a.lanes[0] : b.lanes[0], mask[1] ? a.lanes[1] : b.lanes[1]};
}

template <class K>
class EveryKernel : public testing::Test {};
TYPED_TEST_SUITE(EveryKernel, testing_support::AlternativesOf<Kernel>::Types);

TYPED_TEST(EveryKernel, IntegratesToOne) {
  for (const int dimension : {1, 2, 3}) {
    // 15 Gauss points are exact for the polynomials here and leave round-off for the Gaussian.
    EXPECT_NEAR(integral<TypeParam>(dimension), 1.0 - missing_integral<TypeParam>(dimension), 1e-13)
        << dimension << "D";
  }
}

TYPED_TEST(EveryKernel, SlopeIsTheDerivativeOfTheValue) {
  const double step = 1e-5;
  // Central differences: round-off 1e-16 / step and truncation step^2, both relative to the peak and below 1e-9, but
  // where the second derivative jumps (the edge of a kernel), the error is of the order of the step; samples avoid it.
  const double tolerance = 1e-8 * TypeParam::value(0.0);
  for (double q = 0.0137; q < TypeParam::support + 0.5; q += 0.0137) {
    if (std::abs(q - TypeParam::support) < 2.0 * step) continue;
    const double difference = (TypeParam::value(q + step) - TypeParam::value(q - step)) / (2.0 * step);
    EXPECT_NEAR(q * TypeParam::slope_over_q(q), difference, tolerance) << "q = " << q;
    if constexpr (requires { TypeParam::slope(q); }) {
      EXPECT_NEAR(TypeParam::slope(q), q * TypeParam::slope_over_q(q), 1e-14) << "q = " << q;
    }
  }
}

TYPED_TEST(EveryKernel, SlopeOverQIsFiniteAtTheCentre) {
  EXPECT_TRUE(std::isfinite(TypeParam::slope_over_q(0.0)));
  EXPECT_LT(TypeParam::slope_over_q(0.0), 0.0);
}

TYPED_TEST(EveryKernel, VanishesAtAndBeyondItsSupport) {
  for (const double q : {TypeParam::support, std::nextafter(TypeParam::support, 10.0), 3.5, 10.0, 1e6}) {
    EXPECT_EQ(TypeParam::value(q), 0.0) << "q = " << q;
    EXPECT_EQ(TypeParam::slope_over_q(q), 0.0) << "q = " << q;
  }
}

TYPED_TEST(EveryKernel, FallsAllTheWay) {
  double previous = TypeParam::value(0.0);
  for (double q = 0.01; q < TypeParam::support; q += 0.01) {
    const double value = TypeParam::value(q);
    EXPECT_GT(value, 0.0) << "q = " << q;
    EXPECT_LT(value, previous) << "q = " << q;
    EXPECT_LT(TypeParam::slope_over_q(q), 0.0) << "q = " << q;
    previous = value;
  }
}

TYPED_TEST(EveryKernel, GivesTheSameInLanes) {
  for (double q = 0.0; q < 4.0; q += 0.05) {
    const Lanes pair(q, 4.0 - q);
    const Lanes value = TypeParam::value(pair);
    const Lanes slope = TypeParam::slope_over_q(pair);
    for (const std::size_t lane : {0U, 1U}) {
      // Fused multiply-adds may round differently in the two instances.
      const double round_off = 1e-14 * TypeParam::value(0.0);
      EXPECT_NEAR(value.lanes[lane], TypeParam::value(pair.lanes[lane]), round_off);
      EXPECT_NEAR(slope.lanes[lane], TypeParam::slope_over_q(pair.lanes[lane]),
                  1e-14 * std::abs(TypeParam::slope_over_q(0.0)));
    }
  }
}

TYPED_TEST(EveryKernel, IsFoundByItsName) {
  EXPECT_TRUE(std::holds_alternative<TypeParam>(make_kernel(TypeParam::name)));
  EXPECT_EQ(kernel_summary(TypeParam::name), TypeParam::summary);
}

TYPED_TEST(EveryKernel, HasARowInTheModelsPage) {
  EXPECT_TRUE(testing_support::models_page_has_row("Kernels", TypeParam::name)) << TypeParam::name;
}

TEST(KernelTable, NamesDiffer) {
  for (std::size_t i = 0; i < kernel_names().size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(kernel_names()[i], kernel_names()[j]);
  }
}

TEST(KernelTable, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  try {
    make_kernel("cubic");
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'cubic'"), std::string::npos) << message;
    for (const std::string_view name : kernel_names()) EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

// The cubic spline in the form in which papers print it (Monaghan and Lattanzio 1985).
TEST(CubicSpline, AgreesWithItsTwoPieces) {
  for (double q = 0.0; q < 2.0; q += 0.01) {
    const double printed = q <= 1.0 ? 1.0 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * std::pow(2.0 - q, 3);
    EXPECT_NEAR(CubicSpline::value(q), printed, 1e-15 * 8.0) << "q = " << q;  // the cubes reach 8
  }
}

TEST(Quadratic, AgreesWithItsPrintedForm) {
  for (double q = 0.0; q < 2.0; q += 0.01) {
    EXPECT_NEAR(Quadratic::value(q), 0.375 * q * q - 1.5 * q + 1.5, 1e-15 * 4.0) << "q = " << q;
  }
}

}  // namespace
}  // namespace anvil
