# SPDX-License-Identifier: GPL-3.0-or-later
# Copies the checker's folder away from the project, builds it there with CMake and with the one line of its README, and runs both.
# cmake -D SOURCE=verify/check -D WORK=... -D CXX=... -D CERTIFICATES=... -P check_alone.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}\nended with ${result}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/ DESTINATION "${WORK}/some where")
file(GLOB certificates ${CERTIFICATES}/*.cert)

run(${CMAKE_COMMAND} -S "${WORK}/some where" -B ${WORK}/build -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Debug)  # in half of the time
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/fathom-check ${certificates})

file(STRINGS "${WORK}/some where/README.md" line REGEX "^    g\\+\\+ ")
string(STRIP "${line}" line)
run(${CMAKE_COMMAND} -E chdir "${WORK}/some where" sh -c "${line}")
run("${WORK}/some where/fathom-check" ${certificates})
file(REMOVE_RECURSE ${WORK})
