# SPDX-License-Identifier: GPL-3.0-or-later
# fathom_room(TARGET FOLDER [PUBLIC ...] [PRIVATE ...] [HIDDEN ...] [OPTIONS ...]): a static library from every .cpp below FOLDER.
#   PUBLIC, PRIVATE  libraries that it links
#   HIDDEN           header-only libraries that its .cpp files use; whoever links the room never hears of them
#   OPTIONS          compile options
# Other rooms include its headers, those named *_cgal.hpp apart, through the target TARGET_headers, which is not installed. Files listed in
# cgal_files.txt compile in the Ninja pool `cgal`.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/cgal_files.txt fathom_cgal_files REGEX "^[^#]")
list(TRANSFORM fathom_cgal_files PREPEND ${PROJECT_SOURCE_DIR}/)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/cgal_files.txt)

function(fathom_room target folder)
  cmake_parse_arguments(PARSE_ARGV 2 room "" "" "PUBLIC;PRIVATE;HIDDEN;OPTIONS")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  file(GLOB_RECURSE doors CONFIGURE_DEPENDS ${folder}/*.hpp)
  list(FILTER doors EXCLUDE REGEX "_cgal\\.hpp$")
  set(heavy ${sources})
  list(REMOVE_ITEM sources ${fathom_cgal_files})
  list(REMOVE_ITEM heavy ${sources})
  list(TRANSFORM room_HIDDEN REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")

  # That a header stands alone is shown by the source of its name, which includes it first, as the test `layers` checks. The test `headers`
  # compiles the others.
  set(alone ${doors})
  list(TRANSFORM sources REPLACE "\\.cpp$" ".hpp" OUTPUT_VARIABLE shown)
  list(REMOVE_ITEM alone ${shown})
  list(REMOVE_ITEM doors ${alone})
  add_library(${target}_headers INTERFACE)
  target_sources(${target}_headers INTERFACE
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${doors}
    FILE_SET alone TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${alone})
  set_target_properties(${target}_headers PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON INTERFACE_HEADER_SETS_TO_VERIFY alone)
  target_link_libraries(${target}_headers INTERFACE ${room_PUBLIC})

  add_library(${target} STATIC ${sources})
  target_compile_features(${target} PUBLIC cxx_std_20)
  set(parts ${target})
  if(heavy)
    add_library(${target}_cgal OBJECT ${heavy})
    target_include_directories(${target}_cgal PRIVATE ${PROJECT_SOURCE_DIR})
    set_target_properties(${target}_cgal PROPERTIES JOB_POOL_COMPILE cgal UNITY_BUILD ON)  # CGAL's headers are most of it: read them once
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_cgal>)
    list(APPEND parts ${target}_cgal)
  endif()
  # For the shared libraries that are made of it: the Python module. What is hidden costs no detour there.
  set_target_properties(${parts} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  foreach(part ${parts})
    target_link_libraries(${part} PUBLIC ${room_PUBLIC} $<BUILD_INTERFACE:${target}_headers> PRIVATE ${room_PRIVATE} ${room_HIDDEN})
    target_compile_options(${part} PRIVATE ${room_OPTIONS})
  endforeach()
endfunction()

# Texts that are part of the program, so that an installed one needs no files: `source` with each @NAME@ replaced by the text of a file.
# fathom_embed_texts(fathom_room folder/embedded.cpp.in NAME file NAME file ...)
function(fathom_embed_texts target source)
  set(rest ${ARGN})
  while(rest)
    list(POP_FRONT rest name file)
    file(READ ${PROJECT_SOURCE_DIR}/${file} ${name})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  endwhile()
  configure_file(${PROJECT_SOURCE_DIR}/${source} ${PROJECT_BINARY_DIR}/generated/${target}_embedded.cpp @ONLY)
  target_sources(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated/${target}_embedded.cpp)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
