# SPDX-License-Identifier: BSD-3-Clause
# The target anvil_compile_options holds what every target of Anvil is compiled with.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# Development builds give the same numbers as the release, so they optimise alike; line numbers are what a
# profiler and a backtrace can use of them, and full debug information takes longer to compile and link.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O3 -g1 -DNDEBUG")

add_library(anvil_compile_options INTERFACE)
target_compile_options(
  anvil_compile_options
  INTERFACE
    -Wall
    -Wextra
    -Wpedantic
    -Wshadow
    -Wconversion
    # GCC 12 sees overlapping copies in every "text" + std::string (its bug 105651, mended in 13).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    $<$<BOOL:${ANVIL_WARNINGS_AS_ERRORS}>:-Werror>
    # Nothing reads errno or the exception flags of the processor, and without these two, loops over sqrt and selects
    # become vector loops. -ffast-math stays off: it reorders sums, so that results would change with the compiler's mood,
    # and it removes the checks for NaN that the guards live on. Fused multiply-adds round once instead of twice and
    # do not reorder: a build gives the same bits on every run and for any number of threads.
    -fno-math-errno
    -fno-trapping-math
    $<$<CXX_COMPILER_ID:GNU>:-ffp-contract=fast>)

# Small tensors stay scalar: stored component by component and read back as vectors, they stall the processor, and the
# stress update takes 32 instead of 19 ns per particle. Pair loops have vectors of their own.
target_compile_definitions(anvil_compile_options INTERFACE EIGEN_UNALIGNED_VECTORIZE=0)

if(ANVIL_SANITIZE)
  target_compile_options(anvil_compile_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                        -fno-omit-frame-pointer -O1 -g1)
  target_compile_definitions(anvil_compile_options INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(anvil_compile_options INTERFACE -fsanitize=address,undefined)
endif()
