// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "anvil/kernels/cubic_spline.hpp"
#include "anvil/kernels/gaussian.hpp"
#include "anvil/kernels/quadratic.hpp"
#include "anvil/kernels/quintic_spline.hpp"
#include "anvil/kernels/wendland_c2.hpp"
#include "anvil/kernels/wendland_c4.hpp"

namespace anvil {

/// The table of kernels: everything that lists or chooses kernels is made from it. To be visited once per run.
using Kernel = std::variant<CubicSpline, Gaussian, Quadratic, WendlandC2, WendlandC4, QuinticSpline>;

/// The kernel of that name; throws InputError with the names that exist.
Kernel make_kernel(std::string_view name);

/// The names of all kernels, in the order of the table.
std::span<const std::string_view> kernel_names();

/// One line on the kernel of that name; throws as make_kernel does.
std::string_view kernel_summary(std::string_view name);

}  // namespace anvil
