# SPDX-License-Identifier: BSD-3-Clause
# anvil_test(NAME <name> SOURCES <files> LABELS <label> [LIBRARIES <targets>] [TIMEOUT <seconds>])
# builds one GoogleTest program and registers each of its tests as <name>.<suite>.<test>.
# Every test program is compiled with ANVIL_SOURCE_DIR (top of the source tree) and ANVIL_PROGRAM (the built program).
# Label: unit, verification, robustness, render, paraview or benchmark. TIMEOUT holds for a single test.

set(ANVIL_TEST_LABELS unit verification robustness render paraview benchmark)
set(ANVIL_TEST_TIMEOUT_unit 60)
set(ANVIL_TEST_TIMEOUT_verification 900)
set(ANVIL_TEST_TIMEOUT_robustness 600)
set(ANVIL_TEST_TIMEOUT_render 300)
set(ANVIL_TEST_TIMEOUT_paraview 600)
set(ANVIL_TEST_TIMEOUT_benchmark 600)

function(anvil_test)
  cmake_parse_arguments(PARSE_ARGV 0 TEST "" "NAME;LABELS;TIMEOUT" "SOURCES;LIBRARIES")
  if(TEST_UNPARSED_ARGUMENTS OR NOT TEST_NAME OR NOT TEST_SOURCES)
    message(FATAL_ERROR "anvil_test(NAME name SOURCES files LABELS label [LIBRARIES targets] [TIMEOUT seconds])")
  endif()
  if(NOT TEST_LABELS IN_LIST ANVIL_TEST_LABELS)
    message(FATAL_ERROR "anvil_test ${TEST_NAME}: the label is one of ${ANVIL_TEST_LABELS}, not '${TEST_LABELS}'")
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT ${ANVIL_TEST_TIMEOUT_${TEST_LABELS}})
  endif()
  if(ANVIL_SANITIZE)
    math(EXPR TEST_TIMEOUT "${TEST_TIMEOUT} * 10")
  endif()

  set(program test_${TEST_NAME})
  add_executable(${program} ${TEST_SOURCES})
  target_link_libraries(${program} PRIVATE anvil::solver ${TEST_LIBRARIES} GTest::gtest_main anvil_compile_options)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(
    ${program} PRIVATE ANVIL_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                       ANVIL_PROGRAM="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/anvil")
  add_dependencies(${program} anvil)
  if(TEST_LABELS STREQUAL "unit")
    add_dependencies(anvil_unit_tests ${program})
  endif()
  # Threads of tests that run side by side must not spin while they wait for each other.
  gtest_discover_tests(
    ${program}
    TEST_PREFIX ${TEST_NAME}.
    DISCOVERY_TIMEOUT 120
    PROPERTIES LABELS ${TEST_LABELS} TIMEOUT ${TEST_TIMEOUT} ENVIRONMENT OMP_WAIT_POLICY=passive)
endfunction()
