// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBoundingBox.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "anvil/output/frame.hpp"

namespace anvil {

/// What a view draws, in millimetres: several of VTK's filters have tolerances made for numbers around 1.
struct DrawnParticles {
  vtkSmartPointer<vtkPolyData> points;     // one vertex each, coloured by its point scalars
  double spacing = 1.0;                    // between neighbours before the deformation
  std::vector<double> volumes;             // mm3; empty: cubes of the spacing
  std::vector<vtkBoundingBox> undeformed;  // of each body, faces included; empty without initial_position
};

/// A box in metres (x low, x high, y low, ...) as it is drawn.
vtkBoundingBox drawn_box(const std::array<double, 6>& box);

/// A vertex at each of `positions`, 3 numbers each, m.
vtkSmartPointer<vtkPolyData> make_points(const std::vector<double>& positions);

/// `on_faces`: as in RenderOptions. Throws InputError when a position is not finite.
DrawnParticles make_drawn_particles(const Frame& frame, const std::vector<double>& colored_by, bool on_faces = false);

/// The quarter of a body that is cut away: the edge runs along z, two planes bound it.
struct Quarter {
  double x = 0.0, y = 0.0;             // of the edge, mm
  double sign_x = 1.0, sign_y = -1.0;  // side on which the quarter lies
  [[nodiscard]] bool contains(const double* point) const {
    return sign_x * (point[0] - x) > 0.0 && sign_y * (point[1] - y) > 0.0;
  }
};

/// The same without the particles that started in the quarter: the cut follows the material.
DrawnParticles without_quarter(const DrawnParticles& particles, const Quarter& quarter);

}  // namespace anvil
