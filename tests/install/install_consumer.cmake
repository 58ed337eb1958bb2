# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the build tree BUILD, moves the installation elsewhere, and builds and runs the foreign project against it.
# cmake -D BUILD=... -D WORK=... -D CXX=... -D FLAGS=... -P install_consumer.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}\nended with ${result}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first "${WORK}/moved here")
set(prefix "${WORK}/moved here")

run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer
  "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_BUILD_TYPE=Release
  -DEXAMPLES=${CMAKE_CURRENT_LIST_DIR}/../../verify/examples)
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer)
if(NOT output STREQUAL "depth^2 1/100 along -1 0 0\n")
  message(FATAL_ERROR "the consumer printed '${output}'")
endif()
run(${WORK}/consumer/judge_c)
if(NOT output STREQUAL "too-deep: too deep by 0.4392: 1.0392 is claimed, the depth is 0.6\n")
  message(FATAL_ERROR "the consumer in C printed '${output}'")
endif()
run(${WORK}/consumer/judge_in_googletest)
if(NOT output MATCHES "PASSED  .* 3 tests")
  message(FATAL_ERROR "the example with GoogleTest printed '${output}'")
endif()

file(GLOB_RECURSE headers "${prefix}/include/*.hpp")
foreach(header ${headers})
  file(STRINGS ${header} heavy REGEX "^#include <(CGAL|boost|nlohmann|fmt|CLI)/")
  if(heavy)
    message(FATAL_ERROR "${header} needs more than the standard library and GMP: ${heavy}")
  endif()
endforeach()

run("${prefix}/bin/fathom" --version)
if(NOT output MATCHES "^fathom [0-9]")
  message(FATAL_ERROR "the installed fathom printed '${output}'")
endif()
file(REMOVE_RECURSE ${WORK})
