# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What is in the Debian packages of this build, and that it can be built against. Testing/Packages/run.sh
# installs packages as their users do; this test needs neither root nor a network. Included by the
# directory of tests, where CMAKE_CURRENT_LIST_DIR is this one.

add_test(NAME PackagesOfBuild
  COMMAND "${CMAKE_COMMAND}"
    "-DBUILD=${CMAKE_BINARY_DIR}"
    "-DSOURCE=${CMAKE_SOURCE_DIR}"
    "-DSCRATCH=${CMAKE_BINARY_DIR}/Testing/Packages"
    "-DPREFIX=${CMAKE_INSTALL_PREFIX}"
    "-DLIBRARY_DIRECTORY=${CMAKE_INSTALL_LIBDIR}"
    "-DVERSION=${PROJECT_VERSION}"
    "-DCONFIGURATION=$<CONFIG>"
    "-DGENERATOR=${CMAKE_GENERATOR}"
    "-DCXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DC_COMPILER=${CMAKE_C_COMPILER}"
    "-DCXX_FLAGS=${CMAKE_CXX_FLAGS}"
    "-DVTK_DIR=${VTK_DIR}"
    -P "${CMAKE_CURRENT_LIST_DIR}/RunPackages.cmake")
set_tests_properties(PackagesOfBuild PROPERTIES
  TIMEOUT 300
  SKIP_REGULAR_EXPRESSION "No packages can be made here")
