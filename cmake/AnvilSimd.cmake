# SPDX-License-Identifier: BSD-3-Clause
# anvil_add_simd_levels(<target> <sources>...) compiles the sources once per level of ANVIL_SIMD_LEVELS and adds the
# objects to the target. Each source puts its functions into `namespace anvil::ANVIL_SIMD_LEVEL` (the definition is the
# name of the level). The target gets ANVIL_HAS_<level>=1 for each level, so that it can choose one when the program starts.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(ANVIL_SIMD_LEVELS_DEFAULT baseline avx2 avx512)
else()
  set(ANVIL_SIMD_LEVELS_DEFAULT baseline)
endif()
set(ANVIL_SIMD_LEVELS "${ANVIL_SIMD_LEVELS_DEFAULT}" CACHE STRING "Instruction sets the pair loops are compiled for")

set(ANVIL_SIMD_FLAGS_baseline "")
set(ANVIL_SIMD_FLAGS_avx2 -march=x86-64-v3)
# Compilers prefer halves of the wide registers for the sake of mixed loads; pair loops keep the full width busy.
set(ANVIL_SIMD_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)

function(anvil_add_simd_levels target)
  # Clang takes ten minutes to check these inlined loops for undefined behaviour, and five to check addresses with the
  # portable instructions: addresses are checked in the others, whose text is the same.
  if(ANVIL_SANITIZE)
    set(portable $<STREQUAL:$<TARGET_PROPERTY:NAME>,${target}_baseline>)
    set_source_files_properties(
      ${ARGN} PROPERTIES COMPILE_OPTIONS "-fno-sanitize=$<IF:${portable},all,undefined>;-O1")
  endif()
  foreach(level IN LISTS ANVIL_SIMD_LEVELS)
    if(NOT DEFINED ANVIL_SIMD_FLAGS_${level})
      message(FATAL_ERROR "ANVIL_SIMD_LEVELS: '${level}' is not known; choose from baseline, avx2, avx512")
    endif()
    target_compile_definitions(${target} PRIVATE ANVIL_HAS_${level}=1)
    if(ARGN)
      add_library(${target}_${level} OBJECT ${ARGN})
      target_compile_definitions(${target}_${level} PRIVATE ANVIL_SIMD_LEVEL=${level})
      # The levels of x86-64 leave out AES, without which Highway falls back to two lanes whatever the level.
      target_compile_definitions(${target}_${level} PRIVATE HWY_DISABLE_PCLMUL_AES)
      target_compile_options(${target}_${level} PRIVATE ${ANVIL_SIMD_FLAGS_${level}})
      # Not linked to the target itself, which would be a circle: only what it includes.
      target_include_directories(${target}_${level} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
      target_link_libraries(${target}_${level} PRIVATE ${ANVIL_DEPENDENCIES} anvil_compile_options)
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_${level}>)
      add_dependencies(${target}_${level} anvil_version)
      set_target_properties(${target}_${level} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
  endforeach()
  if(NOT "baseline" IN_LIST ANVIL_SIMD_LEVELS)
    message(FATAL_ERROR "ANVIL_SIMD_LEVELS must contain 'baseline', which every machine can run")
  endif()
endfunction()
