# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Broken files, opened by the examples' own parts. Included by the directory of tests, where
# CMAKE_CURRENT_LIST_DIR is this one.
if (NOT UNIX)
  temporal_coherence_skip_test(Files-Cxx "each file takes a process of its own, as Unix makes them")
  return ()
endif ()
set(examples "${CMAKE_CURRENT_LIST_DIR}/../Examples")
add_subdirectory("${examples}/Common" Files/ExamplesCommon)
add_subdirectory("${examples}/Common/Model" Files/ExamplesModel)

# The programs have headers of the same names, so each way has a library of its own.
add_library(DrawInExplorer STATIC "${CMAKE_CURRENT_LIST_DIR}/Files/DrawInExplorer.cxx")
target_link_libraries(DrawInExplorer PUBLIC ExamplesModel)
add_library(DrawInOrbitAndSweep STATIC
  "${CMAKE_CURRENT_LIST_DIR}/Files/DrawInOrbitAndSweep.cxx"
  "${examples}/OrbitAndSweep/Extraction.cxx"
  "${examples}/OrbitAndSweep/Scene.cxx")
target_include_directories(DrawInOrbitAndSweep PRIVATE "${examples}/OrbitAndSweep")
add_executable(OpenFiles "${CMAKE_CURRENT_LIST_DIR}/Files/OpenFiles.cxx")
foreach (library IN ITEMS DrawInExplorer DrawInOrbitAndSweep)
  target_link_libraries("${library}" PUBLIC ExamplesCommon VTK::TemporalCoherence)
  vtk_module_autoinit(TARGETS "${library}" MODULES ${VTK_LIBRARIES})
  target_link_libraries(OpenFiles PRIVATE "${library}")
endforeach ()

# A few broken files of each format; run.sh opens as many as one likes.
find_package(Python3 COMPONENTS Interpreter)
if (Python3_Interpreter_FOUND)
  add_test(NAME Files-Cxx
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/Files/fuzz_files.py"
      --opener "$<TARGET_FILE:OpenFiles>" --count 3
      --scratch "${CMAKE_BINARY_DIR}/Testing/Files/cxx")
  foreach (test IN ITEMS files large nrrd series stacks)
    add_test(NAME "Files-Read-${test}"
      COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/Files/read_${test}.py"
        "$<TARGET_FILE:OpenFiles>")
  endforeach ()
else ()
  temporal_coherence_skip_test(Files-Cxx "there is no Python, which breaks the files")
endif ()
