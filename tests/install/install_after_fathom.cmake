# SPDX-License-Identifier: GPL-3.0-or-later
# Installs from a build folder where only the target fathom was built, as ./fathom leaves it; and before, from one where nothing can be
# built. BUILD is a folder of this test's own, beside the build folder: at the same depth, and by the same preset, ccache knows what was
# compiled there.
# cmake -D SOURCE=... -D BUILD=... -D WORK=... -D CXX=... -P install_after_fathom.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(run_well)
  run(${ARGV})
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}\nended with ${result}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK} ${BUILD})
set(configure ${CMAKE_COMMAND} --preset release -S ${SOURCE} -B ${BUILD} -DCMAKE_CXX_COMPILER=${CXX} -DFATHOM_TESTS=OFF)

# Law: where building fails nothing is installed.
run_well(${configure} -DCMAKE_CXX_COMPILER_LAUNCHER=false)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/never)
if(result EQUAL 0 OR EXISTS ${WORK}/never OR NOT output MATCHES "nothing has been installed")
  message(FATAL_ERROR "installing from a folder where nothing can be built ended with ${result} and said\n${output}")
endif()

# Law: where depth alone is configured nothing is installed.
run_well(${configure} -DFATHOM_ONLY_DEPTH=ON)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/never)
if(result EQUAL 0 OR EXISTS ${WORK}/never OR NOT output MATCHES "Only depth is configured")
  message(FATAL_ERROR "installing from a folder where depth alone is configured ended with ${result} and said\n${output}")
endif()

# Law: what is missing is built.
run_well(${configure} -DFATHOM_ONLY_DEPTH=OFF -U CMAKE_CXX_COMPILER_LAUNCHER)
run_well(${CMAKE_COMMAND} --build ${BUILD} --target fathom -j 2)
foreach(named verify/check/fathom-check libfathom-c.so)
  if(NOT EXISTS ${BUILD}/${named})
    message(FATAL_ERROR "the documents name ${named} as what is there after ./fathom")
  endif()
endforeach()
if(EXISTS ${BUILD}/completion)
  message(FATAL_ERROR "the files for terminals are here already: this test shows nothing")
endif()
run_well(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
set(data ${SOURCE}/tests/data)
run_well(${WORK}/prefix/bin/fathom depth --certificate ${WORK}/proof.cert ${data}/cube.off ${data}/icosahedron.off)
run_well(${WORK}/prefix/bin/fathom-check ${WORK}/proof.cert)
if(NOT output MATCHES "VERIFIED")
  message(FATAL_ERROR "the installed fathom-check printed '${output}'")
endif()
if(NOT EXISTS ${WORK}/prefix/share/man/man1/fathom.1)
  message(FATAL_ERROR "the manual pages are not installed")
endif()

# Law: DESTDIR stands before the prefix, and a second installation builds nothing.
run_well(${CMAKE_COMMAND} -E env DESTDIR=${WORK}/staged ${CMAKE_COMMAND} --install ${BUILD} --prefix /opt/fathom)
if(NOT output MATCHES "no work to do" OR NOT EXISTS ${WORK}/staged/opt/fathom/bin/fathom-check)
  message(FATAL_ERROR "the staged installation said\n${output}")
endif()

# Law: the target `uninstall` leaves nothing of it.
run_well(${CMAKE_COMMAND} -E env DESTDIR=${WORK}/staged ${CMAKE_COMMAND} --build ${BUILD} --target uninstall)
file(GLOB_RECURSE left ${WORK}/staged/*)
if(left)
  message(FATAL_ERROR "these are left: ${left}")
endif()
file(REMOVE_RECURSE ${WORK} ${BUILD})
