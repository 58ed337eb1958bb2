# SPDX-License-Identifier: GPL-3.0-or-later
# Manual pages and completion, which fathom writes itself: in man/ and completion/ of the build.
include(GNUInstallDirs)
set(FATHOM_ZSH_COMPLETION_DIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
  CACHE STRING "Where completion for zsh is installed (Debian's packages: share/zsh/vendor-completions)")
set(completion ${PROJECT_BINARY_DIR}/completion)
add_custom_command(OUTPUT ${completion}/bash ${completion}/zsh ${completion}/fish
  COMMAND ${CMAKE_COMMAND} -E make_directory ${completion}
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/man
  COMMAND fathom man --all ${PROJECT_BINARY_DIR}/man
  COMMAND fathom completion zsh > ${completion}/zsh
  COMMAND fathom completion fish > ${completion}/fish
  COMMAND fathom completion bash > ${completion}/bash
  DEPENDS fathom VERBATIM)
add_custom_target(terminal_files DEPENDS ${completion}/bash ${completion}/zsh ${completion}/fish)
add_dependencies(installed terminal_files)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${completion}/bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME fathom)
install(FILES ${completion}/zsh DESTINATION ${FATHOM_ZSH_COMPLETION_DIR} RENAME _fathom)
install(FILES ${completion}/fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d RENAME fathom.fish)
