// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/profile.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/measures/frame_fields.hpp"
#include "anvil/measures/particle_interpolation.hpp"
#include "anvil/measures/sample_places.hpp"

namespace anvil {
namespace {

/// The particles to draw, in the order of x.
std::vector<std::size_t> chosen_particles(const Frame& frame, const std::vector<double>& x, const std::string& where) {
  std::vector<std::size_t> chosen;
  const std::vector<double> condition = where.empty() ? std::vector<double>{} : field_of(frame, where).values;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (condition.empty() || condition[i] != 0.0) chosen.push_back(i);
  if (chosen.empty()) throw InputError(fmt::format("no particle is left where '{}'", where));
  std::stable_sort(chosen.begin(), chosen.end(), [&](auto a, auto b) { return x[a] < x[b]; });
  return chosen;
}

}  // namespace

Profile profile_of_particles(const Frame& frame, const std::string& along, const std::string& field,
                             const std::string& where) {
  const Evaluated x = field_of(frame, along);
  const Evaluated y = field_of(frame, field);
  Profile profile{{{}, x.unit}, {{}, y.unit}, frame.dimension > 1};
  for (const std::size_t i : chosen_particles(frame, x.values, where)) {
    profile.x.values.push_back(x.values[i]);
    profile.y.values.push_back(y.values[i]);
  }
  return profile;
}

Profile profile_on_line(const Frame& frame, const std::string& field, const std::vector<double>& ends) {
  constexpr int points = 501;
  const SampleGrid line = make_sample_line({ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]}, points);
  const Evaluated values = field_of(frame, field);
  const ParticleInterpolation interpolation(frame, {});
  auto sampled = interpolation.at(points_of(line), std::array{values.values});
  Profile profile{{{}, "m"}, {std::move(sampled.values.front()), values.unit}, false};
  const auto& y = profile.y.values;
  if (std::none_of(y.begin(), y.end(), [](double value) { return std::isfinite(value); }))
    throw InputError(fmt::format("the line ({}, {}, {}) to ({}, {}, {}) m meets no particles", ends[0], ends[1],
                                 ends[2], ends[3], ends[4], ends[5]));
  for (int i = 0; i < points; ++i) profile.x.values.push_back(i * line.step[0]);
  return profile;
}

}  // namespace anvil
