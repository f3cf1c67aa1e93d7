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

include("${CMAKE_CURRENT_LIST_DIR}/../Module/ExplorerQt.cmake")
temporal_coherence_find_qt(has_explorer)

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
    "-DHAS_EXPLORER=${has_explorer}"
    -P "${CMAKE_CURRENT_LIST_DIR}/RunExamples.cmake")
# Building three programs takes most of it.
set_tests_properties(ExamplesAgainstInstall PROPERTIES TIMEOUT 900 FIXTURES_SETUP BuiltExamples)

# The Explorer that was built there, used by mouse and keys, on screens of both kinds.
find_package(X11)
if (NOT has_explorer)
  temporal_coherence_skip_test(ExplorerByHand
    "there are no Qt widgets of VTK's (Debian's package libvtk9-qt-dev)")
elseif (X11_FOUND)
  add_executable(DropFile "${CMAKE_CURRENT_LIST_DIR}/Explorer/DropFile.cxx")
  target_include_directories(DropFile PRIVATE ${X11_INCLUDE_DIR})
  target_link_libraries(DropFile PRIVATE ${X11_X11_LIB})
  target_compile_features(DropFile PRIVATE cxx_std_17)
  add_test(NAME ExplorerByHand
    COMMAND "${CMAKE_CURRENT_LIST_DIR}/Explorer/run.sh"
      "${CMAKE_BINARY_DIR}/Testing/Examples/Explorer/Explorer" "$<TARGET_FILE:CheckPicture>"
      "$<TARGET_FILE:DropFile>" "${CMAKE_BINARY_DIR}/Testing/Explorer")
  add_test(NAME ExplorerAt192Dpi
    COMMAND "${CMAKE_CURRENT_LIST_DIR}/Explorer/run.sh"
      "${CMAKE_BINARY_DIR}/Testing/Examples/Explorer/Explorer" "$<TARGET_FILE:CheckPicture>"
      "$<TARGET_FILE:DropFile>" "${CMAKE_BINARY_DIR}/Testing/Explorer192" 192)
  # Model and widgets, by simulated events.
  add_test(NAME ExplorerParts
    COMMAND "${CMAKE_BINARY_DIR}/Testing/Examples/Explorer/ExplorerTests")
  set_tests_properties(ExplorerParts PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED: ")
  set_tests_properties(ExplorerByHand ExplorerAt192Dpi ExplorerParts
    PROPERTIES TIMEOUT 900 FIXTURES_REQUIRED BuiltExamples)
else ()
  temporal_coherence_skip_test(ExplorerByHand "mouse and keys are those of X11, which is not there")
endif ()
