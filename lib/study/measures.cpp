// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/measures.hpp"

#include <array>
#include <limits>

#include "anvil/kernels/lattice_sum.hpp"
#include "anvil/measures/wave_comparison.hpp"
#include "anvil/study/wave_speed.hpp"

namespace anvil {
namespace {

double lattice_factor(const StudySample& sample, std::string_view) {
  const Discretisation& discretisation = sample.scene.discretisation;
  if (discretisation.method != "sph") return 1.0;  // the others correct the gradient of a linear field
  return lattice_wave_speed_factor(make_kernel(discretisation.kernel), sample.scene.domain.dimension,
                                   discretisation.smoothing_ratio);
}

/// A quantity of compare_waves.
double compared(const StudySample& sample, std::string_view name) {
  for (const auto& quantity : compare_waves(sample.frames[sample.number], sample.exact(), sample.number,
                                            sample.scene.discretisation.spacing))
    if (quantity.name == name) return quantity.value;
  return std::numeric_limits<double>::quiet_NaN();  // a plateau that is not there
}

constexpr std::array measure_table = {
    StudyMeasure{"lattice_factor", "", lattice_factor},
    StudyMeasure{"elastic_speed_ratio", "", elastic_speed_ratio},
    StudyMeasure{"plastic_speed_ratio", "", plastic_speed_ratio},
    StudyMeasure{"precursor_error", "", precursor_error},
    StudyMeasure{"stress_l1", "", compared},
    StudyMeasure{"stress_l2", "", compared},
    StudyMeasure{"velocity_l1", "", compared},
    StudyMeasure{"velocity_l2", "", compared},
    StudyMeasure{"peak_stress", "Pa", compared},
    StudyMeasure{"stress_overshoot", "", compared},
    StudyMeasure{"rise_width", "spacing", compared},
    StudyMeasure{"plateau_error", "", compared},
};

}  // namespace

const StudyMeasure* find_study_measure(std::string_view name) {
  for (const auto& row : measure_table)
    if (row.name == name) return &row;
  return nullptr;
}

std::vector<std::string_view> study_measure_names() {
  std::vector<std::string_view> names;
  for (const auto& row : measure_table) names.push_back(row.name);
  return names;
}

}  // namespace anvil
