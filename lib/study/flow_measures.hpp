// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "anvil/measures/result.hpp"
#include "anvil/study/measures.hpp"

namespace anvil {

/// The coordinate along an axis that all but half a percent of the bodies' particles stay below, plus half a spacing:
/// the front of a flow, without its spray. Dummy particles of walls do not count.
double quantile_of_bodies(const Frame& frame, const Scene& scene, int axis);

double front(const StudySample& sample, std::string_view name);          // along x, m
double height(const StudySample& sample, std::string_view name);         // along the last axis, m
double fastest_speed(const StudySample& sample, std::string_view name);  // m/s
double audited(const StudySample& sample, std::string_view name);        // the audit's number of that name
/// Kinetic, elastic, potential and the walls' stored energy now, over the start's kinetic energy or, when that is zero,
/// over the potential energy lost: what must never rise above zero by more than rounding.
double energy_growth(const StudySample& sample, std::string_view name);
/// Largest error of the velocity along x in the scenes of a flow between plates at y = 0 and where the body ends, over
/// the largest of the series (PoiseuilleFlow); at the time of the velocities, half a step back.
double poiseuille_error(const StudySample& sample, std::string_view name);
double step_cost(const StudySample& sample, std::string_view name);  // us per particle and step

}  // namespace anvil
