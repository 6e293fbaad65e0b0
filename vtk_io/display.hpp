// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace anvil {

/// Makes sure that a render window can open: VTK aborts the process when there is no X server. Where the environment
/// names one with OpenGL, it is used; otherwise a private Xvfb is started, which ends with this process, even with a
/// killed one. Call it before the first render window exists and from a thread that lives as long as the drawing does,
/// because the X server ends with it. Throws MissingResourceError when neither is possible.
void ensure_display();

}  // namespace anvil
