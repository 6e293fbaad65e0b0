// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "vtk_io/drawn_particles.hpp"

namespace anvil {

/// A smooth surface around the particles (3D), carrying their colours: where the sum of V_j W(x - x_j) falls to one
/// half. With `cut_away`, that quarter is missing and the cut faces show the inside.
vtkSmartPointer<vtkPolyData> make_body_surface(const DrawnParticles& particles, const std::optional<Quarter>& cut_away);

}  // namespace anvil
