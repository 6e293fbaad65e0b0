// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/fields.hpp"

/// The fields a particle can carry.
namespace anvil::field {

inline constexpr FieldKey position{"position", "m", "where the particle is"};
inline constexpr FieldKey initial_position{"initial_position", "m", "where it was at the start; output and comparison"};
inline constexpr FieldKey velocity{"velocity", "m/s", "at the half step behind the positions (leapfrog)"};
inline constexpr FieldKey start_velocity{"start_velocity", "m/s", "before the kick; the energy account of filters"};
inline constexpr FieldKey mass{"mass", "kg", "constant; per unit length of the missing dimensions in 1D and 2D"};
inline constexpr FieldKey density{"density", "kg/m3", "from the continuity equation"};
inline constexpr FieldKey smoothing_length{"smoothing_length", "m", "h of the kernel"};
inline constexpr FieldKey pressure{"pressure", "Pa", "from the equation of state, compression positive"};
inline constexpr FieldKey deviatoric_stress{"deviatoric_stress", "Pa", "its independent components, tension positive"};
inline constexpr FieldKey back_stress{"back_stress", "Pa", "centre of the yield surface (kinematic hardening)"};
inline constexpr FieldKey plastic_strain{"plastic_strain", "", "accumulated equivalent plastic strain"};
inline constexpr FieldKey viscous_pressure{"viscous_pressure", "Pa", "of the bulk viscosity"};
inline constexpr FieldKey deformation_gradient{"deformation_gradient", "",
                                               "d x_a / d X_b, X where it was at the start"};
inline constexpr FieldKey eroded{"eroded", "", "1 where a stress point carries no stress any more, else 0"};
inline constexpr FieldKey plastic_dilation{"plastic_dilation", "", "accumulated plastic volume strain"};
inline constexpr FieldKey specific_energy{"specific_energy", "J/kg", "internal, what the equation of state reads"};
inline constexpr FieldKey kick_energy{"kick_energy", "J/kg",
                                      "internal, at the time of the velocities; exchanged by pairs"};
inline constexpr FieldKey velocity_gradient{"velocity_gradient", "1/s", "of the last step; slopes towards neighbours"};
inline constexpr FieldKey pair_acceleration{"pair_acceleration", "m/s2", "of the last step; slopes of the stress"};
inline constexpr FieldKey star_gradient{"star_gradient", "1/s",
                                        "velocity gradient of the star states beyond the means"};
inline constexpr FieldKey gradient_correction{"gradient_correction", "", "of the last step's gradients, symmetric"};
inline constexpr FieldKey hourglass_acceleration{"hourglass_acceleration", "m/s2",
                                                 "of the last step; the energy account"};
inline constexpr FieldKey listed_position{"listed_position", "m", "position when the neighbour list was made"};
inline constexpr FieldKey listed_smoothing_length{"listed_smoothing_length", "m", "h when the neighbour list was made"};

}  // namespace anvil::field
