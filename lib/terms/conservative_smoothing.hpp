// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/velocity_filter.hpp"

namespace anvil {

/// The forms of conservative smoothing on offer.
enum class SmoothingForm {
  plain,     // towards the weighted mean of the neighbours (Long 2007, equation 13); does not conserve momentum exactly
  pairwise,  // sum of antisymmetric exchanges: conserves momentum to round-off
  scaled,    // pairwise, with the coefficient proportional to the step, so that its strength per time is constant
};

/// v_i += alpha * change_i once per step, which acts like a viscosity of about alpha dx^2 / (2 dt). In the scaled form
/// alpha belongs to a step of `reference_step` and is multiplied by dt / reference_step, at most 0.5.
template <int D>
class ConservativeSmoothing final : public VelocityFilter<D> {
 public:
  ConservativeSmoothing(SmoothingForm form, double coefficient, double reference_step)
      : form_(form), coefficient_(coefficient), reference_step_(reference_step) {}

  [[nodiscard]] std::string_view name() const override { return "conservative_smoothing"; }
  [[nodiscard]] std::string_view purpose() const override {
    if (form_ == SmoothingForm::plain) return "moves each velocity towards the mean of its neighbours";
    if (form_ == SmoothingForm::pairwise) return "exchanges velocity between pairs, momentum kept";
    return "exchanges velocity between pairs, momentum kept, strength proportional to the step";
  }
  [[nodiscard]] PairNeeds needs() const override { return {.value = true, .medium = form_ != SmoothingForm::plain}; }

  void change(const PairTile<D>& tile, const PairRecords<D>& records, double time_step, double* change) const override {
    const PairLoops<D>& loops = pair_loops<D>();
    (form_ == SmoothingForm::plain ? loops.plain_smoothing : loops.pairwise_smoothing)(tile, records, change);
    const double strength =
        form_ == SmoothingForm::scaled ? std::min(coefficient_ * time_step / reference_step_, 0.5) : coefficient_;
    std::for_each_n(change, (tile.end - tile.begin) * D, [&](double& component) { component *= strength; });
  }

 private:
  SmoothingForm form_;
  double coefficient_;
  double reference_step_;  // s
};

}  // namespace anvil
