// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "vtk_io/drawn_particles.hpp"

namespace anvil {

/// How full space is of particles, sum of V_j W(x - x_j), and their colours, on a grid of half their spacing (3D).
/// Throws InputError when particles are so far apart that the grid would not fit into the memory.
vtkSmartPointer<vtkDataSet> make_filling(const DrawnParticles& particles);

/// The smooth surface where space is half full, with the colours of the particles. With `cut_away`, that quarter is
/// missing and the cut faces show the inside.
vtkSmartPointer<vtkPolyData> make_body_surface(vtkDataSet* filling, const std::optional<Quarter>& cut_away);

}  // namespace anvil
