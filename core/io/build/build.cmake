# SPDX-License-Identifier: GPL-3.0-or-later
# Runs with every build, for commits come without a new configuration; writes only what is new.
execute_process(COMMAND git rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE_DIR}
  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git diff --quiet HEAD WORKING_DIRECTORY ${SOURCE_DIR} RESULT_VARIABLE changed ERROR_QUIET)
if(COMMIT AND NOT changed EQUAL 0)
  string(APPEND COMMIT "+")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/build.cpp.in ${OUTPUT} @ONLY)
