# SPDX-License-Identifier: BSD-3-Clause
# OpenMesh, its tools (decimaters, smoothers) included, as one target of ours, multimesh_dep_openmesh. OpenMesh's own package has neither a version file
# (never ask it for a version) nor a namespace; its headers come in as system headers.

find_package(OpenMesh CONFIG QUIET GLOBAL)

set(found "none")
if(OpenMesh_FOUND)
  get_target_property(include_dir OpenMeshCore INTERFACE_INCLUDE_DIRECTORIES)
  file(STRINGS "${include_dir}/OpenMesh/Core/System/config.h" found REGEX "^#define OM_VERSION 0x")
  string(REGEX REPLACE ".*(0x[0-9a-fA-F]+).*" "\\1" found "${found}")
endif()
if(NOT found MATCHES "^0x" OR found LESS 0x90000)
  message(FATAL_ERROR "multimesh needs OpenMesh 9.0 (OM_VERSION 0x90000) or newer; found: ${found}. "
    "On Debian and Ubuntu: apt-get install libopenmesh-dev (or scripts/setup-debian.sh). "
    "Elsewhere: set OpenMesh_DIR to the folder of OpenMeshConfig.cmake.")
endif()

add_library(multimesh_dep_openmesh INTERFACE)
target_link_libraries(multimesh_dep_openmesh INTERFACE OpenMeshTools OpenMeshCore)
set_target_properties(multimesh_dep_openmesh PROPERTIES EXPORT_NAME dep_openmesh)
set_property(GLOBAL APPEND PROPERTY MULTIMESH_LIBRARIES multimesh_dep_openmesh)
