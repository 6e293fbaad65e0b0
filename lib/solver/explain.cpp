// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "anvil/solver/solver.hpp"

namespace anvil {

template <int D>
Explanation Solver<D>::explain() const {
  Explanation explanation;
  const auto add = [&](std::string_view name, std::string_view purpose) {
    explanation.terms.push_back({std::string(name), std::string(purpose)});
  };
  if (recipe_.corrected_gradients)
    add("gradient_correction",
        "makes gradients exact for linear fields; particles without enough neighbours keep plain ones");
  if (recipe_.face_ghosts) add("face_ghosts", "images behind the ends of the line, with the stress odd about the face");
  for (std::size_t k = 0; k < recipe_.loads.size(); ++k) add("pressure", "a pressure over time on a face");
  if (recipe_.images.possible())
    add("images", "copies of the particles near symmetry planes and the ends of periods, seen by every sum over pairs");
  for (const auto& force : recipe_.forces) add(force->name(), force->purpose());
  for (const auto& filter : recipe_.filters) add(filter->name(), filter->purpose());
  if (recipe_.transport)
    add("flux_corrected_transport", "spreads and gathers velocities, then stresses, along the line");
  if (recipe_.contact) add("contact", "bodies push each other where their faces meet, without friction");
  if (!recipe_.gravity.isZero(0.0)) add("gravity", "the same acceleration for all");
  for (const auto& wall : walls_)
    if (wall->interpolates())
      add("dummy_rows", "density, stress and velocity of the wall '" + wall->scene_name() + "', from those beside it");
  for (const auto& boundary : recipe_.boundaries) add(boundary->name(), boundary->purpose());
  if (recipe_.bulk_viscosity) add("bulk_viscosity", "pressure against the rate of compression");
  if (recipe_.deformation)
    add("deformation_gradient", "d x_a / d X_b and its rate from the pairs and corrected gradients of the start");
  else
    add("velocity_gradient", "d v_a / d x_b from velocity differences");
  if (recipe_.erosion) add("erosion", "stress points that are squeezed too far carry no stress any more");
  if (recipe_.density_diffusion > 0.0) add("density_diffusion", "exchanges density between neighbours");
  add("continuity", smoothing_length_varies_ ? "density and smoothing length follow the divergence"
                                             : "density follows the divergence");
  for (const auto& body : recipe_.bodies) {
    if (body.lateral_release)
      add("lateral_release", "lateral strain that leaves no lateral stress in body '" + body.name + "'");
    const std::string of_body = " of body '" + body.name + "'";
    if (body.strength->resists_shear()) add("strength", std::string(body.strength->law()) + of_body);
    add("equation_of_state", std::string(body.eos->law()) + of_body);
  }

  const auto doubles = [](int count) { return count * static_cast<int>(sizeof(double)); };
  for (const auto& field : fields_.fields())
    explanation.fields.push_back({std::string(field.key->name), std::string(field.key->unit), doubles(field.components),
                                  std::string(field.key->purpose)});
  const auto add_record = [&](const char* name, int size, const char* purpose) {
    explanation.fields.push_back({name, "", doubles(size), purpose});
  };
  add_record("geometry record", PairRecords<D>::small, "position and smoothing length, packed for the pair loops");
  add_record("motion record", PairRecords<D>::small, "velocity and volume, packed for the pair loops");
  if (recipe_.deformation) {
    add_record("nominal record", PairRecords<D>::nominal_size, "nominal stress and weight, packed for the pair loops");
    add_record("reference record", Deformation<D>::doubles_per_particle(),
               "gradient correction, rate, volume, density");
    add_record("frozen gradients",
               static_cast<int>(std::lround(static_cast<double>(D * frozen_gradient_[0].size()) /
                                            std::max(1.0, static_cast<double>(particle_count())))),
               "kernel gradients of the start, padding included");
  } else {
    add_record("traction record", PairRecords<D>::large, "stress and weight, packed for the pair loops");
  }
  if (recipe_.edges)
    add_record("edge stress points", static_cast<int>(std::lround(recipe_.edges->doubles_per_particle())),
               "ends, directions, stresses and histories of the edges");
  if (medium_needed_) add_record("medium record", 4, "sound speed, density and mass, packed for the pair loops");
  if (recipe_.force_needs.slope) add_record("slope record", SlopeField<D>::size, "slopes towards neighbours, packed");
  if (recipe_.force_needs.response)
    add_record("response record", 8, "wave speeds and yield, packed for the pair loops");

  explanation.particles = particle_count();
  for (const auto& field : explanation.fields) explanation.bytes_per_particle += field.bytes_per_particle;
  if (particle_count() > 0) {
    const auto particles = static_cast<double>(particle_count());
    explanation.neighbours_per_particle = static_cast<double>(count_pairs()) / particles;
    explanation.bytes_per_particle +=
        static_cast<int>(std::lround(static_cast<double>(neighbours_.bytes()) / particles));
    explanation.first_time_step = step_limit_;
    explanation.steps_expected = static_cast<std::int64_t>(std::ceil((scene_.time.end - time_) / step_limit_));
  }
  return explanation;
}

/// Ordered pairs whose distance is within the support of their kernel.
template <int D>
std::int64_t Solver<D>::count_pairs() const {
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < bodies_end(); ++i) {
    for (std::int64_t k = neighbours_.row_begin(i); k < neighbours_.row_end(i); ++k) {
      const auto j = static_cast<std::size_t>(neighbours_.neighbours()[k]);
      if (j >= particle_count()) continue;  // padding or images
      const double reach = 0.5 * recipe_.support * (smoothing_length_[i] + smoothing_length_[j]);
      if (recipe_.deformation || (position_[i] - position_[j]).squaredNorm() < reach * reach) ++pairs;
    }
  }
  return pairs;
}

template Explanation Solver<1>::explain() const;
template Explanation Solver<2>::explain() const;
template Explanation Solver<3>::explain() const;

}  // namespace anvil
