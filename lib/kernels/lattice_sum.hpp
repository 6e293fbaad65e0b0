// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/kernels/kernel.hpp"

namespace anvil {

/// The factor alpha by which the plain difference operator sum_j V_j (f_j - f_i) dW_ij/dx_i misses the slope of a
/// linear field on a uniform square or cubic lattice, along an axis of the lattice. As it acts once on the stress and
/// once on the velocity, long waves travel at alpha times their true speed (Sun 2017, section 3).
///
/// `dimension` is 1, 2 or 3, `gamma` the smoothing length over the spacing, positive. Pure number; zero where gamma is
/// so small that no neighbour lies in the support. Throws InputError for other arguments.
double lattice_wave_speed_factor(const Kernel& kernel, int dimension, double gamma);

/// The largest cfl (time step times wave speed over smoothing length) at which the leapfrog is stable with that
/// operator, acting once on the stress and once on the velocity, without viscosity: 2/(h max_k |G(k)|), where
/// G(k) = sum_j V_j grad W_ij sin(k (x_j - x_i)) and k runs along the axes and the diagonals of the lattice (von
/// Neumann's analysis; omega dt < 2). Arguments and errors as above; infinite where no neighbour lies in the support.
/// `corrected`: with gradients corrected to be exact for linear fields, G over alpha.
double largest_stable_cfl(const Kernel& kernel, int dimension, double gamma, bool corrected);

}  // namespace anvil
