# SPDX-License-Identifier: BSD-3-Clause
# Script of the target anvil_version: fills lib/core/version.hpp.in.
# Takes SOURCE_DIR, OUTPUT, VERSION, COMPILER and BUILD_TYPE.

set(COMMIT "unknown")
# Only a checkout of Anvil itself counts: a copy inside somebody else's repository has no commit of its own.
if(EXISTS ${SOURCE_DIR}/.git)
  find_program(GIT git)
  if(GIT)
    execute_process(
      COMMAND ${GIT} describe --always --dirty=-modified --abbrev=40 --exclude=*
      WORKING_DIRECTORY ${SOURCE_DIR}
      OUTPUT_VARIABLE described
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(described)
      set(COMMIT ${described})
    endif()
  endif()
endif()
configure_file(${SOURCE_DIR}/lib/core/version.hpp.in ${OUTPUT} @ONLY)
