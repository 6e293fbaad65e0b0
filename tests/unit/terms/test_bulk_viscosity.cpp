// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "anvil/core/field_keys.hpp"
#include "anvil/terms/bulk_viscosity.hpp"

namespace anvil {
namespace {

constexpr double density = 8000.0, spacing = 1e-3, sound_speed = 4000.0, time_step = 1e-8;

/// One particle of unit mass.
FieldStore particle() {
  FieldStore fields(1);
  for (const FieldKey* key : {&field::mass, &field::density}) fields.require(*key);
  fields.scalar(field::mass)[0] = 1.0;
  fields.scalar(field::density)[0] = density;
  return fields;
}

/// What a compression by `rate` (1/s) gives, and the loss.
std::pair<double, double> viscous_pressure(double rate, double stretch) {
  FieldStore fields = particle();
  const BulkViscosity<3> viscosity(fields, 0.06, 1.2, spacing);
  const double gradient[9] = {-rate, 0, 0, 0, 0, 0, 0, 0, 0}, squared = sound_speed * sound_speed;
  const double loss = viscosity.update({0, 1}, gradient, &squared, time_step, [&](std::size_t) { return stretch; });
  return {fields.scalar(field::viscous_pressure)[0], loss};
}

TEST(BulkViscosity, ResistsCompressionOnly) {
  const double rate = 1e5, l = spacing;
  const auto [pressure, loss] = viscous_pressure(rate, 1.0);
  EXPECT_DOUBLE_EQ(pressure, density * l * rate * (0.06 * sound_speed + 1.44 * l * rate));
  // From no pressure to this one over the step, on the volume 1/density.
  EXPECT_DOUBLE_EQ(loss, 0.5 * pressure * rate * time_step / density);
  EXPECT_EQ(viscous_pressure(-rate, 1.0).first, 0.0);
}

// The ends of a layer close at a speed; however thin it is squeezed, the same speed is met by the same pressure.
TEST(BulkViscosity, GoesByTheSpeedAtWhichALayerCloses) {
  const double closing = 100.0;  // m/s
  const double whole = viscous_pressure(closing / spacing, 1.0).first;
  for (const double stretch : {0.3, 0.1, 0.01})
    EXPECT_NEAR(viscous_pressure(closing / (stretch * spacing), stretch).first, whole, 1e-12 * whole);
}

TEST(BulkViscosity, KnowsTheStretchOfAnEvenSqueeze) {
  FieldStore fields = particle();
  const BulkViscosity<3> viscosity(fields, 0.06, 1.2, spacing);
  fields.scalar(field::density)[0] = 8.0 * density;
  EXPECT_NEAR(viscosity.even_stretch(0), 0.5, 1e-15);
}

}  // namespace
}  // namespace anvil
