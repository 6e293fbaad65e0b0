// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string_view>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/solver/solver.hpp"

namespace anvil {
namespace {

FrameArray array_of(const FieldKey& key, int components, std::size_t particles) {
  return {std::string(key.name), std::string(key.unit), components, false,
          std::vector<double>(particles * static_cast<std::size_t>(components), 0.0)};
}

template <int D>
std::vector<double> padded(VectorView<D> vectors, std::size_t particles) {
  std::vector<double> values(3 * particles, 0.0);
  for (std::size_t i = 0; i < particles; ++i)
    for (std::size_t a = 0; a < D; ++a) values[3 * i + a] = vectors.raw()[D * i + a];
  return values;
}

bool is_listed(const Texts& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void write_six(const Tensor& tensor, double* out) { FullStrain::store(tensor, out); }

}  // namespace

template <int D>
Frame Solver<D>::frame() const {
  using StrainState = typename StrainStateOf<D>::Type;
  const std::size_t particles = fields_.particle_count();
  Frame frame;
  frame.scene = scene_.name;
  frame.time = time_;
  frame.step = step_;
  frame.dimension = D;
  frame.positions = padded(position_, particles);
  for (std::size_t i = 0; recipe_.images.wraps() && i < bodies_end(); ++i)
    Eigen::Map<Vec<D>>(&frame.positions[3 * i]) = recipe_.images.wrapped(position_[i]);

  FrameArray id{"particle_id", "", 1, true, std::vector<double>(particles)};
  FrameArray body{"body", "", 1, true, std::vector<double>(particles)};
  for (std::size_t i = 0; i < particles; ++i) id.values[i] = static_cast<double>(i);
  for (std::size_t b = 0; b < ranges_.size(); ++b)
    std::fill(body.values.begin() + ranges_[b].begin, body.values.begin() + ranges_[b].end, static_cast<double>(b));

  for (std::size_t w = 0; w < walls_.size(); ++w)
    std::fill(body.values.begin() + walls_[w]->range().begin, body.values.begin() + walls_[w]->range().end,
              static_cast<double>(ranges_.size() + w));

  FrameArray initial{"initial_position", "m", 3, false, padded(initial_position_, particles)};
  FrameArray velocity{"velocity", "m/s", 3, false, padded(velocity_, particles)};
  FrameArray density = array_of(field::density, 1, particles), pressure = array_of(field::pressure, 1, particles);
  FrameArray smoothing_length = array_of(field::smoothing_length, 1, particles);
  std::copy(density_.begin(), density_.end(), density.values.begin());
  std::copy(pressure_.begin(), pressure_.end(), pressure.values.begin());
  std::copy(smoothing_length_.begin(), smoothing_length_.end(), smoothing_length.values.begin());

  FrameArray stress{"stress", "Pa", 6, false, std::vector<double>(6 * particles)};
  FrameArray deviatoric = array_of(field::deviatoric_stress, 6, particles);
  // Stress points on edges are shown by their mean at each particle.
  const auto values_of = [&](const FieldKey& key) -> std::vector<double> {
    if (recipe_.edges && recipe_.edges->fields().has(key)) return recipe_.edges->mean_at_particles(key);
    for (const auto& field : fields_.fields())
      if (field.key->name == key.name) return field.values;
    return {};
  };
  const std::vector<double> deviators = values_of(field::deviatoric_stress);
  const double* stored = deviators.empty() ? nullptr : deviators.data();
  for (std::size_t i = 0; i < particles; ++i) {
    const Tensor deviator =
        stored == nullptr ? Tensor(Tensor::Zero()) : StrainState::deviator(stored + StrainState::components * i);
    write_six(deviator, &deviatoric.values[6 * i]);
    write_six(deviator - pressure_[i] * Tensor::Identity(), &stress.values[6 * i]);
  }
  frame.arrays = {std::move(id),      std::move(body),     std::move(initial), std::move(velocity),
                  std::move(density), std::move(pressure), std::move(stress),  std::move(smoothing_length)};
  for (const FieldKey* key : {&field::plastic_strain, &field::specific_energy, &field::eroded}) {
    // A part of a particle that is eroded is no smooth field.
    const bool on_edges = recipe_.edges && recipe_.edges->fields().has(*key) && key->name != field::eroded.name;
    std::vector<double> values = on_edges ? recipe_.edges->scalar_at_particles(*key) : values_of(*key);
    if (values.empty()) continue;
    FrameArray array = array_of(*key, 1, particles);
    array.values = std::move(values);
    frame.arrays.push_back(std::move(array));
  }
  const auto& omitted = scene_.output.omit;
  std::erase_if(frame.arrays, [&](const FrameArray& array) { return is_listed(omitted, array.name); });
  const auto& wanted = scene_.output.fields;
  if (is_listed(wanted, field::deviatoric_stress.name)) frame.arrays.push_back(std::move(deviatoric));
  if (is_listed(wanted, field::mass.name)) {
    FrameArray mass = array_of(field::mass, 1, particles);
    std::copy(mass_.begin(), mass_.end(), mass.values.begin());
    frame.arrays.push_back(std::move(mass));
  }
  for (const auto& field : fields_.fields()) {
    if (field.key->name != field::back_stress.name || !is_listed(wanted, field.key->name)) continue;
    FrameArray back_stress = array_of(field::back_stress, 6, particles);
    for (std::size_t i = 0; i < particles; ++i)
      write_six(StrainState::deviator(field.values.data() + StrainState::components * i), &back_stress.values[6 * i]);
    frame.arrays.push_back(std::move(back_stress));
  }
  return frame;
}

template Frame Solver<1>::frame() const;
template Frame Solver<2>::frame() const;
template Frame Solver<3>::frame() const;

}  // namespace anvil
