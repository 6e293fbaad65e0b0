// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/measures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/measures/balance.hpp"
#include "anvil/measures/rod.hpp"
#include "anvil/measures/shell.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {
namespace {

/// The first body of the scene, which is the bar; shapes of quarter models begin at the axis.
RodShape rod_shape(const Scene& scene) {
  if (scene.domain.dimension != 3) throw InputError("a rod is measured in a three-dimensional scene");
  const auto shape = make_shape<3>(scene.bodies.front().shape);
  const Vec<3> upper = shape->centre() + 0.5 * shape->size();
  return {scene.discretisation.spacing, upper[0], upper[2]};
}

/// What a quantity of the modelled part is multiplied by: how many images planes of symmetry through the axis give, the
/// part itself with them.
double whole_over_part(const Scene& scene) {
  constexpr double rounding = 1e-6;
  std::vector<Mat<3>> mirrors, turns = {Mat<3>::Identity()};
  for (const auto& boundary : scene.boundaries) {
    if (boundary.entry.type != "symmetry_plane") continue;
    const Vec<3> normal = Vec<3>(boundary.entry.parameters.numbers("normal").data()).normalized();
    mirrors.emplace_back(Mat<3>::Identity() - 2.0 * normal * normal.transpose());
  }
  for (std::size_t k = 0; k < turns.size(); ++k) {
    for (const auto& mirror : mirrors) {
      const Mat<3> turn = mirror * turns[k];
      const auto is_same = [&](const Mat<3>& other) { return (turn - other).cwiseAbs().maxCoeff() < rounding; };
      if (std::none_of(turns.begin(), turns.end(), is_same)) turns.push_back(turn);
    }
  }
  return static_cast<double>(turns.size());
}

Rod rod_of(const Result& result) { return {result.frame, rod_shape(result.scene)}; }

Shell shell_of(const Result& result) { return {result.frame, shell_shape(result.scene)}; }

template <int Micrometres>
double strain_on_axis(const Result& result) {
  return value_at(rod_of(result).axis_plastic_strain(), 1e-6 * Micrometres);
}

template <int Micrometres>
double half_width_at(const Result& result) {
  return value_at(rod_of(result).half_width(), 1e-6 * Micrometres);
}

Curve over_time(const History& history, const std::string& column) {
  return {required_column(history, "time"), required_column(history, column)};
}

/// Mean force of the wall on the rod from 30 to 50 us: the impulse between these times over their distance.
double contact_force_plateau(const Result& result) {
  constexpr double from = 30e-6;
  constexpr double to = 50e-6;
  const Curve impulse = over_time(result.history, "wall_impulse_z");
  if (impulse.x.back() < to) throw InputError("the run ends before 50 us, where the plateau of its contact force ends");
  return whole_over_part(result.scene) * (value_at(impulse, to) - value_at(impulse, from)) / (to - from);
}

/// When the momentum along z changes its sign first, between two rows by linear interpolation.
double centre_of_mass_stop_time(const Result& result) {
  const Curve momentum = over_time(result.history, "momentum_z");
  for (std::size_t i = 1; i < momentum.x.size(); ++i) {
    const double before = momentum.y[i - 1];
    const double after = momentum.y[i];
    if (before < 0.0 && after >= 0.0)
      return momentum.x[i - 1] - before * (momentum.x[i] - momentum.x[i - 1]) / (after - before);
  }
  return std::numeric_limits<double>::quiet_NaN();  // it still moves towards the wall at the end
}

double centre_of_mass_velocity(const Result& result) {
  return required_column(result.history, "momentum_z").back() / required_column(result.history, "mass").back();
}

constexpr std::array measure_table = {
    Measure{"length", "m", [](const Result& result) { return rod_of(result).length(); }},
    Measure{"foot_half_width_side", "m", [](const Result& result) { return rod_of(result).foot_half_width_side(); }},
    Measure{"foot_half_width_corner", "m",
            [](const Result& result) { return rod_of(result).foot_half_width_corner(); }},
    Measure{"foot_radius", "m", [](const Result& result) { return rod_of(result).foot_radius(); }},
    Measure{"axis_plastic_strain_1mm", "", strain_on_axis<1000>},
    Measure{"axis_plastic_strain_2mm", "", strain_on_axis<2000>},
    Measure{"axis_plastic_strain_4mm", "", strain_on_axis<4000>},
    Measure{"side_half_width_4mm", "m", half_width_at<4000>},
    Measure{"side_half_width_8mm", "m", half_width_at<8000>},
    Measure{"side_half_width_12mm", "m", half_width_at<12000>},
    Measure{"shell_inner_radius", "m", [](const Result& result) { return shell_of(result).inner_radius(); }},
    Measure{"shell_outer_radius", "m", [](const Result& result) { return shell_of(result).outer_radius(); }},
    Measure{"shell_circularity", "", [](const Result& result) { return shell_of(result).circularity(); }},
    Measure{"plastic_work", "J",
            [](const Result& result) {
              return whole_over_part(result.scene) * required_column(result.history, "plastic_work").back();
            }},
    Measure{"start_energy", "J",
            [](const Result& result) {
              return whole_over_part(result.scene) * required_column(result.history, "kinetic_energy").front();
            }},
    Measure{"contact_force_plateau", "N", contact_force_plateau},
    Measure{"centre_of_mass_stop_time", "s", centre_of_mass_stop_time},
    Measure{"centre_of_mass_velocity", "m/s", centre_of_mass_velocity},
    Measure{"minimum_pair_distance", "spacing", minimum_pair_distance},
    Measure{"momentum_balance", "", momentum_balance},
    Measure{"unexplained_momentum", "", unexplained_momentum},
    Measure{"energy_balance", "", energy_balance},
    Measure{"smoothing_share", "", smoothing_share},
};

constexpr std::array profile_table = {
    ProfileMeasure{"kinetic_energy_history",
                   [](const Result& result) { return over_time(result.history, "kinetic_energy"); }},
    ProfileMeasure{"half_width", [](const Result& result) { return rod_of(result).half_width(); }},
    ProfileMeasure{"axis_plastic_strain", [](const Result& result) { return rod_of(result).axis_plastic_strain(); }},
};

template <class Table>
auto find_in(const Table& table, std::string_view name) -> decltype(&table.front()) {
  for (const auto& row : table)
    if (row.name == name) return &row;
  return nullptr;
}

}  // namespace

std::span<const Measure> measures() { return measure_table; }
std::span<const ProfileMeasure> profile_measures() { return profile_table; }
const Measure* find_measure(std::string_view name) { return find_in(measure_table, name); }
const ProfileMeasure* find_profile_measure(std::string_view name) { return find_in(profile_table, name); }

}  // namespace anvil
