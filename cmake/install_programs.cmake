# SPDX-License-Identifier: GPL-3.0-or-later
# The programs, and what lies beside them: schemas, check.py, the kits with the golden sample, examples, licences.
include(GNUInstallDirs)
foreach(program fathom fathom-check fathom-mpi)
  if(TARGET ${program})
    install(TARGETS ${program})
    add_dependencies(installed ${program})
  endif()
endforeach()
file(GLOB schemas CONFIGURE_DEPENDS cli/*/*.schema.json reference/*/*.schema.json verify/*/*.schema.json view/*/*.schema.json)
install(FILES ${schemas} DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom/schemas)
install(DIRECTORY LICENSES DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(PROGRAMS verify/check/check.py DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom)
install(DIRECTORY verify/subjects/kit DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom PATTERN "*.md" EXCLUDE)
install(DIRECTORY verify/golden/kit/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom/golden
  PATTERN "*.md" EXCLUDE PATTERN make.sh EXCLUDE)  # that makes the sample from the tree
set(sample ${PROJECT_BINARY_DIR}/golden_sample)
file(GLOB golden_data CONFIGURE_DEPENDS tests/data/golden/*)
add_custom_command(OUTPUT ${sample}/fathom_golden_sample.rs
  COMMAND ${PROJECT_SOURCE_DIR}/verify/golden/kit/make.sh ${sample} ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:fathom>
  DEPENDS fathom verify/golden/kit/make.sh ${golden_data} VERBATIM)
add_custom_target(golden_sample DEPENDS ${sample}/fathom_golden_sample.rs)
add_dependencies(installed golden_sample)
install(DIRECTORY ${sample}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fathom/golden)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN CMakeLists.txt EXCLUDE PATTERN "*.md" EXCLUDE)
install(DIRECTORY verify/examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/verify PATTERN __pycache__ EXCLUDE PATTERN "*.md" EXCLUDE)
