# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The examples are for people who have the package and nothing else: this test builds and runs
# them against an installation of this build. Included by the directory of tests, where
# CMAKE_CURRENT_LIST_DIR is this one.

add_executable(CheckPicture "${CMAKE_CURRENT_LIST_DIR}/CheckPicture.cxx")
target_link_libraries(CheckPicture PRIVATE
  VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::IOImage)
target_compile_features(CheckPicture PRIVATE cxx_std_17)

add_test(NAME ExamplesAgainstInstall
  COMMAND "${CMAKE_COMMAND}"
    "-DBUILD=${CMAKE_BINARY_DIR}"
    "-DCONFIGURATION=$<CONFIG>"
    "-DEXAMPLES=${CMAKE_CURRENT_LIST_DIR}/../Examples"
    "-DSCRATCH=${CMAKE_BINARY_DIR}/Testing/Examples"
    "-DCHECK_PICTURE=$<TARGET_FILE:CheckPicture>"
    "-DGENERATOR=${CMAKE_GENERATOR}"
    "-DCXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DC_COMPILER=${CMAKE_C_COMPILER}"
    "-DCXX_FLAGS=${CMAKE_CXX_FLAGS}"
    "-DVTK_DIR=${VTK_DIR}"
    -P "${CMAKE_CURRENT_LIST_DIR}/RunExamples.cmake")
# Building two programs takes most of it.
set_tests_properties(ExamplesAgainstInstall PROPERTIES TIMEOUT 600)
