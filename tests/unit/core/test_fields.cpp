// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/core/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "anvil/core/field_keys.hpp"

namespace anvil {
namespace {

TEST(FieldStore, FieldIsZeroWhenItIsRequiredFirst) {
  FieldStore fields(3);
  EXPECT_FALSE(fields.has(field::density));
  fields.require(field::density);
  ASSERT_TRUE(fields.has(field::density));
  EXPECT_EQ(fields.scalar(field::density).size(), 3U);
  EXPECT_TRUE(std::ranges::all_of(fields.scalar(field::density), [](double value) { return value == 0.0; }));
}

TEST(FieldStore, SecondRequestKeepsFieldAndValues) {
  FieldStore fields(3);
  fields.require(field::density);
  fields.scalar(field::density)[1] = 7.0;
  const double* memory = fields.scalar(field::density).data();
  fields.require(field::density);
  EXPECT_EQ(fields.fields().size(), 1U);
  EXPECT_EQ(fields.scalar(field::density).data(), memory);
  EXPECT_EQ(fields.scalar(field::density)[1], 7.0);
}

TEST(FieldStore, ViewsOutliveLaterFieldsAndAMoveOfTheStore) {
  FieldStore fields(2);
  fields.require(field::velocity, 2);
  const auto velocity = fields.vector<2>(field::velocity);
  velocity[1] = Vec<2>(3.0, 4.0);
  for (const FieldKey* key : {&field::mass, &field::density, &field::pressure, &field::plastic_strain})
    fields.require(*key);
  FieldStore moved = std::move(fields);
  EXPECT_EQ(moved.vector<2>(field::velocity).raw(), velocity.raw());
  EXPECT_EQ(moved.vector<2>(field::velocity)[1], Vec<2>(3.0, 4.0));
}

TEST(FieldStore, VectorsStandParticleByParticle) {
  FieldStore fields(2);
  fields.require(field::velocity, 3);
  fields.vector<3>(field::velocity)[1] = Vec<3>(1.0, 2.0, 3.0);
  EXPECT_EQ(fields.fields().front().values, (std::vector<double>{0, 0, 0, 1, 2, 3}));
}

TEST(FieldStore, RefusesAnotherNumberOfComponents) {
  FieldStore fields(2);
  fields.require(field::velocity, 3);
  EXPECT_THROW(fields.require(field::velocity, 2), std::logic_error);
  EXPECT_THROW((void)fields.scalar(field::velocity), std::logic_error);
  EXPECT_THROW((void)fields.vector<2>(field::velocity), std::logic_error);
}

TEST(FieldStore, NamesTheFieldThatNobodyRequired) {
  const FieldStore fields(2);
  try {
    (void)fields.scalar(field::plastic_strain);
    FAIL() << "an absent field was handed out";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("plastic_strain"), std::string::npos);
  }
}

}  // namespace
}  // namespace anvil
