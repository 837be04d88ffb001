# SPDX-License-Identifier: BSD-3-Clause
# Installs the libraries, their headers, and the packages by which CMake and pkg-config find them.

include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY MULTIMESH_LIBRARIES)
set(include_dir "${CMAKE_INSTALL_INCLUDEDIR}/multimesh-${PROJECT_VERSION_MAJOR}")
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/multimesh")
set(pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

install(TARGETS ${libraries} EXPORT multimesh-targets FILE_SET HEADERS DESTINATION "${include_dir}")
install(EXPORT multimesh-targets NAMESPACE multimesh:: DESTINATION "${package_dir}")
install(FILES "${PROJECT_BINARY_DIR}/include/multimesh/version.hpp" DESTINATION "${include_dir}/multimesh")

if(MULTIMESH_WITH_TETGEN)
  install(TARGETS multimesh_tetgen_worker DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/multimesh")
endif()

if(MULTIMESH_WITH_EXACT)
  install(FILES cmake/MultimeshGmp.cmake DESTINATION "${package_dir}")
endif()

list(TRANSFORM libraries REPLACE "^multimesh_" "" OUTPUT_VARIABLE multimesh_components)
list(FILTER multimesh_components EXCLUDE REGEX "^dep_")
list(JOIN multimesh_components ", " multimesh_components)
configure_package_config_file(cmake/multimesh-config.cmake.in multimesh-config.cmake
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(multimesh-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/multimesh-config.cmake"
  "${PROJECT_BINARY_DIR}/multimesh-config-version.cmake"
  DESTINATION "${package_dir}")

cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}/${pkgconfig_dir}"
  OUTPUT_VARIABLE prefix_from_pkgconfig)
configure_file(cmake/multimesh-core.pc.in multimesh-core.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/multimesh-core.pc" DESTINATION "${pkgconfig_dir}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
