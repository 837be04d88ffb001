# SPDX-License-Identifier: BSD-3-Clause
# Libraries with which io reads and writes compressed and XML files: pugixml (MIT) and zlib (Zlib).

find_package(ZLIB QUIET GLOBAL)
find_package(pugixml CONFIG QUIET GLOBAL)
if(NOT ZLIB_FOUND OR NOT pugixml_FOUND)
  message(FATAL_ERROR "multimesh needs zlib and pugixml for its io library. "
    "On Debian and Ubuntu: apt-get install zlib1g-dev libpugixml-dev (or scripts/setup-debian.sh). "
    "Elsewhere: set ZLIB_ROOT, and pugixml_DIR to the folder of pugixml-config.cmake.")
endif()
