// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "anvil/kernels/lattice_sum.hpp"
#include "anvil/measures/shell.hpp"
#include "anvil/measures/wave_comparison.hpp"
#include "anvil/study/contact.hpp"
#include "anvil/study/flow_measures.hpp"
#include "anvil/study/published.hpp"
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
  for (const auto& quantity :
       compare_waves(sample.frames[sample.number], sample.exact(), sample.number, sample.scene.discretisation.spacing))
    if (quantity.name == name) return quantity.value;
  return std::numeric_limits<double>::quiet_NaN();  // a plateau that is not there
}

/// What stress_l1 cannot be trusted below: the error of the exact solution itself, over its peak.
double reference_error(const StudySample& sample, std::string_view) {
  const SceneReference& exact = sample.exact();
  constexpr int points = 10'000;
  double sum = 0.0;
  double peak = 0.0;
  for (int k = 0; k < points; ++k) {
    const double place = exact.begin() + (exact.end() - exact.begin()) * (k + 0.5) / points;
    const double stress = std::abs(exact.at(sample.number, place).stress);
    sum += stress;
    peak = std::max(peak, stress);
  }
  return exact.relative_error(sample.number) * sum / points / peak;
}

Shell shell_of(const StudySample& sample) { return {sample.frames[sample.number], shell_shape(sample.scene)}; }

constexpr std::array measure_table = {
    StudyMeasure{"lattice_factor", "", lattice_factor},
    StudyMeasure{"elastic_speed_ratio", "", elastic_speed_ratio},
    StudyMeasure{"plastic_speed_ratio", "", plastic_speed_ratio},
    StudyMeasure{"precursor_error", "", precursor_error},
    StudyMeasure{"reference_error", "", reference_error},
    StudyMeasure{"stress_l1", "", compared},
    StudyMeasure{"stress_l2", "", compared},
    StudyMeasure{"velocity_l1", "", compared},
    StudyMeasure{"velocity_l2", "", compared},
    StudyMeasure{"peak_stress", "Pa", compared},
    StudyMeasure{"stress_overshoot", "", compared},
    StudyMeasure{"rise_width", "spacing", compared},
    StudyMeasure{"plateau_error", "", compared},
    StudyMeasure{"front", "m", front},
    StudyMeasure{"height", "m", height},
    StudyMeasure{"fastest", "m/s", fastest_speed},
    StudyMeasure{"penetrations", "", audited},
    StudyMeasure{"kinetic_energy", "J", audited},
    StudyMeasure{"energy_error", "J", audited},
    StudyMeasure{"wall_work", "J", audited},
    StudyMeasure{"energy_growth", "", energy_growth},
    StudyMeasure{"poiseuille_error", "", poiseuille_error},
    StudyMeasure{"step_cost", "us", step_cost},
    StudyMeasure{"contact_pressure_oscillation", "Pa", contact_oscillation},
    StudyMeasure{"contact_deviator_oscillation", "Pa", contact_oscillation},
    StudyMeasure{"shell_inner_radius", "m",
                 [](const StudySample& sample, std::string_view) { return shell_of(sample).inner_radius(); }},
    StudyMeasure{"shell_outer_radius", "m",
                 [](const StudySample& sample, std::string_view) { return shell_of(sample).outer_radius(); }},
    StudyMeasure{"shell_circularity", "",
                 [](const StudySample& sample, std::string_view) { return shell_of(sample).circularity(); }},
};

}  // namespace

std::optional<StudyMeasure> find_study_measure(std::string_view name) {
  for (const auto& row : measure_table)
    if (row.name == name) return row;
  return find_compared_measure(name);
}

std::vector<std::string_view> study_measure_names() {
  std::vector<std::string_view> names;
  for (const auto& row : measure_table) names.push_back(row.name);
  return names;
}

}  // namespace anvil
