// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <variant>

#include "anvil/core/error.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {

/// One particle on a spring with steps of changing length: as sensitive to the order of operations as a real run, and
/// quick. Its bits depend on every step taken before.
class FakeSimulation : public Simulation {
 public:
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double last_time_step() const override { return time_step_; }
  [[nodiscard]] std::int64_t step() const override { return step_; }
  [[nodiscard]] std::size_t particle_count() const override { return 1; }

  void advance(double latest) override {
    if (time_ >= fails_at) throw NumericalError("density of particle 0 is negative");
    const double step = 0.0123 * (1.5 + std::sin(static_cast<double>(step_)));
    const bool last = latest - time_ <= step;
    time_step_ = last ? latest - time_ : step;
    velocity_ -= time_step_ * position_;
    position_ += time_step_ * velocity_;
    time_ = last ? latest : time_ + time_step_;
    ++step_;
    after_step(step_);
  }

  [[nodiscard]] Frame frame() const override {
    Frame frame;
    frame.time = time_;
    frame.step = step_;
    frame.positions = {position_, 0.0, 0.0};
    frame.arrays = {{"velocity", "m/s", 3, false, {velocity_, 0.0, 0.0}}};
    return frame;
  }
  [[nodiscard]] std::vector<AuditValue> audit() const override {
    return {{"momentum_x", "N s", velocity_}, {"kinetic_energy", "J", 0.5 * velocity_ * velocity_}};
  }
  [[nodiscard]] Explanation explain() const override { return {}; }
  [[nodiscard]] State state() const override {
    return {{"field/motion", {1, std::vector<double>{position_, velocity_}}},
            {"clock", {1, std::vector<double>{time_, time_step_}}},
            {"counts", {1, std::vector<std::int64_t>{step_}}}};
  }
  void restore(const State& state) override {
    const auto& motion = std::get<std::vector<double>>(state.at("field/motion").values);
    const auto& clock = std::get<std::vector<double>>(state.at("clock").values);
    position_ = motion[0];
    velocity_ = motion[1];
    time_ = clock[0];
    time_step_ = clock[1];
    step_ = std::get<std::vector<std::int64_t>>(state.at("counts").values)[0];
  }

  double fails_at = std::numeric_limits<double>::infinity();
  std::function<void(std::int64_t)> after_step = [](std::int64_t) {};

 private:
  double time_ = 0.0;
  double time_step_ = 0.0;
  double position_ = 1.0;
  double velocity_ = 0.0;
  std::int64_t step_ = 0;
};

}  // namespace anvil
