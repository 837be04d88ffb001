# SPDX-License-Identifier: BSD-3-Clause
# GMP as one imported target, multimesh_dep_gmp. GMP has no CMake package of its own. Used by the build, and
# installed for the projects that link multimesh::exact.

if(NOT TARGET multimesh_dep_gmp)
  find_path(GMP_INCLUDE_DIR gmpxx.h)
  find_library(GMP_LIBRARY NAMES gmp)
  if(NOT GMP_INCLUDE_DIR OR NOT GMP_LIBRARY)
    string(CONCAT reason "multimesh::exact needs GMP (LGPL-3 or GPL-2) with its C++ header. "
      "On Debian and Ubuntu: apt-get install libgmp-dev (or scripts/setup-debian.sh). "
      "Elsewhere: set GMP_INCLUDE_DIR to the folder of gmpxx.h, and GMP_LIBRARY. ")
    if(CMAKE_FIND_PACKAGE_NAME)
      set(${CMAKE_FIND_PACKAGE_NAME}_NOT_FOUND_MESSAGE "${reason}")
      set(${CMAKE_FIND_PACKAGE_NAME}_FOUND FALSE)
      return()
    endif()
    message(FATAL_ERROR "${reason}Without it: -DMULTIMESH_WITH_EXACT=OFF.")
  endif()
  add_library(multimesh_dep_gmp UNKNOWN IMPORTED GLOBAL)
  set_target_properties(multimesh_dep_gmp PROPERTIES
    IMPORTED_LOCATION "${GMP_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${GMP_INCLUDE_DIR}")
endif()
