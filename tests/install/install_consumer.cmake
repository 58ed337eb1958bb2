# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the build tree BUILD, moves the installation elsewhere, and builds and runs the foreign project against it.
# cmake -D BUILD=... -D WORK=... -D CXX=... -D FLAGS=... -D PYTHON=... -P install_consumer.cmake
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

# Law: the chosen headers are installed, and no other file of that kind but those of the two kits, which are there to be copied.
set(source ${CMAKE_CURRENT_LIST_DIR}/../..)
file(GLOB chosen RELATIVE ${source}/include ${source}/include/fathom/*)
list(APPEND chosen fathom/check.hpp ../share/fathom/golden/fathom_golden.h ../share/fathom/golden/fathom_golden_sample.h
  ../share/fathom/kit/fathom_subject.hpp)
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/*.h" "${prefix}/*.hpp")
list(SORT chosen)
list(SORT installed)
if(NOT installed STREQUAL chosen)
  message(FATAL_ERROR "the installed headers are ${installed}, and not ${chosen}")
endif()

# Law: no link of an installed page is dead, whether it leads to another page, to an example, to a schema or to a header; and no file names
# the folders of the build.
file(GLOB pages "${prefix}/share/doc/*/docs")
cmake_path(GET pages PARENT_PATH pages)
foreach(page README.md docs/certify.md verify/PROTOCOL.md proofs/README.md FORMAT.md)
  if(NOT EXISTS "${pages}/${page}")
    message(FATAL_ERROR "${page} is not installed")
  endif()
endforeach()
foreach(root "${pages}" "${prefix}/share/fathom")
  run(${CMAKE_COMMAND} -E env "FATHOM_ROOT=${root}" "FATHOM_EXECUTABLE=${prefix}/bin/fathom" ${PYTHON} -B ${source}/tests/docs/docs_test.py Docs.test_links)
endforeach()
cmake_path(NORMAL_PATH source)
execute_process(COMMAND grep -rIlF -e ${source} -e ${BUILD} ${prefix} OUTPUT_VARIABLE naming)
if(naming)
  message(FATAL_ERROR "these installed files name folders of the build:\n${naming}")
endif()

# Law: a foreign project can use them, and the examples.
file(GLOB examples "${prefix}/share/doc/*/examples")
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer
  "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_BUILD_TYPE=Release
  "-DEXAMPLES=${examples}" -DJUDGE_EXAMPLES=${source}/verify/examples)
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/all_headers)
run(${WORK}/consumer/check)
foreach(example depth.cpp answer.cpp c_judge.c)
  cmake_path(GET example STEM name)
  run(${CMAKE_COMMAND} -D PROGRAM=${WORK}/consumer/${name} -D "SOURCE=${examples}/${example}" -P "${examples}/run.cmake")
endforeach()

# Law: without CMake, pkg-config leads C programs to the library. A blank in a path would need quotes in the shell's words.
file(CREATE_LINK ${prefix} ${WORK}/place SYMBOLIC)
file(GLOB pc_file "${prefix}/lib*/pkgconfig/fathom-c.pc" "${prefix}/lib*/*/pkgconfig/fathom-c.pc")
string(REPLACE "${prefix}" ${WORK}/place pc_file "${pc_file}")
cmake_path(GET pc_file PARENT_PATH pc_folder)
cmake_path(GET pc_folder PARENT_PATH lib_folder)
run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder}
  sh -c "cc -std=c99 '${examples}/c_depth.c' ${FLAGS} $(pkg-config --cflags --libs fathom-c) -o ${WORK}/c_depth")
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${lib_folder}
  ${CMAKE_COMMAND} -D PROGRAM=${WORK}/c_depth -D "SOURCE=${examples}/c_depth.c" -P "${examples}/run.cmake")
run(${WORK}/consumer/judge_in_googletest)
if(NOT output MATCHES "PASSED  .* 3 tests")
  message(FATAL_ERROR "the example with GoogleTest printed '${output}'")
endif()
run(${WORK}/consumer/cgal)
if(NOT output STREQUAL "every kernel agrees\n")
  message(FATAL_ERROR "the consumer with CGAL printed '${output}'")
endif()

# Law: pkg-config says what the C++ libraries need.
find_program(PKG_CONFIG pkg-config REQUIRED)
file(GLOB_RECURSE pc "${prefix}/fathom.pc")
cmake_path(GET pc PARENT_PATH pc)
run(${CMAKE_COMMAND} -E env "PKG_CONFIG_PATH=${pc}" ${PKG_CONFIG} --cflags --libs fathom)
separate_arguments(found UNIX_COMMAND "${FLAGS} ${output}")
run(${CXX} -std=c++20 "${examples}/depth.cpp" -o ${WORK}/depth_by_pkg_config ${found})
run(${CMAKE_COMMAND} -D PROGRAM=${WORK}/depth_by_pkg_config -D "SOURCE=${examples}/depth.cpp" -P "${examples}/run.cmake")

run("${prefix}/bin/fathom" --version)
if(NOT output MATCHES "^fathom [0-9]")
  message(FATAL_ERROR "the installed fathom printed '${output}'")
endif()
file(REMOVE_RECURSE ${WORK})
