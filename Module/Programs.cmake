# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The programs of Examples that are packages, too: the command temporal-coherence, and the Explorer as
# vtktemporalcoherence-explorer, with what a desktop wants to know of it. As projects of their own they
# are built against an installation; here, against the library of this build.
if (NOT TEMPORAL_COHERENCE_BUILD_PROGRAMS)
  return ()
endif ()
if (NOT BUILD_SHARED_LIBS)
  message(FATAL_ERROR
    "The programs are built with a shared VTK only; give -DTEMPORAL_COHERENCE_BUILD_PROGRAMS=OFF.")
endif ()

# Below /usr the system finds the library.
file(RELATIVE_PATH library_from_programs
  "/prefix/${CMAKE_INSTALL_BINDIR}" "/prefix/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN/${library_from_programs}")
if (CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(CMAKE_INSTALL_RPATH "")
endif ()
set(vtkTemporalCoherence_VERSION "${PROJECT_VERSION}")
set(program_targets temporal-coherence)
add_subdirectory("${CMAKE_SOURCE_DIR}/Examples/Command" Programs/Command)

include("${CMAKE_SOURCE_DIR}/Module/ExplorerQt.cmake")
temporal_coherence_find_qt(has_explorer)
if (has_explorer)
  list(APPEND program_targets Explorer ExplorerParts)
  add_subdirectory("${CMAKE_SOURCE_DIR}/Examples/Explorer" Programs/Explorer)
  set(explorer_name vtktemporalcoherence-explorer)
  set(explorer_files "${CMAKE_SOURCE_DIR}/Examples/Explorer/Desktop/${explorer_name}")
  set_target_properties(Explorer PROPERTIES OUTPUT_NAME "${explorer_name}")
  install(TARGETS Explorer DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT explorer)
  install(FILES "${explorer_files}.1"
    DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT explorer)
  install(FILES "${explorer_files}.desktop"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/applications" COMPONENT explorer)
  install(FILES "${explorer_files}.svg"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/icons/hicolor/scalable/apps" COMPONENT explorer)
  install(FILES "${explorer_files}.xml"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/mime/packages" COMPONENT explorer)
else ()
  message(STATUS "The Explorer is left out: there are no Qt widgets of VTK's (Debian: libvtk9-qt-dev)")
endif ()

list(APPEND program_targets ExamplesCommon ExamplesModel)
set(CMAKE_INSTALL_RPATH)
