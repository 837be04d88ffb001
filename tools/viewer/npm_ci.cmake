# SPDX-License-Identifier: BSD-3-Clause
# cmake -D NPM=npm -D SOURCE=DIR -D WORK=DIR -P npm_ci.cmake
# Installs the packages of SOURCE/package-lock.json into WORK/node_modules.
foreach(name IN ITEMS package.json package-lock.json .npmrc)
  file(COPY_FILE "${SOURCE}/${name}" "${WORK}/${name}")
endforeach()
# No install scripts: esbuild's binary comes as a package of its own.
execute_process(
  COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
  WORKING_DIRECTORY "${WORK}"
  OUTPUT_QUIET
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "npm could not install three.js and esbuild, see above (is there a network?). "
    "To build without HTML reports: cmake -B <build directory> -DMULTIMESH_WITH_VIEWER=OFF")
endif()
