// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/wave_comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

/// A quantity of all particles beside the exact one, from left to right.
struct Profile {
  std::vector<double> position;  // m, initial
  std::vector<double> value;
  std::vector<double> exact;

  [[nodiscard]] std::size_t size() const { return position.size(); }
};

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

/// The value furthest from zero, with its sign.
double furthest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
}

const FrameArray& required_array(const Frame& frame, const char* name) {
  const FrameArray* array = frame.find(name);
  if (array == nullptr) throw InputError(fmt::format("the frame has no array '{}', which the comparison needs", name));
  return *array;
}

Profile make_profile(const Frame& frame, const char* name, double ExactPoint::*member, const SceneReference& reference,
                     std::size_t time) {
  const FrameArray& initial = required_array(frame, "initial_position");
  const FrameArray& array = required_array(frame, name);
  const auto stride = static_cast<std::size_t>(array.components);
  std::vector<std::size_t> order(frame.particle_count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return initial.values[3 * a] < initial.values[3 * b]; });
  Profile profile;
  for (const std::size_t i : order) {
    profile.position.push_back(initial.values[3 * i]);
    profile.value.push_back(array.values[stride * i]);
    profile.exact.push_back(reference.at(time, initial.values[3 * i]).*member);
  }
  return profile;
}

ComparedQuantity reported(const std::string& name, const std::string& unit, double value) {
  ComparedQuantity quantity;
  quantity.name = name;
  quantity.unit = unit;
  quantity.value = value;
  quantity.deviation = value;
  return quantity;
}

ComparedQuantity against(const std::string& name, double value, double exact) {
  ComparedQuantity quantity = reported(name, "Pa", value);
  quantity.reference = exact;
  quantity.deviation = (value - exact) / std::abs(exact);
  return quantity;
}

void add_norms(const std::string& name, const Profile& profile, std::vector<ComparedQuantity>& quantities) {
  double absolute = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double difference = profile.value[i] - profile.exact[i];
    absolute += std::abs(difference);
    square += difference * difference;
  }
  const auto count = static_cast<double>(profile.size());
  const double scale = largest(profile.exact);
  quantities.push_back(reported(name + "_l1", "", absolute / count / scale));
  quantities.push_back(reported(name + "_l2", "", std::sqrt(square / count) / scale));
}

double overshoot(const Profile& profile) {
  const auto [low, high] = std::minmax_element(profile.value.begin(), profile.value.end());
  const auto [exact_low, exact_high] = std::minmax_element(profile.exact.begin(), profile.exact.end());
  return std::max({0.0, *high - *exact_high, *exact_low - *low}) / largest(profile.exact);
}

/// Where the line of values crosses `level`, the place nearest to `near`; NaN when it does not.
double crossing_near(const Profile& profile, double level, double near) {
  double best = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const double before = profile.value[i - 1] - level;
    const double after = profile.value[i] - level;
    if ((before < 0.0) == (after < 0.0)) continue;
    const double place =
        profile.position[i - 1] + (profile.position[i] - profile.position[i - 1]) * before / (before - after);
    if (!(std::abs(place - near) >= std::abs(best - near))) best = place;
  }
  return best;
}

/// In m. A front of the exact solution may fall on a few particles when it spreads; its ends are where it stops to
/// change by a twentieth of its steepest step.
double rise_width(const Profile& profile) {
  const auto step = [&](std::size_t i) { return profile.exact[i + 1] - profile.exact[i]; };
  std::size_t steepest = 0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    if (std::abs(step(i)) > std::abs(step(steepest))) steepest = i;
  std::size_t first = steepest;
  std::size_t last = steepest + 1;
  while (first > 0 && std::abs(step(first - 1)) > 0.05 * std::abs(step(steepest))) --first;
  while (last + 1 < profile.size() && std::abs(step(last)) > 0.05 * std::abs(step(steepest))) ++last;
  const double foot = profile.exact[first];
  const double jump = profile.exact[last] - foot;
  const double middle = 0.5 * (profile.position[steepest] + profile.position[steepest + 1]);
  return std::abs(crossing_near(profile, foot + 0.9 * jump, middle) -
                  crossing_near(profile, foot + 0.1 * jump, middle));
}

void add_plateaus(const Profile& profile, std::vector<ComparedQuantity>& quantities) {
  constexpr std::size_t shortest = 20;  // particles
  constexpr double constant = 1e-3;     // of the peak
  const double tolerance = constant * largest(profile.exact);
  double worst = 0.0;
  int number = 0;
  for (std::size_t begin = 0, end = 0; begin < profile.size(); begin = end) {
    end = begin + 1;
    while (end < profile.size() && std::abs(profile.exact[end] - profile.exact[begin]) <= tolerance) ++end;
    if (end - begin < shortest || std::abs(profile.exact[begin]) <= tolerance) continue;
    const std::size_t quarter = (end - begin) / 4;
    const auto mean = [&](const std::vector<double>& values) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(begin + quarter);
      const auto to = values.begin() + static_cast<std::ptrdiff_t>(end - quarter);
      return std::accumulate(from, to, 0.0) / static_cast<double>(to - from);
    };
    quantities.push_back(against(fmt::format("plateau_{}", ++number), mean(profile.value), mean(profile.exact)));
    worst = std::max(worst, std::abs(quantities.back().deviation));
  }
  if (number > 0) quantities.push_back(reported("plateau_error", "", worst));
}

}  // namespace

std::vector<ComparedQuantity> compare_waves(const Frame& frame, const SceneReference& reference, std::size_t time,
                                            double spacing) {
  const Profile stress = make_profile(frame, "stress", &ExactPoint::stress, reference, time);
  const Profile velocity = make_profile(frame, "velocity", &ExactPoint::velocity, reference, time);
  if (stress.size() < 2 || largest(stress.exact) == 0.0 || largest(velocity.exact) == 0.0)
    throw InputError(
        fmt::format("there is nothing to compare at {:.6g} s: the exact solution has no wave", frame.time));
  std::vector<ComparedQuantity> quantities;
  add_norms("stress", stress, quantities);
  add_norms("velocity", velocity, quantities);
  quantities.push_back(against("peak_stress", furthest(stress.value), furthest(stress.exact)));
  quantities.push_back(reported("stress_overshoot", "", overshoot(stress)));
  quantities.push_back(reported("rise_width", "spacing", rise_width(stress) / spacing));
  add_plateaus(stress, quantities);
  for (auto& quantity : quantities) quantity.time = frame.time;
  return quantities;
}

}  // namespace anvil
