# SPDX-License-Identifier: GPL-3.0-or-later
# Copies the adapters of engines for the web into a folder and lets npm install their packages there. npm runs only when the lock file has
# changed: the stamp holds its hash.
#
#   cmake -DFROM=<verify/subjects> -DTO=<folder> -DNODE=<node> -DNPM=<npm> [-DHISTORY=ON] -P install.cmake
#
# HISTORY: the older versions of engines, too.
foreach(word FROM TO)
  if(NOT ${word})
    message(FATAL_ERROR "expected -D${word}=...")
  endif()
endforeach()
set(why "engines for the web need node 18 or later and npm (Debian: nodejs, npm)")
if(NOT NODE OR NOT NPM)
  message(FATAL_ERROR "${why}, which are not here")
endif()
execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
if(failed OR NOT version MATCHES "^v([0-9]+)" OR CMAKE_MATCH_1 LESS 18)
  message(FATAL_ERROR "${why}; ${NODE} is ${version}")
endif()

# Lets npm install what the lock file of a folder names.
function(install_packages folder)
  file(SHA256 ${folder}/package-lock.json wanted)
  set(stamp ${folder}/node_modules/installed)
  if(EXISTS ${stamp})
    file(READ ${stamp} there)
    if(there STREQUAL wanted)
      return()
    endif()
  endif()
  file(REMOVE_RECURSE ${folder}/node_modules)
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${folder}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE failed)
  if(failed)
    file(REMOVE_RECURSE ${folder}/node_modules)
    message(FATAL_ERROR "npm could not install the engines' packages (is the network there?):\n${said}")
  endif()
  file(WRITE ${stamp} ${wanted})
endfunction()

file(GLOB scripts ${FROM}/web/*.mjs)
file(COPY ${scripts} ${FROM}/web/package.json ${FROM}/web/package-lock.json ${FROM}/kit/fathom_subject.mjs DESTINATION ${TO})
install_packages(${TO})
if(HISTORY)
  file(COPY ${FROM}/web/history DESTINATION ${TO})
  install_packages(${TO}/history)
endif()
