# SPDX-License-Identifier: BSD-3-Clause
# TetGen 1.5 as one imported target, multimesh_dep_tetgen. TetGen has no CMake package of its own.

if(NOT TARGET multimesh_dep_tetgen)
  find_path(TETGEN_INCLUDE_DIR tetgen.h)
  find_library(TETGEN_LIBRARY NAMES tet tetgen)
  if(NOT TETGEN_INCLUDE_DIR OR NOT TETGEN_LIBRARY)
    string(CONCAT reason "the worker of multimesh::tetgen_client needs TetGen 1.5 (AGPL-3). "
      "On Debian and Ubuntu: apt-get install libtet1.5-dev (or scripts/setup-debian.sh). "
      "Elsewhere: set TETGEN_INCLUDE_DIR to the folder of tetgen.h, and TETGEN_LIBRARY. ")
    message(FATAL_ERROR "${reason}Without it: -DMULTIMESH_WITH_TETGEN=OFF.")
  endif()
  add_library(multimesh_dep_tetgen UNKNOWN IMPORTED GLOBAL)
  set_target_properties(multimesh_dep_tetgen PROPERTIES
    IMPORTED_LOCATION "${TETGEN_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${TETGEN_INCLUDE_DIR}")
endif()
