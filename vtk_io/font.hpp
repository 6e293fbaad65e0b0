// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace anvil {

/// Path of DejaVu Sans, which pictures are lettered with: the font built into VTK has neither Greek letters nor square
/// brackets. Throws MissingResourceError when the machine lacks it.
const std::string& font_file();

}  // namespace anvil
