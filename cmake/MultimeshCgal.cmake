# SPDX-License-Identifier: BSD-3-Clause
# CGAL's kernel of exact predicates (LGPL-3+; headers only) with GMP and MPFR, for multimesh::predicates. Its
# compile flags (-frounding-math) stay with the one file that includes it. Quiet: CGAL's configuration prints.

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5 CONFIG QUIET GLOBAL)
if(NOT CGAL_FOUND)
  message(FATAL_ERROR "multimesh needs CGAL 5 or newer, with GMP and MPFR, for its predicates library. "
    "On Debian and Ubuntu: apt-get install libcgal-dev libgmp-dev libmpfr-dev (or scripts/setup-debian.sh). "
    "Elsewhere: set CGAL_DIR to the folder of CGALConfig.cmake.")
endif()
