# SPDX-License-Identifier: BSD-3-Clause
# Installs the program, the library with its headers and package files, and the bundled scenes, materials and references.
include(CMakePackageConfigHelpers)

set(ANVIL_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/Anvil)

install(TARGETS anvil RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(ANVIL_WITH_VTK)
  install(TARGETS anvil-figures RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(TARGETS anvil_solver EXPORT AnvilTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(
  DIRECTORY lib/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/anvil
  FILES_MATCHING
  PATTERN "*.hpp")
install(FILES ${ANVIL_GENERATED_INCLUDE_DIR}/anvil/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/anvil)
install(DIRECTORY data/ DESTINATION ${ANVIL_INSTALL_DATADIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT AnvilTargets NAMESPACE anvil:: DESTINATION ${ANVIL_INSTALL_CMAKEDIR})
configure_package_config_file(cmake/AnvilConfig.cmake.in ${PROJECT_BINARY_DIR}/AnvilConfig.cmake
                              INSTALL_DESTINATION ${ANVIL_INSTALL_CMAKEDIR} PATH_VARS ANVIL_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/AnvilConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/AnvilConfig.cmake ${PROJECT_BINARY_DIR}/AnvilConfigVersion.cmake
        DESTINATION ${ANVIL_INSTALL_CMAKEDIR})
