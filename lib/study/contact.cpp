// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/contact.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

const std::vector<double>& values_of(const Frame& frame, const std::string& name) {
  const FrameArray* array = frame.find(name);
  if (array == nullptr) throw InputError("the frames have no array '" + name + "'");
  return array->values;
}

}  // namespace

double contact_oscillation(const StudySample& sample, std::string_view name) {
  constexpr std::size_t reach = 10;  // particles on either side
  const Frame& frame = sample.frames[sample.number];
  const auto &initial = values_of(frame, "initial_position"), &bodies = values_of(frame, "body");
  const auto &pressure = values_of(frame, "pressure"), &stress = values_of(frame, "stress");
  std::vector<std::size_t> order(frame.particle_count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return initial[3 * a] < initial[3 * b]; });
  std::size_t contact = 1;
  while (contact < order.size() && bodies[order[contact]] == bodies[order[contact - 1]]) ++contact;
  if (contact < reach || contact + reach > order.size()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> differences;
  for (std::size_t k = contact - reach; k < contact + reach; ++k) {
    const std::size_t i = order[k];
    const ExactPoint exact = sample.exact().at(sample.number, initial[3 * i]);
    differences.push_back(name == "contact_pressure_oscillation" ? pressure[i] - exact.pressure
                                                                 : stress[6 * i] + pressure[i] - exact.deviator);
  }
  const auto [least, greatest] = std::minmax_element(differences.begin(), differences.end());
  return *greatest - *least;
}

}  // namespace anvil
