// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {

/// A bundled scene with some keys overridden, ready to run.
inline std::unique_ptr<Simulation> simulation_of(const std::string& scene,
                                                 const std::vector<std::string>& overrides = {}) {
  return make_simulation(read_scene(std::string(ANVIL_SOURCE_DIR) + "/data/scenes/" + scene + ".toml", overrides));
}

/// The square rod with 4 x 4 x 20 particles, for tests of the solver rather than of the rod.
inline std::unique_ptr<Simulation> coarse_rod(std::vector<std::string> overrides = {}) {
  overrides.emplace_back("discretisation.spacing=1.6e-3");
  return simulation_of("rod_square", overrides);
}

inline void run_to(Simulation& simulation, double time) {
  while (simulation.time() < time) simulation.advance(time);
}

inline void run_steps(Simulation& simulation, int steps) {
  for (int step = 0; step < steps; ++step) simulation.advance(1.0);
}

/// One number of the audit.
inline double audited(const Simulation& simulation, const std::string& name) {
  for (const auto& value : simulation.audit())
    if (value.name == name) return value.value;
  ADD_FAILURE() << "the audit has no " << name;
  return 0.0;
}

/// The values of one array of a frame.
inline std::vector<double> array_of(const Frame& frame, const std::string& name) {
  const FrameArray* array = frame.find(name);
  if (array != nullptr) return array->values;
  ADD_FAILURE() << "the frame has no " << name;
  return {};
}

/// Restores the number of threads that was in force.
class WithThreads {
 public:
  explicit WithThreads(int threads) { set_thread_count(threads); }
  ~WithThreads() { set_thread_count(before_); }
  WithThreads(const WithThreads&) = delete;
  WithThreads& operator=(const WithThreads&) = delete;

 private:
  int before_ = thread_count();
};

template <class T>
void expect_same_bits(const std::vector<T>& one, const std::vector<T>& two, const std::string& name) {
  ASSERT_EQ(one.size(), two.size()) << name;
  if (one.empty()) return;
  EXPECT_EQ(std::memcmp(one.data(), two.data(), one.size() * sizeof(T)), 0) << name;
}

/// State, frame and audit of both, bit by bit.
inline void expect_same_bits(const Simulation& one, const Simulation& two) {
  const State a = one.state(), b = two.state();
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [key, array] : a) {
    const std::string& name = key;  // which the lambda below may name
    ASSERT_TRUE(b.contains(name)) << name;
    std::visit([&]<class Values>(
                   const Values& values) { expect_same_bits(values, std::get<Values>(b.at(name).values), name); },
               array.values);
  }
  const Frame frame_a = one.frame(), frame_b = two.frame();
  EXPECT_EQ(frame_a.step, frame_b.step);
  expect_same_bits<double>({frame_a.time}, {frame_b.time}, "time");
  expect_same_bits(frame_a.positions, frame_b.positions, "positions");
  ASSERT_EQ(frame_a.arrays.size(), frame_b.arrays.size());
  for (const auto& array : frame_a.arrays) expect_same_bits(array.values, array_of(frame_b, array.name), array.name);
  const auto audit_a = one.audit(), audit_b = two.audit();
  ASSERT_EQ(audit_a.size(), audit_b.size());
  for (std::size_t k = 0; k < audit_a.size(); ++k)
    expect_same_bits<double>({audit_a[k].value}, {audit_b[k].value}, audit_a[k].name);
}

}  // namespace anvil
