// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/view_parts.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOutlineSource.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/figures/text_width.hpp"
#include "anvil/figures/ticks.hpp"
#include "vtk_io/lettering.hpp"

namespace anvil {
namespace {

constexpr double dark = 0.15;
constexpr double grey = 0.45;
constexpr double metre = 1e3;  // in mm

void color_by_scalars(vtkPolyDataMapper* mapper, vtkLookupTable* colors) {
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetScalarModeToUsePointData();
}

vtkActor* add_actor(vtkRenderer* view, vtkPolyDataMapper* mapper) {
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  view->AddActor(actor);
  return actor;
}

/// Much ambient light keeps faces that turn away readable against the colour bar.
void set_material(vtkProperty* property) {
  property->SetAmbient(0.4);
  property->SetDiffuse(0.7);
  property->SetSpecular(0.08);
  property->SetSpecularPower(20.0);
}

vtkActor* add_lines(vtkRenderer* view, vtkPolyData* lines, float width, double shade) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  vtkActor* actor = add_actor(view, mapper);
  actor->GetProperty()->SetColor(shade, shade, shade);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkActor* add_sphere_actor(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors) {
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetRadius(static_cast<float>(radius));
  color_by_scalars(mapper, colors);
  return add_actor(view, mapper);
}

/// The same colour on all sides.
void make_flat(vtkProperty* property) {
  property->SetAmbient(1.0);
  property->SetDiffuse(0.0);
}

/// Nearer to the viewer of a flat scene than what it lies on.
void lift(vtkActor* actor) {
  double bounds[6];
  actor->GetBounds(bounds);
  actor->SetPosition(0.0, 0.0, 1e-3 * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]));
}

Direction along(const Direction& begin, const Direction& axis, double distance) {
  return {begin[0] + distance * axis[0], begin[1] + distance * axis[1], begin[2] + distance * axis[2]};
}

enum class Anchor { middle, right };

void add_label(vtkRenderer* view, const std::string& text, const Direction& at, int font_height, Anchor anchor) {
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput(text.c_str());
  label->SetPosition(at[0], at[1], at[2]);
  set_font(label->GetTextProperty(), font_height);
  label->GetTextProperty()->SetJustification(anchor == Anchor::right ? VTK_TEXT_RIGHT : VTK_TEXT_CENTERED);
  label->GetTextProperty()->SetVerticalJustificationToCentered();
  view->AddActor(label);
}

}  // namespace

void add_spheres(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors) {
  set_material(add_sphere_actor(view, points, radius, colors)->GetProperty());
}

void add_discs(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors) {
  make_flat(add_sphere_actor(view, points, radius, colors)->GetProperty());
}

void add_wall_particles(vtkRenderer* view, vtkPolyData* points, double radius) {
  if (points == nullptr) return;
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetRadius(static_cast<float>(radius));
  mapper->ScalarVisibilityOff();
  vtkProperty* property = add_actor(view, mapper)->GetProperty();
  property->SetColor(0.62, 0.62, 0.62);
  make_flat(property);
}

void add_surface(vtkRenderer* view, vtkPolyData* surface, vtkLookupTable* colors) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->InterpolateScalarsBeforeMappingOn();
  color_by_scalars(mapper, colors);
  set_material(add_actor(view, mapper)->GetProperty());
}

void add_outline(vtkRenderer* view, const vtkBoundingBox& box) {
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(bounds);
  outline->Update();
  add_lines(view, outline->GetOutput(), 1.5F, grey);
}

void add_edges(vtkRenderer* view, vtkPolyData* lines, float width, double shade) {
  if (lines == nullptr || lines->GetNumberOfPoints() == 0) return;
  lines->GetPointData()->SetActiveScalars(nullptr);
  lift(add_lines(view, lines, width, shade));
}

void add_flat_surface(vtkRenderer* view, vtkPolyData* surface, vtkLookupTable* colors) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->InterpolateScalarsBeforeMappingOn();
  color_by_scalars(mapper, colors);
  add_actor(view, mapper)->GetProperty()->LightingOff();
}

void add_wall(vtkRenderer* view, const Plane& wall, const vtkBoundingBox& body) {
  Direction normal = wall.normal;
  vtkMath::Normalize(normal.data());
  double center[3];
  body.GetCenter(center);
  double above = 0.0;  // distance of the body's middle from the wall
  for (int i = 0; i < 3; ++i)
    above += normal[static_cast<std::size_t>(i)] * (center[i] - metre * wall.point[static_cast<std::size_t>(i)]);
  Direction u{};
  Direction v{};
  vtkMath::Perpendiculars(normal.data(), u.data(), v.data(), 0.0);
  double lengths[3];
  body.GetLengths(lengths);
  double half_width = 0.0;  // of the body, seen along the normal
  for (std::size_t i = 0; i < 3; ++i)
    half_width = std::max(half_width, 0.5 * lengths[i] * std::sqrt(1.0 - normal[i] * normal[i]));

  const double half = 1.15 * half_width;
  const Direction middle = along({center[0], center[1], center[2]}, normal, -above);
  const Direction corner = along(along(middle, u, -half), v, -half);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(corner.data());
  plane->SetPoint1(along(corner, u, 2 * half).data());
  plane->SetPoint2(along(corner, v, 2 * half).data());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkProperty* property = add_actor(view, mapper)->GetProperty();
  property->SetColor(0.86, 0.89, 0.92);
  property->SetEdgeColor(grey, grey, grey);
  property->EdgeVisibilityOn();
  property->SetLineWidth(1.5F);
  property->LightingOff();
}

void add_wall_line(vtkRenderer* view, const Plane& wall, const vtkBoundingBox& body) {
  Direction normal{wall.normal[0], wall.normal[1], 0.0};
  if (vtkMath::Normalize(normal.data()) == 0.0) return;
  const Direction side{-normal[1], normal[0], 0.0};
  double center[3];
  body.GetCenter(center);
  const double above =
      normal[0] * (center[0] - metre * wall.point[0]) + normal[1] * (center[1] - metre * wall.point[1]);
  const double half = 0.5 * (std::abs(side[0]) * body.GetLength(0) + std::abs(side[1]) * body.GetLength(1));
  const double thickness = 0.02 * std::max(body.GetLength(0), body.GetLength(1));
  const Direction middle = along({center[0], center[1], 0.0}, normal, -above);
  const Direction begin = along(middle, side, -1.04 * half);
  vtkNew<vtkPlaneSource> strip;
  strip->SetOrigin(begin.data());
  strip->SetPoint1(along(begin, side, 2.08 * half).data());
  strip->SetPoint2(along(begin, normal, -thickness).data());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(strip->GetOutputPort());
  vtkProperty* property = add_actor(view, mapper)->GetProperty();
  property->SetColor(0.72, 0.76, 0.80);
  property->LightingOff();
}

void add_surroundings(vtkRenderer* view, const DrawnParticles& particles, const RenderOptions& options,
                      const vtkBoundingBox& shown, int font_height) {
  const Direction& direction = options.view_direction;
  const double horizontal = std::hypot(direction[0], direction[1]);
  if (!(horizontal > 1e-6 * std::abs(direction[2])))
    throw InputError("the view direction must have a part along x or y, because z points up in the picture");
  if (options.outline)
    for (const auto& box : particles.undeformed) add_outline(view, box);
  for (const Plane& wall : options.walls) add_wall(view, wall, shown);
  // An upright scale to the left of the bodies, in the plane through their middle that faces the viewer.
  double center[3];
  shown.GetCenter(center);
  const Direction left{direction[1] / horizontal, -direction[0] / horizontal, 0.0};
  const double reach = 0.58 * (std::abs(left[0]) * shown.GetLength(0) + std::abs(left[1]) * shown.GetLength(1));
  add_ruler(view, {center[0] + reach * left[0], center[1] + reach * left[1], shown.GetMinPoint()[2]}, {0.0, 0.0, 1.0},
            left, shown.GetLength(2), shown.GetMaxLength(), font_height);
  vtkBoundingBox all(view->ComputeVisiblePropBounds());
  all.AddBox(shown);
  aim_camera(view, all, direction, {0.0, 0.0, 1.0});
}

void add_axes(vtkRenderer* view, const vtkBoundingBox& box, int font_height) {
  const double* low = box.GetMinPoint();
  const double room = std::max(box.GetLength(0), box.GetLength(1));
  const double away = 0.03 * room;
  add_ruler(view, {low[0], low[1] - away, 0.0}, {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, box.GetLength(0), room, font_height);
  if (box.GetLength(1) > 0.05 * box.GetLength(0))
    add_ruler(view, {low[0] - away, low[1], 0.0}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, box.GetLength(1), room,
              font_height);
}

void add_ruler(vtkRenderer* view, const Direction& begin, const Direction& axis, const Direction& side, double length,
               double room, int font_height) {
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(vtkSmartPointer<vtkPoints>::New());
  lines->SetLines(vtkSmartPointer<vtkCellArray>::New());
  const auto add_line = [&](const Direction& from, const Direction& to) {
    const vtkIdType a = lines->GetPoints()->InsertNextPoint(from.data());
    const vtkIdType b = lines->GetPoints()->InsertNextPoint(to.data());
    lines->GetLines()->InsertNextCell({a, b});
  };
  const double first = vtkMath::Dot(begin.data(), axis.data());
  const double step = nice_step(length, std::max(3, static_cast<int>(std::lround(7.0 * length / room))));
  const bool in_metres = step >= 100.0;
  const double tick_length = 0.02 * room;
  add_line(begin, along(begin, axis, length));
  // Numbers stand below an axis to the right, and end beside one that points upward.
  const bool upright = axis[0] == 0.0;
  const Anchor anchor = upright ? Anchor::right : Anchor::middle;
  const double away = (upright ? 1.5 : 3.0) * tick_length;
  double widest = 0.0;  // pixels
  const auto add_number = [&](const std::string& text, double at) {
    add_label(view, text, along(along(begin, axis, at), side, away), font_height, anchor);
    widest = std::max(widest, text_width(text, font_height));
  };
  const auto ticks = multiples_between(first, first + length, step);
  for (const double tick : ticks) {
    const Direction at = along(begin, axis, tick - first);
    add_line(at, along(at, side, tick_length));
    add_number(fmt::format("{:g}", in_metres ? 1e-3 * tick : tick), tick - first);
  }
  // Between the last two numbers, where it cannot leave the picture.
  add_number(in_metres ? "m" : "mm", ticks.back() - first - 0.5 * step);
  // Letters have no size in space: a line without length makes room for them when the camera looks for what to show.
  // That will take up at least half of the longer side of the view.
  const int* size = view->GetSize();
  const double pixel = room / (0.5 * std::max(size[0], size[1]));
  const double reach = away + pixel * (upright ? widest + 0.5 * font_height : font_height);
  const Direction outermost = along(begin, side, reach);
  add_line(outermost, outermost);
  add_lines(view, lines, 2.0F, dark);
}

void aim_camera(vtkRenderer* view, const vtkBoundingBox& box, const Direction& direction, const Direction& up) {
  double center[3];
  box.GetCenter(center);
  const double distance = 10.0 * box.GetDiagonalLength();
  Direction backward = direction;
  vtkMath::Normalize(backward.data());
  vtkCamera* camera = view->GetActiveCamera();
  camera->SetFocalPoint(center);
  camera->SetPosition(along({center[0], center[1], center[2]}, backward, distance).data());
  camera->SetViewUp(up.data());
  camera->OrthogonalizeViewUp();

  const double* upward = camera->GetViewUp();
  Direction right{};
  vtkMath::Cross(upward, backward.data(), right.data());
  double half_width = 0.0;
  double half_height = 0.0;
  for (int i = 0; i < 8; ++i) {
    double corner[3];
    box.GetCorner(i, corner);
    vtkMath::Subtract(corner, center, corner);
    half_width = std::max(half_width, std::abs(vtkMath::Dot(corner, right)));
    half_height = std::max(half_height, std::abs(vtkMath::Dot(corner, upward)));
  }
  constexpr double margin = 1.04;
  const double aspect = view->GetTiledAspectRatio();
  camera->SetParallelScale(margin * std::max(half_height, half_width / aspect));
  view->ResetCameraClippingRange();
}

}  // namespace anvil
