// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/materials/lateral_release.hpp"

#include <cmath>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/materials/stress_update.hpp"

namespace anvil {
namespace {

template <class StrengthLawType, class EosType>
class LateralReleaseOf final : public LateralRelease {
 public:
  LateralReleaseOf(const StrengthLawType& strength, const EosType& eos, FieldStore& fields)
      : strength_(strength), eos_(eos), density_(fields.scalar(field::density)) {
    const auto values_of = [&](const FieldKey& key) -> const double* {
      return fields.has(key) ? fields.scalar(key).data() : nullptr;
    };
    if constexpr (StrengthLawType::resists_shear) deviator_ = values_of(field::deviatoric_stress);
    if constexpr (StrengthLawType::has_plastic_strain) plastic_strain_ = values_of(field::plastic_strain);
    if (strength.has_back_stress()) back_stress_ = values_of(field::back_stress);
  }

  /// A secant iteration on the lateral stress, which rises with the lateral strain. It starts from the elastic slope,
  /// 2 K + 2 G / 3, which is exact but for the curvature of the equation of state while nothing yields; yielding lowers
  /// the slope by G / 3 of that at most, so that a few steps suffice.
  void find_rates(ParticleRange range, const double* axial_rate, double time_step,
                  double* lateral_rate) const override {
    constexpr double accuracy = 1e-14;  // strain: far below the rounding of the sum of all steps
    constexpr int most_iterations = 30;
    for (std::size_t i = range.first(); i < range.last(); ++i, ++axial_rate, ++lateral_rate) {
      const double bulk = density_[i] * eos_.bulk_sound_speed_squared(density_[i], 0.0);
      const double elastic_slope = 2.0 * bulk + 2.0 / 3.0 * strength_.shear_modulus();
      double slope = elastic_slope, strain = 0.0, stress = lateral_stress(i, *axial_rate, strain, time_step);
      for (int k = 0; k < most_iterations && std::abs(stress) > accuracy * elastic_slope; ++k) {
        const double change = -stress / slope;
        const double next = lateral_stress(i, *axial_rate, strain + change, time_step);
        const double secant = (next - stress) / change;
        if (secant > 0.5 * bulk && secant < 2.0 * elastic_slope) slope = secant;
        strain += change;
        stress = next;
      }
      *lateral_rate = strain / time_step;
    }
  }

 private:
  /// Lateral stress (Pa) after a step of the lateral strain `strain`.
  [[nodiscard]] double lateral_stress(std::size_t i, double axial_rate, double strain, double time_step) const {
    const double lateral_rate = strain / time_step;
    StrengthHistory history;
    if constexpr (StrengthLawType::has_plastic_strain) history.plastic_strain = plastic_strain_[i];
    if (back_stress_ != nullptr) history.back_stress = UniaxialStrain::deviator(back_stress_ + i);
    Tensor deviator = Tensor::Zero();
    if (deviator_ != nullptr) deviator = UniaxialStrain::deviator(deviator_ + i);
    Tensor gradient = Tensor::Zero();
    gradient(0, 0) = axial_rate;
    gradient(1, 1) = gradient(2, 2) = lateral_rate;
    (void)update_deviator<false>(strength_, deviator, history, gradient, time_step);
    const double half = 0.5 * time_step * (axial_rate + 2.0 * lateral_rate);
    return deviator(1, 1) - eos_.pressure(density_[i] * (1.0 - half) / (1.0 + half), 0.0);
  }

  StrengthLawType strength_;
  EosType eos_;
  std::span<const double> density_;
  const double* deviator_ = nullptr;
  const double* plastic_strain_ = nullptr;
  const double* back_stress_ = nullptr;
};

}  // namespace

std::unique_ptr<LateralRelease> make_lateral_release(const Strength& strength, const Eos& eos, FieldStore& fields) {
  return std::visit(
      [&]<class S, class E>(const S& law, const E& pressure_law) -> std::unique_ptr<LateralRelease> {
        return std::make_unique<LateralReleaseOf<S, E>>(law, pressure_law, fields);
      },
      strength, eos);
}

}  // namespace anvil
