// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/figure_painter.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextDevice2D.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "vtk_io/lettering.hpp"
#include "vtk_io/off_screen.hpp"

namespace anvil {
namespace {

/// Draws each shape through VTK's 2D context. VTK's own charts would do their own layout, which the SVG could not
/// share.
class DrawingItem : public vtkContextItem {
 public:
  static DrawingItem* New();
  vtkTypeMacro(DrawingItem, vtkContextItem)

      void set_drawing(const Drawing* drawing) {
    drawing_ = drawing;
  }

  bool Paint(vtkContext2D* context) override {
    for (const auto& shape : drawing_->shapes) std::visit([&](const auto& one) { paint(context, one); }, shape);
    return true;
  }

 private:
  static void paint(vtkContext2D* context, const DrawnLine& line) {
    clip(context, line.clip);
    vtkPen* pen = context->GetPen();
    pen->SetLineType(vtkPen::SOLID_LINE);
    pen->SetColor(line.color.red, line.color.green, line.color.blue);
    pen->SetWidth(static_cast<float>(line.width));
    std::vector<float> numbers = flat(line.dots);
    context->DrawPoly(numbers.data(), static_cast<int>(line.dots.size()));
    clip(context, std::nullopt);
  }

  static void paint(vtkContext2D* context, const DrawnPoints& points) {
    clip(context, points.clip);
    context->GetPen()->SetLineType(vtkPen::NO_PEN);
    context->GetBrush()->SetColor(points.color.red, points.color.green, points.color.blue);
    for (const Dot& dot : points.dots)
      context->DrawEllipse(static_cast<float>(dot.x), static_cast<float>(dot.y), static_cast<float>(points.radius),
                           static_cast<float>(points.radius));
    clip(context, std::nullopt);
  }

  static void paint(vtkContext2D* context, const DrawnText& text) {
    vtkNew<vtkTextProperty> letters;
    set_font(letters, static_cast<int>(std::lround(text.size)));
    letters->SetVerticalJustificationToCentered();
    letters->SetJustification(text.anchor == Anchor::left     ? VTK_TEXT_LEFT
                              : text.anchor == Anchor::centre ? VTK_TEXT_CENTERED
                                                              : VTK_TEXT_RIGHT);
    letters->SetOrientation(text.upright ? 90.0 : 0.0);
    context->ApplyTextProp(letters);
    context->DrawString(static_cast<float>(text.at.x), static_cast<float>(text.at.y), text.text);
  }

  static void paint(vtkContext2D* context, const DrawnImage& image) {
    vtkNew<vtkImageData> pixels;
    pixels->SetDimensions(static_cast<int>(image.columns), static_cast<int>(image.rows), 1);
    pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* bytes = static_cast<unsigned char*>(pixels->GetScalarPointer());
    for (const Color& color : image.cells) {
      *bytes++ = color.red;
      *bytes++ = color.green;
      *bytes++ = color.blue;
    }
    const Box& box = image.box;
    context->DrawImage(vtkRectf(static_cast<float>(box.left), static_cast<float>(box.bottom),
                                static_cast<float>(box.width()), static_cast<float>(box.height())),
                       pixels);
  }

  static std::vector<float> flat(const std::vector<Dot>& dots) {
    std::vector<float> numbers;
    for (const Dot& dot : dots) {
      numbers.push_back(static_cast<float>(dot.x));
      numbers.push_back(static_cast<float>(dot.y));
    }
    return numbers;
  }

  static void clip(vtkContext2D* context, const std::optional<Box>& box) {
    vtkContextDevice2D* device = context->GetDevice();
    device->EnableClipping(box.has_value());
    if (!box) return;
    std::array<int, 4> pixels = {static_cast<int>(std::lround(box->left)), static_cast<int>(std::lround(box->bottom)),
                                 static_cast<int>(std::lround(box->width())),
                                 static_cast<int>(std::lround(box->height()))};
    device->SetClipping(pixels.data());
  }

  const Drawing* drawing_ = nullptr;
};

vtkStandardNewMacro(DrawingItem)

}  // namespace

void paint_png(const Drawing& drawing, const std::filesystem::path& png) {
  const auto window = make_window(drawing.size, {1.0, 1.0, 1.0});
  vtkNew<DrawingItem> item;
  item->set_drawing(&drawing);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  background_of(window)->AddActor(actor);
  actor->GetScene()->SetRenderer(background_of(window));
  write_png(window, png);
}

}  // namespace anvil
