# SPDX-License-Identifier: BSD-3-Clause
# cmake -D NPM=npm -D SOURCE=DIR -D WORK=DIR -P npm_ci_or_skip.cmake
# Installs playwright-core into WORK/node_modules. Without a network it is not there, and the tests skip themselves.
foreach(name IN ITEMS package.json package-lock.json .npmrc)
  file(COPY_FILE "${SOURCE}/${name}" "${WORK}/${name}" ONLY_IF_DIFFERENT RESULT result)
endforeach()
set(stamp "${WORK}/npm.stamp")
if("${stamp}" IS_NEWER_THAN "${SOURCE}/package-lock.json" AND EXISTS "${WORK}/node_modules/playwright-core")
  return()
endif()
execute_process(
  COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
  WORKING_DIRECTORY "${WORK}"
  RESULT_VARIABLE status)
if(status EQUAL 0)
  file(TOUCH "${stamp}")
else()
  message("npm could not install playwright-core: the page is not tested in a browser")
endif()
