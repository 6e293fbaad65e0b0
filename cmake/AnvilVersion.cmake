# SPDX-License-Identifier: BSD-3-Clause
# The target anvil_version writes "anvil/version.hpp" at every build, and touches it only when something in it changed:
# the commit in the provenance of a result is that of the build, not that of the last configure step.

set(ANVIL_GENERATED_INCLUDE_DIR ${PROJECT_BINARY_DIR}/generated)
set(ANVIL_VERSION_COMMAND
    ${CMAKE_COMMAND}
    -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
    -D OUTPUT=${ANVIL_GENERATED_INCLUDE_DIR}/anvil/version.hpp
    -D VERSION=${PROJECT_VERSION}
    -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    -D "BUILD_TYPE=${CMAKE_BUILD_TYPE}"
    -P ${PROJECT_SOURCE_DIR}/cmake/write_version.cmake)
add_custom_target(
  anvil_version
  COMMAND ${ANVIL_VERSION_COMMAND}
  BYPRODUCTS ${ANVIL_GENERATED_INCLUDE_DIR}/anvil/version.hpp
  VERBATIM)
