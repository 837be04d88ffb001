# SPDX-License-Identifier: BSD-3-Clause
# Common settings of all our targets: language level, warnings, include root, alias.

function(multimesh_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion)
  # GCC 12 mistakes std::string's own copies for overlapping ones (GCC bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
endfunction()

# multimesh_test(TARGET): a program of tests, which takes GoogleTest from the precompiled header of all of them.
function(multimesh_test target)
  multimesh_compile_options(${target})
  if(MULTIMESH_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM multimesh_test_headers)
    # GCC 12 does not know again that a precompiled header was a system's, and warns of what is in it.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-array-bounds)
    endif()
  endif()
endfunction()

# multimesh_add_library(NAME source...) makes the library multimesh_NAME, alias multimesh::NAME. Its public headers,
# those that are installed, are named by multimesh_public_headers.
function(multimesh_add_library name)
  add_library(multimesh_${name} ${ARGN})
  add_library(multimesh::${name} ALIAS multimesh_${name})
  multimesh_compile_options(multimesh_${name})
  # Static libraries can also be linked into others' shared ones. No symbol of ours may be replaced at run time:
  # calls within a file stay direct.
  target_compile_options(multimesh_${name} PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang>:-fno-semantic-interposition>)
  set_target_properties(multimesh_${name} PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(multimesh_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/multimesh-${PROJECT_VERSION_MAJOR}>)
  set_property(GLOBAL APPEND PROPERTY MULTIMESH_LIBRARIES multimesh_${name})
endfunction()

# multimesh_public_headers(NAME header...): as users include them, below `include` if there is one here, else below the
# root. Public headers include public ones only.
function(multimesh_public_headers name)
  set(root "${PROJECT_SOURCE_DIR}")
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/include")
    set(root "${CMAKE_CURRENT_SOURCE_DIR}/include")
  endif()
  list(TRANSFORM ARGN PREPEND "${root}/" OUTPUT_VARIABLE files)
  target_sources(multimesh_${name} PUBLIC FILE_SET HEADERS BASE_DIRS "${root}" FILES ${files})
  set_property(GLOBAL PROPERTY MULTIMESH_HEADERS_${name} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY MULTIMESH_PUBLIC_HEADERS ${files})
endfunction()
