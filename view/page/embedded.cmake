# SPDX-License-Identifier: GPL-3.0-or-later
# The page's own files are part of the program, so that an installed one needs no files, and a build no Node.
function(fathom_embed_page target)
  set(folder ${PROJECT_SOURCE_DIR}/view/page)
  file(GLOB parts CONFIGURE_DEPENDS ${folder}/web/*.js ${folder}/web/*.css ${folder}/three/three.bundle.js)
  set(embedded ${PROJECT_BINARY_DIR}/generated/page_embedded.cpp)
  add_custom_command(OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} -D FOLDER=${folder} -D OUT=${embedded} -P ${folder}/assemble.cmake
    DEPENDS ${parts} ${folder}/assemble.cmake ${folder}/embedded.cpp.in ${folder}/shell.html ${folder}/pair.html ${folder}/union.html ${folder}/sums.html ${folder}/page.css
    VERBATIM)
  target_sources(${target} PRIVATE ${embedded})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
