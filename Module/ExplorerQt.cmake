# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause

# The Explorer needs VTK's Qt widgets: the module, and its headers, which Debian packs by themselves.
function (temporal_coherence_find_qt result)
  find_package(VTK QUIET COMPONENTS CommonCore GUISupportQt PATHS "${VTK_DIR}" NO_DEFAULT_PATH)
  set(has_qt FALSE)
  if (TARGET VTK::GUISupportQt)
    get_target_property(directories VTK::CommonCore INTERFACE_INCLUDE_DIRECTORIES)
    # Since VTK 9.6 directories of headers are in file sets, not in the property.
    find_path(TEMPORAL_COHERENCE_QVTK QVTKOpenGLNativeWidget.h
      HINTS ${directories} "${VTK_PREFIX_PATH}/include"
      PATH_SUFFIXES "vtk-${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
    if (TEMPORAL_COHERENCE_QVTK)
      set(has_qt TRUE)
    endif ()
  endif ()
  set("${result}" "${has_qt}" PARENT_SCOPE)
endfunction ()
