// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/vtk_messages.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

namespace anvil {

class VtkMessages::Window : public vtkOutputWindow {
 public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow) Window(const Window&) = delete;
  void operator=(const Window&) = delete;

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { has_errors = true; }

  bool has_errors = false;

 protected:
  Window() = default;
  ~Window() override = default;
};

vtkStandardNewMacro(VtkMessages::Window)

    VtkMessages::VtkMessages()
    : before_(vtkOutputWindow::GetInstance()),
      window_(vtkSmartPointer<Window>::New()),
      verbosity_before_(vtkLogger::GetCurrentVerbosityCutoff()) {
  vtkOutputWindow::SetInstance(window_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages() {
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(verbosity_before_));
  vtkOutputWindow::SetInstance(before_);
}

bool VtkMessages::has_errors() const { return window_->has_errors; }

}  // namespace anvil
