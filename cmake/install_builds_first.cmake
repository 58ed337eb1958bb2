# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install` copies what it finds; where something is not built yet it would stop halfway. So it builds first, and copies nothing
# if that fails. Install rules run in the order in which they are written: include this before all others.
#
# The target `installed` is what has to be there. Parts with packages of their own (the adapters, the proved checker) are no part of it:
# they are installed if they have been built.
add_custom_target(installed)
install(CODE "
  set(build \"${CMAKE_COMMAND}\" --build \"${CMAKE_BINARY_DIR}\" --target installed)
  if(CMAKE_INSTALL_CONFIG_NAME)
    list(APPEND build --config \${CMAKE_INSTALL_CONFIG_NAME})
  endif()
  execute_process(COMMAND \${build} RESULT_VARIABLE failure)
  if(failure)
    message(FATAL_ERROR \"Building failed: nothing has been installed\")
  endif()")
