# SPDX-License-Identifier: GPL-3.0-or-later
# Texts that are part of the program, so that an installed one needs no files: the real cases, the notes, the licence, the schemas, and
# the code that exports begin with.
function(fathom_embed target)
  set(folder ${PROJECT_SOURCE_DIR}/verify/golden)
  set(files ${PROJECT_SOURCE_DIR}/tests/data/real_cases.jsonl ${folder}/NOTES.md ${PROJECT_SOURCE_DIR}/LICENSES/CC0-1.0.txt
    ${PROJECT_SOURCE_DIR}/verify/golden/golden.schema.json ${PROJECT_SOURCE_DIR}/verify/golden/dataset.schema.json
    ${PROJECT_SOURCE_DIR}/verify/golden/shard.schema.json ${folder}/kit/fathom_golden.h ${folder}/kit/fathom_golden.rs)
  set(names REAL_CASES NOTES LICENCE RECORD_SCHEMA DATASET_SCHEMA SHARD_SCHEMA KIT_C KIT_RUST)
  foreach(file name IN ZIP_LISTS files names)
    file(READ ${file} ${name})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  configure_file(${folder}/embedded.cpp.in ${PROJECT_BINARY_DIR}/generated/golden_embedded.cpp @ONLY)
  target_sources(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated/golden_embedded.cpp)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
