# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DNODE -DNPM -DSOURCE -DBUILD -DPAGE -DWITH_TESTS -P: fetches the packages when they are not
# those of the lock file, then builds the page. Without a network nothing is built and that is said,
# but nothing fails: arcbid's other commands do not need the page. The next build tries again.
set(lists package.json package-lock.json .npmrc)
set(wanted "tests ${WITH_TESTS}")
foreach(list ${lists})
  file(SHA256 ${SOURCE}/${list} digest)
  string(APPEND wanted " ${digest}")
endforeach()
set(installed "")
if(EXISTS ${BUILD}/installed.txt)
  file(READ ${BUILD}/installed.txt installed)
endif()

if(NOT installed STREQUAL wanted)
  file(REMOVE ${BUILD}/installed.txt)
  foreach(list ${lists})
    configure_file(${SOURCE}/${list} ${BUILD}/${list} COPYONLY)
  endforeach()
  set(options --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
    --fetch-retries=1 --fetch-retry-mintimeout=1000 --fetch-timeout=60000)
  if(NOT WITH_TESTS)
    list(APPEND options --omit=dev)
  endif()
  execute_process(COMMAND ${NPM} ci ${options} WORKING_DIRECTORY ${BUILD} RESULT_VARIABLE failed
    OUTPUT_FILE ${BUILD}/npm.log ERROR_FILE ${BUILD}/npm.log)
  if(failed)
    file(REMOVE ${PAGE})
    message("arcbid view and arcbid report will not work: npm ci could not fetch their packages (${BUILD}/npm.log says why); the next build tries again")
    return()
  endif()
  file(WRITE ${BUILD}/installed.txt "${wanted}")
endif()

set(ENV{ARCBID_NODE_MODULES} ${BUILD}/node_modules)
execute_process(COMMAND ${NODE} ${SOURCE}/build.mjs ${PAGE} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the viewer's page could not be built")
endif()
