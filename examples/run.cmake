# SPDX-License-Identifier: GPL-3.0-or-later
# Runs an example and compares what it prints with the lines "//> ..." of its source.
# cmake -D PROGRAM=... -D SOURCE=... -P run.cmake
file(STRINGS ${SOURCE} lines REGEX "^//>")
list(TRANSFORM lines REPLACE "^//> ?" "")
list(JOIN lines "\n" expected)
execute_process(COMMAND ${PROGRAM} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0 OR expected STREQUAL "" OR NOT output STREQUAL "${expected}\n")
  message(FATAL_ERROR "${SOURCE} ended with ${result} and printed\n${output}where it says\n${expected}")
endif()
