// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>

#include "anvil/core/inline.hpp"
#include "anvil/core/tensor.hpp"
#include "anvil/scene/key.hpp"

namespace anvil {

/// What a strength law remembers of one particle. Fields a law does not use stay as they are.
struct StrengthHistory {
  double plastic_strain = 0.0;          // accumulated equivalent plastic strain
  Tensor back_stress = Tensor::Zero();  // Pa, centre of the yield surface, a deviator
  double plastic_work = 0.0;            // J per m3 of present volume, accumulated
};

/// What one return to the yield surface did; zero in an elastic step.
struct PlasticStep {
  double plastic_strain_increment = 0.0;
  double plastic_work = 0.0;  // J per m3 of present volume
};

/// What a strength law offers; it is made from its keys and knows nothing of the dimension: deviators are full tensors.
///
/// return_to_yield takes the elastic trial deviator in Pa and brings it back where it lies outside the yield surface,
/// updating the history. The work is that of the mean flow stress of the step over the plastic strain increment: the
/// stress is averaged between the yield surfaces before and after, which is exact for proportional loading of a
/// linearly hardening law.
template <class S>
concept StrengthLaw = std::constructible_from<S, const Parameters&> &&
    requires(const S& law, Tensor& deviator, StrengthHistory& history) {
  { S::kind() } -> std::same_as<EntryKind>;
  { S::resists_shear } -> std::convertible_to<bool>;
  { S::has_plastic_strain } -> std::convertible_to<bool>;
  { law.has_back_stress() } -> std::same_as<bool>;
  { law.shear_modulus() } -> std::same_as<double>;
  { law.return_to_yield(deviator, history) } -> std::same_as<PlasticStep>;
};

/// A law whose yield depends on the pressure, or that changes it, also offers
/// `PlasticStep limit(Tensor& deviator, double& pressure, double& dilation, double bulk_modulus, StrengthHistory&)`,
/// called when the equation of state has given the pressure of the new density, and `bool dilates()`: whether the
/// plastic volume strain `dilation` must be kept.
template <class S>
concept LimitsPressure = requires {
  requires S::limits_pressure;
};

/// 3/2 t : t of a symmetric deviator, the square of its equivalent (von Mises) stress.
ANVIL_INLINE double equivalent_stress_squared(const Tensor& deviator) {
  return 1.5 * (deviator(0, 0) * deviator(0, 0) + deviator(1, 1) * deviator(1, 1) + deviator(2, 2) * deviator(2, 2)) +
         3.0 * (deviator(0, 1) * deviator(0, 1) + deviator(0, 2) * deviator(0, 2) + deviator(1, 2) * deviator(1, 2));
}

}  // namespace anvil
