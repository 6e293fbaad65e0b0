// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/flow_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/exact/poiseuille.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {
namespace {

double audited_or(const StudySample& sample, std::string_view name, double otherwise) {
  for (const auto& value : sample.audit)
    if (value.name == name) return value.value;
  return otherwise;
}

}  // namespace

double quantile_of_bodies(const Frame& frame, const Scene& scene, int axis) {
  const FrameArray* body = frame.find("body");
  std::vector<double> places;
  for (std::size_t i = 0; i < body->values.size(); ++i)
    if (body->values[i] < static_cast<double>(scene.bodies.size()))
      places.push_back(frame.positions[3 * i + static_cast<std::size_t>(axis)]);
  if (places.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<long>(0.995 * static_cast<double>(places.size() - 1));
  std::nth_element(places.begin(), places.begin() + rank, places.end());
  return places[static_cast<std::size_t>(rank)] + 0.5 * scene.discretisation.spacing;
}

double front(const StudySample& sample, std::string_view) {
  return quantile_of_bodies(sample.frames[sample.number], sample.scene, 0);
}

double height(const StudySample& sample, std::string_view) {
  return quantile_of_bodies(sample.frames[sample.number], sample.scene, sample.scene.domain.dimension - 1);
}

double fastest_speed(const StudySample& sample, std::string_view) {
  const auto& velocity = sample.frames[sample.number].find("velocity")->values;
  double fastest = 0.0;
  for (std::size_t i = 0; i < velocity.size(); i += 3)
    fastest = std::max(fastest, std::hypot(velocity[i], velocity[i + 1], velocity[i + 2]));
  return fastest;
}

double audited(const StudySample& sample, std::string_view name) {
  return audited_or(sample, name, std::numeric_limits<double>::quiet_NaN());
}

double energy_growth(const StudySample& sample, std::string_view) {
  const double potential = audited_or(sample, "potential_energy", 0.0);
  const double mechanical = audited(sample, "kinetic_energy") + audited(sample, "elastic_energy") + potential +
                            audited_or(sample, "wall_stored_energy", 0.0);
  // The account starts from the whole energy, and says by how much it does not close.
  const double start = audited(sample, "total_energy") - audited(sample, "energy_error") -
                       audited_or(sample, "wall_work", 0.0) - audited_or(sample, "pressure_work", 0.0);
  return (mechanical - start) / std::max(std::abs(start), std::abs(potential));
}

double poiseuille_error(const StudySample& sample, std::string_view) {
  const Scene& scene = sample.scene;
  const Frame& frame = sample.frames[sample.number];
  const auto shape = make_shape<2>(scene.bodies.front().shape);
  const MaterialDescription& fluid = scene.materials.front();
  const PoiseuilleFlow flow{scene.domain.gravity[0], fluid.viscosity / fluid.density, shape->size()[1]};
  const double time = frame.time - 0.5 * sample.last_time_step;
  const auto &body = frame.find("body")->values, &velocity = frame.find("velocity")->values;
  double largest = 0.0;
  for (std::size_t i = 0; i < body.size(); ++i)
    if (body[i] == 0.0)
      largest = std::max(largest, std::abs(velocity[3 * i] - flow.velocity(frame.positions[3 * i + 1], time)));
  return largest / flow.velocity(0.5 * flow.width, time);
}

double step_cost(const StudySample& sample, std::string_view) { return 1e6 * sample.step_cost; }

}  // namespace anvil
