// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/off_screen.hpp"

#include <fmt/format.h>
#include <vtkCamera.h>
#include <vtkErrorCode.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRendererCollection.h>
#include <vtkWindowToImageFilter.h>

#include <cerrno>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "vtk_io/display.hpp"
#include "vtk_io/vtk_messages.hpp"

namespace anvil {

vtkSmartPointer<vtkRenderWindow> make_window(const std::array<int, 2>& size, const std::array<double, 3>& background) {
  constexpr int smallest = 200;
  constexpr int largest = 8192;
  for (const int pixels : size)
    if (pixels < smallest || pixels > largest)
      throw InputError(fmt::format("a picture of {} x {} pixels is not possible: expected {} to {} on each side",
                                   size[0], size[1], smallest, largest));
  ensure_display();
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(size[0], size[1]);
  vtkNew<vtkRenderer> canvas;
  canvas->SetBackground(background[0], background[1], background[2]);
  window->AddRenderer(canvas);
  return window;
}

vtkRenderer* background_of(vtkRenderWindow* window) { return window->GetRenderers()->GetFirstRenderer(); }

vtkSmartPointer<vtkRenderer> add_view(vtkRenderWindow* window, const std::array<double, 4>& part) {
  auto view = vtkSmartPointer<vtkRenderer>::New();
  view->SetViewport(part[0], part[1], part[2], part[3]);
  view->SetBackground(background_of(window)->GetBackground());
  view->GetActiveCamera()->ParallelProjectionOn();
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.78);
  lights->SetKeyToFillRatio(2.0);
  // White light: tinted light would take the colours away from those of the colour bar.
  constexpr double neutral = 0.5;
  lights->SetKeyLightWarmth(neutral);
  lights->SetFillLightWarmth(neutral);
  lights->SetBackLightWarmth(neutral);
  lights->SetHeadLightWarmth(neutral);
  lights->AddLightsToRenderer(view);
  window->AddRenderer(view);
  return view;
}

void write_png(vtkRenderWindow* window, const std::filesystem::path& png) {
  window->Render();
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->SetInputBufferTypeToRGB();
  pixels->ReadFrontBufferOff();
  pixels->ShouldRerenderOff();
  pixels->Update();
  write_atomically(png, [&](const std::filesystem::path& temporary) {
    const VtkMessages messages;
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(pixels->GetOutputPort());
    writer->SetFileName(temporary.c_str());
    errno = 0;
    writer->Write();
    if (writer->GetErrorCode() != vtkErrorCode::NoError || messages.has_errors())
      throw_system_error("write", png, errno != 0 ? errno : EIO);
  });
}

}  // namespace anvil
