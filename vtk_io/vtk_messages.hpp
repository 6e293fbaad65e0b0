// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace anvil {

/// While it lives, VTK prints nothing, and remembers that it would have: its readers report most failures only so.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  [[nodiscard]] bool has_errors() const;

 private:
  class Window;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<Window> window_;
  int verbosity_before_;
};

}  // namespace anvil
