// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/materials/material_update.hpp"

#include <limits>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/materials/stress_update.hpp"
#include "anvil/points/point_loops.hpp"

namespace anvil {
namespace {

template <int D, class Law>
class StrengthAtWork final : public StrengthUpdate<D> {
  using StrainState = typename StrainStateOf<D>::Type;
  static constexpr std::size_t components = StrainState::components;

 public:
  StrengthAtWork(const Law& law, FieldStore& fields) : law_(law) {
    fields.require(field::mass);
    fields.require(field::density);
    mass_ = fields.scalar(field::mass);
    density_ = fields.scalar(field::density);
    if constexpr (Law::resists_shear) {
      fields.require(field::deviatoric_stress, StrainState::components);
      deviator_ = fields.vector<StrainState::components>(field::deviatoric_stress).raw();
    }
    if constexpr (Law::has_plastic_strain) {
      fields.require(field::plastic_strain);
      plastic_strain_ = fields.scalar(field::plastic_strain).data();
    }
    if constexpr (LimitsPressure<Law>) {
      fields.require(field::pressure);
      pressure_ = fields.scalar(field::pressure).data();
      if (law.dilates()) {
        fields.require(field::plastic_dilation);
        dilation_ = fields.scalar(field::plastic_dilation).data();
      }
    }
    if (law.has_back_stress()) {
      fields.require(field::back_stress, StrainState::components);
      back_stress_ = fields.vector<StrainState::components>(field::back_stress).raw();
    }
  }

  double update(ParticleRange range, const double* velocity_gradient, [[maybe_unused]] const double* lateral_rate,
                double time_step) const override {
    if constexpr (!Law::resists_shear) return 0.0;
    if constexpr (D == 1)
      return return_to_yield(range, [&](Tensor& deviator) {
        Tensor gradient = lift_gradient<D>(velocity_gradient++);
        if (lateral_rate != nullptr) gradient(1, 1) = gradient(2, 2) = *lateral_rate++;
        stretch(law_.shear_modulus(), gradient, time_step, deviator);
      });
    const PointLoops<D>& loops = point_loops<D>();
    loops.strain_deviators(range.count(), velocity_gradient, law_.shear_modulus(), time_step,
                           deviator_ + components * range.first());
    if (back_stress_ != nullptr)
      loops.turn_tensors(range.count(), velocity_gradient, time_step, back_stress_ + components * range.first());
    return return_to_yield(range, [](Tensor&) {});
  }

  double limit([[maybe_unused]] ParticleRange range,
               [[maybe_unused]] const double* bulk_sound_speed_squared) const override {
    double work = 0.0;
    if constexpr (LimitsPressure<Law>) {
      for (std::size_t i = range.first(); i < range.last(); ++i) {
        StrengthHistory history;
        history.plastic_strain = plastic_strain_[i];
        double dilation = dilation_ == nullptr ? 0.0 : dilation_[i];
        const double bulk_modulus = density_[i] * *bulk_sound_speed_squared++;
        Tensor deviator = StrainState::deviator(deviator_ + components * i);
        pressure_[i] += bulk_modulus * dilation;
        const PlasticStep step = law_.limit(deviator, pressure_[i], dilation, bulk_modulus, history);
        StrainState::store(deviator, deviator_ + components * i);
        plastic_strain_[i] = history.plastic_strain;
        if (dilation_ != nullptr) dilation_[i] = dilation;
        work += step.plastic_work * mass_[i] / density_[i];
      }
    }
    return work;
  }

  [[nodiscard]] bool limits_pressure() const override { return LimitsPressure<Law>; }
  [[nodiscard]] std::string_view law() const override { return name_; }
  [[nodiscard]] bool resists_shear() const override { return Law::resists_shear; }
  [[nodiscard]] double shear_modulus() const override { return law_.shear_modulus(); }
  [[nodiscard]] double yield_stress(std::size_t particle) const override {
    if constexpr (requires { law_.yield_stress(0.0); }) return law_.yield_stress(plastic_strain_[particle]);
    return Law::resists_shear ? std::numeric_limits<double>::infinity() : 0.0;
  }

  [[nodiscard]] double elastic_energy(ParticleRange range) const override {
    double energy = 0.0;
    if constexpr (Law::resists_shear) {
      for (std::size_t i = range.first(); i < range.last(); ++i)
        energy += StrainState::deviator(deviator_ + components * i).squaredNorm() / (4.0 * law_.shear_modulus()) *
                  mass_[i] / density_[i];
    }
    return energy;
  }

 private:
  /// With the trial deviator that strain(deviator) makes of the stored one.
  template <class Strain>
  double return_to_yield(ParticleRange range, Strain&& strain) const {
    double work = 0.0;
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      StrengthHistory history;
      if constexpr (Law::has_plastic_strain) history.plastic_strain = plastic_strain_[i];
      if (back_stress_ != nullptr) history.back_stress = StrainState::deviator(back_stress_ + components * i);
      Tensor deviator = StrainState::deviator(deviator_ + components * i);
      strain(deviator);
      const PlasticStep step = law_.return_to_yield(deviator, history);
      StrainState::store(deviator, deviator_ + components * i);
      if constexpr (Law::has_plastic_strain) plastic_strain_[i] = history.plastic_strain;
      if (back_stress_ != nullptr) StrainState::store(history.back_stress, back_stress_ + components * i);
      if (step.plastic_work != 0.0) work += step.plastic_work * mass_[i] / density_[i];
    }
    return work;
  }

  Law law_;
  std::string_view name_ = Law::kind().type;
  std::span<const double> mass_, density_;
  double* deviator_ = nullptr;
  double* plastic_strain_ = nullptr;
  double* back_stress_ = nullptr;
  double* pressure_ = nullptr;
  double* dilation_ = nullptr;
};

/// s : L of a packed deviator and a velocity gradient, W/m3.
template <int D>
double shear_power(const double* s, const double* gradient) {
  double power = 0.0;
  for (int a = 0; a < D; ++a) power += s[a] * gradient[a * (D + 1)];
  if constexpr (D == 2) power += s[2] * (gradient[1] + gradient[2]);
  if constexpr (D == 3)
    power +=
        s[3] * (gradient[1] + gradient[3]) + s[4] * (gradient[5] + gradient[7]) + s[5] * (gradient[2] + gradient[6]);
  return power;
}

template <int D>
double trace(const double* gradient) {
  double sum = 0.0;
  for (int a = 0; a < D; ++a) sum += gradient[a * (D + 1)];
  return sum;
}

template <int D, class Law>
class EosAtWork final : public EosUpdate<D> {
 public:
  EosAtWork(const Law& law, FieldStore& fields)
      : law_(law),
        mass_((fields.require(field::mass), fields.scalar(field::mass))),
        density_((fields.require(field::density), fields.scalar(field::density))),
        pressure_((fields.require(field::pressure), fields.scalar(field::pressure))) {
    if constexpr (Law::uses_energy) fields.require(field::specific_energy);
    if (fields.has(field::specific_energy)) energy_ = fields.scalar(field::specific_energy).data();
    if (fields.has(field::deviatoric_stress)) deviator_ = fields.vector<components>(field::deviatoric_stress).raw();
  }

  void update(ParticleRange range, double* bulk_sound_speed_squared) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      const double energy = Law::uses_energy ? energy_[i] : 0.0;
      pressure_[i] = law_.pressure(density_[i], energy);
      *bulk_sound_speed_squared++ = law_.bulk_sound_speed_squared(density_[i], energy);
    }
  }

  void add_work_before(ParticleRange range, const double* velocity_gradient, double time_step) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i, velocity_gradient += D * D)
      energy_[i] += 0.5 * time_step / density_[i] *
                    (shear_power_of(i, velocity_gradient) - pressure_[i] * trace<D>(velocity_gradient));
  }

  void add_work_after(ParticleRange range, const double* velocity_gradient, double time_step) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i, velocity_gradient += D * D) {
      const double weight = 0.5 * time_step / density_[i];
      const double expansion = weight * trace<D>(velocity_gradient);  // m3/kg
      const double energy = energy_[i] + weight * shear_power_of(i, velocity_gradient);
      double pressure = law_.pressure(density_[i], energy);
      // The energy this pressure takes lowers it: one Newton step, exact for a law that is linear in the energy.
      if constexpr (HasEnergyDerivative<Law>) pressure /= 1.0 + law_.energy_derivative(density_[i], energy) * expansion;
      energy_[i] = energy - pressure * expansion;
    }
  }

  [[nodiscard]] std::string_view law() const override { return name_; }

  [[nodiscard]] double energy_of_pressure(ParticleRange range) const override {
    double energy = 0.0;
    for (std::size_t i = range.first(); i < range.last(); ++i)
      energy += 0.5 * pressure_[i] * pressure_[i] * mass_[i] /
                (density_[i] * density_[i] * law_.bulk_sound_speed_squared(density_[i], 0.0));
    return energy;
  }

  [[nodiscard]] double elastic_energy(ParticleRange range) const override {
    double energy = 0.0;
    if constexpr (HasColdEnergy<Law>)
      for (std::size_t i = range.first(); i < range.last(); ++i) energy += mass_[i] * law_.cold_energy(density_[i]);
    return energy;
  }

 private:
  static constexpr std::size_t components = StrainStateOf<D>::Type::components;
  [[nodiscard]] double shear_power_of(std::size_t i, const double* velocity_gradient) const {
    return deviator_ == nullptr ? 0.0 : shear_power<D>(deviator_ + components * i, velocity_gradient);
  }

  Law law_;
  std::string_view name_ = Law::kind().type;
  std::span<const double> mass_, density_;
  std::span<double> pressure_;
  double* energy_ = nullptr;
  const double* deviator_ = nullptr;
};

}  // namespace

template <int D>
std::unique_ptr<StrengthUpdate<D>> make_strength_update(const Strength& law, FieldStore& fields) {
  return std::visit(
      [&]<class Law>(const Law& chosen) -> std::unique_ptr<StrengthUpdate<D>> {
        return std::make_unique<StrengthAtWork<D, Law>>(chosen, fields);
      },
      law);
}

template <int D>
std::unique_ptr<EosUpdate<D>> make_eos_update(const Eos& law, FieldStore& fields) {
  return std::visit(
      [&]<class Law>(const Law& chosen) -> std::unique_ptr<EosUpdate<D>> {
        return std::make_unique<EosAtWork<D, Law>>(chosen, fields);
      },
      law);
}

template std::unique_ptr<StrengthUpdate<1>> make_strength_update<1>(const Strength&, FieldStore&);
template std::unique_ptr<StrengthUpdate<2>> make_strength_update<2>(const Strength&, FieldStore&);
template std::unique_ptr<StrengthUpdate<3>> make_strength_update<3>(const Strength&, FieldStore&);
template std::unique_ptr<EosUpdate<1>> make_eos_update<1>(const Eos&, FieldStore&);
template std::unique_ptr<EosUpdate<2>> make_eos_update<2>(const Eos&, FieldStore&);
template std::unique_ptr<EosUpdate<3>> make_eos_update<3>(const Eos&, FieldStore&);

}  // namespace anvil
