# SPDX-License-Identifier: BSD-3-Clause
# The program, the library with its headers and package files, and the bundled scenes, materials and references.
include(CMakePackageConfigHelpers)
