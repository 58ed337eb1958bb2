# SPDX-License-Identifier: GPL-3.0-or-later
# The script of the target `uninstall`, on installations made by hand; install_after_fathom.cmake tries it on a whole one.
# cmake -D SOURCE=... -D WORK=... -P uninstall.cmake
function(uninstall)
  execute_process(COMMAND ${ARGV} ${CMAKE_COMMAND} -D MANIFEST=${WORK}/manifest.txt -P ${SOURCE}/cmake/uninstall.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(installed "bin/fathom;share/fathom/kit/a file.py;share/fathom/list.txt;share/doc/fathom/docs/page.md;lib/libfathom.so")
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

uninstall()
if(result EQUAL 0 OR NOT output MATCHES "nothing[ \n]+has[ \n]+been[ \n]+installed")
  message(FATAL_ERROR "law: without a manifest that is said, and an error\n${output}")
endif()

# With a prefix, and with a folder before it.
foreach(destdir "" "${WORK}/staged")
  set(prefix "${WORK}/my prefix")
  if(destdir)
    set(prefix /usr)
  endif()
  file(WRITE ${WORK}/manifest.txt "")
  foreach(file ${installed})
    file(WRITE "${destdir}${prefix}/${file}" "")
    file(APPEND ${WORK}/manifest.txt "${prefix}/${file}\n")
  endforeach()
  file(REMOVE "${destdir}${prefix}/lib/libfathom.so")
  file(CREATE_LINK libfathom.so.1 "${destdir}${prefix}/lib/libfathom.so" SYMBOLIC)  # which leads nowhere
  file(WRITE "${destdir}${prefix}/share/fathom/mine.txt" "")
  file(WRITE "${destdir}${prefix}/bin/other" "")
  uninstall(${CMAKE_COMMAND} -E env "DESTDIR=${destdir}")
  file(GLOB_RECURSE left LIST_DIRECTORIES true RELATIVE "${destdir}${prefix}" "${destdir}${prefix}/*")
  list(SORT left)
  if(NOT result EQUAL 0 OR NOT left STREQUAL "bin;bin/other;lib;share;share/doc;share/fathom;share/fathom/mine.txt")
    message(FATAL_ERROR "law: what the manifest lists is removed, and folders of fathom's own that are empty; this is left: ${left}\n${output}")
  endif()
  uninstall(${CMAKE_COMMAND} -E env "DESTDIR=${destdir}")
  if(NOT result EQUAL 0 OR NOT output MATCHES "removed 0 files; 5 were not there")
    message(FATAL_ERROR "law: once more removes nothing, and is no error\n${output}")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK})
