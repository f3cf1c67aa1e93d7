# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# For programs that are not rebuilt: a library that VTK loads by itself where VTK_AUTOLOAD_PATH names
# its directory. It lies in a directory of its own, as VTK looks into every library that it finds there.

if (NOT BUILD_SHARED_LIBS)
  # A program with VTK inside has no use for a second one.
  return ()
endif ()

set(TEMPORAL_COHERENCE_AUTOLOAD_DIRECTORY "${CMAKE_INSTALL_LIBDIR}/vtkTemporalCoherence/autoload"
  CACHE STRING "Where the library for VTK_AUTOLOAD_PATH is installed, relative to the prefix")
set(autoload_directory "${TEMPORAL_COHERENCE_AUTOLOAD_DIRECTORY}")
file(RELATIVE_PATH autoload_to_library "/${autoload_directory}" "/${CMAKE_INSTALL_LIBDIR}")
add_library(vtkTemporalCoherenceAutoload MODULE "${CMAKE_CURRENT_LIST_DIR}/Autoload.cxx")
target_link_libraries(vtkTemporalCoherenceAutoload PRIVATE VTK::TemporalCoherence)
set_target_properties(vtkTemporalCoherenceAutoload PROPERTIES
  PREFIX ""
  LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${autoload_directory}"
  INSTALL_RPATH "$ORIGIN/${autoload_to_library}")
# VTK closes the library when the process ends, before the last mappers are deleted in Python.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux")
  target_link_options(vtkTemporalCoherenceAutoload PRIVATE LINKER:-z,nodelete)
endif ()
install(TARGETS vtkTemporalCoherenceAutoload
  LIBRARY DESTINATION "${autoload_directory}" COMPONENT runtime)
