// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "vtk_io/body_surface.hpp"
#include "vtk_io/off_screen.hpp"
#include "vtk_io/picture.hpp"
#include "vtk_io/view_parts.hpp"

namespace anvil {
namespace {

Quarter nearest_quarter(const DrawnParticles& particles, const Direction& view_direction) {
  double middle[3];
  (particles.undeformed.empty() ? box_of(particles) : particles.undeformed.front()).GetCenter(middle);
  return {middle[0], middle[1], view_direction[0] < 0.0 ? -1.0 : 1.0, view_direction[1] > 0.0 ? 1.0 : -1.0};
}

class RodView {
 public:
  RodView(const FrameParts& frame, const RenderOptions& options)
      : options_(options), picture_(make_picture(frame, options)) {
    if (options.surface) filling_ = make_filling(picture_.particles);
  }

  void add(const std::array<double, 4>& part, const std::optional<Quarter>& cut_away) {
    const auto view = add_view(picture_.window, part);
    add_body(view, cut_away);
    add_wall_particles(view, picture_.wall_particles, 0.12 * picture_.particles.spacing);
    add_surroundings(view, picture_.particles, options_, picture_.shown, picture_.font_height * 4 / 5);
  }

  [[nodiscard]] const Picture& picture() const { return picture_; }

 private:
  void add_body(vtkRenderer* view, const std::optional<Quarter>& cut_away) {
    if (filling_ != nullptr) {
      add_surface(view, make_body_surface(filling_, cut_away), picture_.colors);
      return;
    }
    constexpr double overlap = 0.55;  // of the spacing: closes the gaps
    const double radius = options_.glyph_radius > 0.0 ? options_.glyph_radius : overlap;
    const DrawnParticles drawn = cut_away ? without_quarter(picture_.particles, *cut_away) : picture_.particles;
    add_spheres(view, drawn.points, radius * picture_.particles.spacing, picture_.colors);
  }

  const RenderOptions& options_;
  Picture picture_;
  vtkSmartPointer<vtkDataSet> filling_;  // only where surfaces are drawn
};

}  // namespace

void render_rod(const FrameParts& frame, const RenderOptions& options, const std::filesystem::path& png) {
  RodView rod(frame, options);
  if (options.cut) {
    const double middle = 0.5 * view_part[2];
    rod.add({0.0, 0.0, middle, view_part[3]}, std::nullopt);
    rod.add({middle, 0.0, view_part[2], view_part[3]},
            nearest_quarter(rod.picture().particles, options.view_direction));
  } else {
    rod.add(view_part, std::nullopt);
  }
  write_png(rod.picture().window, png);
}

}  // namespace anvil
