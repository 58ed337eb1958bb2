# SPDX-License-Identifier: GPL-3.0-or-later
# Runs an example and compares what it prints with the lines "//> ..." at the end of its source.
# cmake -D PROGRAM=... -D SOURCE=... -P run.cmake
file(READ ${SOURCE} expected)
string(FIND "${expected}" "\n//>" end)
string(SUBSTRING "${expected}" ${end} -1 expected)
string(REGEX REPLACE "\n//> ?" "\n" expected "${expected}")
execute_process(COMMAND ${PROGRAM} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(end EQUAL -1 OR NOT result EQUAL 0 OR NOT "\n${output}" STREQUAL expected)
  message(FATAL_ERROR "${SOURCE} ended with ${result} and printed\n${output}where it says${expected}")
endif()
