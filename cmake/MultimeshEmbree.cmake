# SPDX-License-Identifier: BSD-3-Clause
# Embree 3 as its own target, embree, for all directories. Version 4 has another interface.

find_package(embree 3 CONFIG QUIET GLOBAL)
if(NOT embree_FOUND)
  message(FATAL_ERROR "multimesh needs Embree 3 for its spatial, compare and remesh libraries. "
    "On Debian and Ubuntu: apt-get install libembree-dev (or scripts/setup-debian.sh). "
    "Elsewhere: set embree_DIR to the folder of embree-config.cmake. "
    "Without them, and without the program: -DMULTIMESH_BUILD_COMPARE=OFF -DMULTIMESH_BUILD_TOOLS=OFF.")
endif()
