// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/wave_fan.hpp"

#include <algorithm>
#include <cmath>

#include "anvil/exact/increasing_root.hpp"

namespace anvil {
namespace {

// Of the largest part of the stress: a few units of round-off, below which no root can be told from its neighbours.
constexpr double round_off = 4e-15;

/// The parts a stress is the difference of; both may be far larger than it.
double largest_part(const WaveState& state) { return std::abs(state.deviator) + std::abs(state.pressure()); }

/// The front that takes `ahead` to `stress`, without the speed of the material.
WaveFan::Front front_to(const WaveMaterial& material, const WaveState& ahead, double stress) {
  const double modulus = material.elastic_modulus();
  const double tolerance = round_off * (std::abs(stress) + largest_part(ahead));
  // Expansion towards zero density and compression beyond it have no state: infinite stress keeps the root away.
  const auto excess = [&](double strain) {
    if (strain <= -1.0) return -std::numeric_limits<double>::infinity();
    return material.behind_front(ahead, strain).stress - stress;
  };
  const double strain =
      find_increasing_root(excess, ahead.strain + (stress - ahead.stress) / modulus, modulus, tolerance);
  WaveFan::Front front{0.0, material.behind_front(ahead, strain)};
  const double change = strain - ahead.strain;
  front.speed = std::sqrt((front.behind.stress - ahead.stress) / (change * material.density()));
  return front;
}

class FanBuilder {
 public:
  FanBuilder(const WaveMaterial& material, const WaveState& ahead, Direction direction,
             const WaveResolution& resolution, WaveFan& fan)
      : material_(material), ahead_(ahead), direction_(direction), resolution_(resolution), fan_(fan) {
    fan_.fronts.clear();
  }

  void build(double stress) {
    const double sense = stress > ahead_.stress ? 1.0 : -1.0;
    const double yield_strain = material_.yield_strain(ahead_, sense);
    const bool can_yield = std::isfinite(yield_strain) && yield_strain > -1.0;
    const double yield_stress = can_yield ? material_.behind_front(ahead_, yield_strain).stress : 0.0;
    const bool two_waves = can_yield && sense * (yield_stress - ahead_.stress) > resolution_.smallest &&
                           sense * (stress - yield_stress) > resolution_.smallest;
    if (two_waves) add_wave(yield_stress);
    add_wave(stress);
    const bool caught = two_waves && sense < 0.0 && fan_.fronts.back().speed >= fan_.fronts.front().speed;
    if (caught) {
      fan_.fronts.clear();
      add_front(stress);
    }
  }

 private:
  void add_wave(double stress) {
    const double change = stress - fan_.end(ahead_).stress;
    const bool spreads = !material_.is_linear() && change > 0.0 && resolution_.step > 0.0;
    // Half a step of slack: fronts of a fan that other waves have changed a little are not cut again.
    const int count = spreads ? std::max(1, static_cast<int>(std::ceil(change / resolution_.step - 0.5))) : 1;
    const double start = stress - change;
    for (int i = 1; i < count; ++i) add_front(start + change * i / count);
    add_front(stress);
  }

  void add_front(double stress) {
    const WaveState& ahead = fan_.end(ahead_);
    if (stress == ahead.stress) return;
    WaveFan::Front front = front_to(material_, ahead, stress);
    if (!(front.speed > 0.0 && std::isfinite(front.speed))) return;  // a jump of round-off
    front.behind.velocity = ahead.velocity - static_cast<double>(direction_) * (front.behind.stress - ahead.stress) /
                                                 (material_.density() * front.speed);
    fan_.fronts.push_back(front);
  }

  const WaveMaterial& material_;
  const WaveState& ahead_;
  Direction direction_;
  const WaveResolution& resolution_;
  WaveFan& fan_;
};

double impedance(const WaveMaterial& material) { return material.density() * material.elastic_wave_speed(); }

}  // namespace

void fill_fan(const WaveMaterial& material, const WaveState& ahead, double stress, Direction direction,
              const WaveResolution& resolution, WaveFan& fan) {
  FanBuilder(material, ahead, direction, resolution, fan).build(stress);
}

void solve_contact(const WaveMaterial& left_material, const WaveState& left, const WaveMaterial& right_material,
                   const WaveState& right, const WaveResolution& resolution, ContactSolution& solution) {
  const double left_impedance = impedance(left_material);
  const double right_impedance = impedance(right_material);
  const double common = left_impedance * right_impedance / (left_impedance + right_impedance);
  const double guess =
      (right_impedance * left.stress + left_impedance * right.stress) / (left_impedance + right_impedance) +
      common * (right.velocity - left.velocity);
  // In units of stress, so that the elastic slope is one.
  const auto mismatch = [&](double stress) {
    fill_fan(left_material, left, stress, Direction::left, resolution, solution.left_fan);
    fill_fan(right_material, right, stress, Direction::right, resolution, solution.right_fan);
    return common * (solution.left_fan.end(left).velocity - solution.right_fan.end(right).velocity);
  };
  const double scale = largest_part(left) + largest_part(right) + std::abs(guess) +
                       common * (std::abs(left.velocity) + std::abs(right.velocity));
  solution.stress = find_increasing_root(mismatch, guess, 1.0, round_off * scale);
  mismatch(solution.stress);
}

void fill_fan_from_rigid_face(const WaveMaterial& material, const WaveState& ahead, Direction direction,
                              const WaveResolution& resolution, WaveFan& fan) {
  // A right-going wave lowers the velocity when it raises the stress.
  const double sign = direction == Direction::left ? 1.0 : -1.0;
  const double elastic = impedance(material);
  const auto motion = [&](double stress) {
    fill_fan(material, ahead, stress, direction, resolution, fan);
    return sign * elastic * fan.end(ahead).velocity;
  };
  const double guess = ahead.stress - sign * elastic * ahead.velocity;
  const double scale = largest_part(ahead) + elastic * std::abs(ahead.velocity);
  motion(find_increasing_root(motion, guess, 1.0, round_off * scale));
}

}  // namespace anvil
