// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

struct History {
  std::string name;
  Parameters keys;
  std::function<double(double)> pressure;  // written once more, as the scene's page says it
  double end;                              // s, nothing comes behind it
};

Parameters keys_of(const std::string& history) {
  Parameters keys;
  keys.set("history", history);
  return keys;
}

std::vector<History> histories() {
  std::vector<History> all;
  all.push_back({"rectangular", keys_of("rectangular"), [](double t) { return t < 5e-6 ? 2e9 : 0.0; }, 6e-6});
  all.push_back({"exponential", keys_of("exponential"), [](double t) { return 2e9 * std::exp(-t / 3e-6); }, 9e-6});
  all.push_back({"half_sine", keys_of("half_sine"),
                 [](double t) { return t < 5e-6 ? 2e9 * std::sin(std::numbers::pi * t / 5e-6) : 0.0; }, 6e-6});
  all.push_back({"tabulated", keys_of("tabulated"),
                 [](double t) {
                   if (t < 1e-6 || t >= 4e-6) return 0.0;
                   return t < 2e-6 ? 1e9 * (t / 1e-6 - 1.0) : 3e9 - 0.5e9 * (t / 1e-6 - 2.0);
                 },
                 6e-6});
  for (auto& history : all) {
    if (history.name == "tabulated") {
      history.keys.set("table", Points{{1e-6, 0.0}, {2e-6, 1e9}, {2e-6, 3e9}, {4e-6, 2e9}});
      continue;
    }
    history.keys.set("value", 2e9);
    history.keys.set(history.name == "exponential" ? "decay" : "duration", history.name == "exponential" ? 3e-6 : 5e-6);
  }
  return all;
}

TEST(Pressure, ImpulseIsTheIntegralOfThePressure) {
  for (const auto& history : histories()) {
    const auto load = make_load_history(history.keys);
    constexpr int steps = 60000;
    const double dt = history.end / steps;
    double integral = 0.0;
    for (int k = 0; k < steps; ++k) {
      integral += dt * history.pressure((k + 0.5) * dt);
      // The midpoint rule: a jump inside a step costs half a step of the highest pressure.
      EXPECT_NEAR(load->impulse((k + 1) * dt), integral, 3e9 * dt) << history.name;
    }
    EXPECT_EQ(load->impulse(0.0), 0.0) << history.name;
  }
}

TEST(Pressure, ImpulsesOfKnownHistories) {
  const auto all = histories();
  EXPECT_DOUBLE_EQ(make_load_history(all[0].keys)->impulse(1.0), 1e4);
  EXPECT_DOUBLE_EQ(make_load_history(all[1].keys)->impulse(1.0), 6e3);
  EXPECT_DOUBLE_EQ(make_load_history(all[2].keys)->impulse(1.0), 2e4 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(make_load_history(all[3].keys)->impulse(1.0), 0.5e3 + 5e3);
}

TEST(Pressure, RefusesKeysThatDoNotBelongToTheHistory) {
  Parameters keys = keys_of("exponential");
  keys.set("value", 1e9);
  EXPECT_THROW((void)make_load_history(keys), InputError);  // no decay
  keys.set("decay", 1e-6);
  EXPECT_NO_THROW((void)make_load_history(keys));
  keys.set("duration", 1e-6);
  EXPECT_THROW((void)make_load_history(keys), InputError);
}

TEST(Pressure, RefusesTablesThatFallBackInTime) {
  Parameters keys = keys_of("tabulated");
  for (const Points& table : {Points{{0.0, 1.0}}, Points{{1e-6, 1.0}, {0.0, 2.0}}, Points{{-1e-6, 0.0}, {1e-6, 1.0}},
                              Points{{0.0, 1.0, 2.0}, {1.0, 1.0, 2.0}}}) {
    keys.set("table", table);
    EXPECT_THROW((void)make_load_history(keys), InputError);
  }
}

}  // namespace
}  // namespace anvil
